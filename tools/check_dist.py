"""Build the wheel and the source distribution, and use the wheel where nothing else of the project is.

The wheel goes into an empty environment in a temporary folder. There run every command's ``--help``, jobs
that need the data and the shaders of the package, and, with the ``demo`` extra, the code of the README. The
two files are left in dist/ if all went well; what is missing or fails is said in one line.
"""

import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import time
import tomllib
import venv
import zipfile
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]
BUILT = ROOT / "dist"
CACHES = {"__pycache__", ".DS_Store"}
ALWAYS = {".gitignore", "LICENSE", "PKG-INFO", "README.md", "pyproject.toml"}
"""What every source distribution has besides the files that pyproject.toml lists."""
ENGINES = ("threejs", "godot", "unity", "unreal", "blender", "glsl", "hlsl", "wgsl", "osl", "ktx2", "atlas")
JOBS = (
    "texture photo.png -o set --tile-size 32",
    "render set -o plane.png --width 300 --height 200",
    "view set -o page.html",
    "points --count 10000 -o points.npy",
    "points --method penrose --count 500 -o penrose.csv",
    "aperiodic jeandel-rao-24 -o never.svg",
    *(f"export set --to {engine} -o {engine}" for engine in ENGINES),
    "export set --to array -o array.png",
)
PHOTO = """
import numpy as np
import tilewright as tw
tw.write_image("photo.png", np.random.default_rng(1).integers(0, 256, (96, 96, 3)).astype(np.uint8))
"""
READY_TILES = """
import tilewright as tw
for colors, points, rho in ((4, 32, 0.75), (4, 32, 0.70), (3, 32, 0.75), (4, 64, 0.75), (6, 32, 0.70)):
    assert len(tw.ready_tiles(colors, points, rho).tiles) == colors**4
"""
VERSIONS = """
import importlib.metadata
import tilewright as tw
assert tw.__version__ == importlib.metadata.version("tilewright")
print(tw.__version__, tw.__file__)
"""


class Missing(Exception):
    """One line that says what is not as it should be."""


def main() -> None:
    """Build, look into both files, install, use."""
    with tempfile.TemporaryDirectory(prefix="tilewright-dist-") as name:
        folder = Path(name).resolve()
        with step("build"):
            wheel, source = build(folder / "dist")
        with step("what is in the two files"):
            check_source(source)
            check_wheel(wheel)
        with step("install the wheel into an empty environment"):
            away = Away.make(folder, wheel)
        with step("it is that wheel which runs, of one version"):
            check_version(away, wheel)
        with step("every command's --help"):
            for command in away.commands():
                away.run(away.program, command, "--help")
        with step("a photograph, of noise"):
            away.run(away.python, "-c", PHOTO)
        for job in JOBS:
            with step(f"tilewright {job}"):
                away.do(job)
        with step("ready tiles"):
            away.run(away.python, "-c", READY_TILES)
        with step("install the demo extra"):
            away.install(f"{wheel}[demo]")
        for number, block in enumerate(python_blocks(ROOT / "README.md"), 1):
            with step(f"the README's code, part {number}"):
                away.run(away.python, "-W", "error", "-c", block)
        BUILT.mkdir(exist_ok=True)
        print(*(shutil.copy(built, BUILT) for built in (wheel, source)), sep="\n")


def build(target: Path) -> tuple[Path, Path]:
    """The source distribution, and the wheel made from it."""
    call([sys.executable, "-m", "build", "--outdir", str(target), str(ROOT)], ROOT)
    return next(target.glob("*.whl")), next(target.glob("*.tar.gz"))


def check_source(path: Path) -> None:
    """All that is needed to build and test is in it, and nothing else."""
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["hatch"]["build"]["targets"][
        "sdist"
    ]
    wanted = set(ALWAYS)
    for name in settings["only-include"]:
        wanted |= {str(file.relative_to(ROOT)) for file in files_below(ROOT / name)}
    with tarfile.open(path) as archive:
        found = {member.name.partition("/")[2] for member in archive if member.isfile()}
    compare(path, found, wanted)


def check_wheel(path: Path) -> None:
    """Each file of the package is in it."""
    package = ROOT / "src"
    wanted = {str(file.relative_to(package)) for file in files_below(package / "tilewright")}
    with zipfile.ZipFile(path) as archive:
        found = {name for name in archive.namelist() if ".dist-info/" not in name}
    compare(path, found, wanted)


def files_below(path: Path) -> Iterator[Path]:
    """A file itself; all files of a folder, without caches."""
    if not path.exists():
        raise Missing(f"{path.relative_to(ROOT)} is not in the checkout")
    found = [path] if path.is_file() else path.rglob("*")
    yield from (file for file in found if file.is_file() and not CACHES & set(file.parts))


def compare(path: Path, found: set[str], wanted: set[str]) -> None:
    """Both hold the same names."""
    if wanted - found:
        raise Missing(f"{path.name} lacks {', '.join(sorted(wanted - found))}")
    if found - wanted:
        raise Missing(f"{path.name} holds what it should not: {', '.join(sorted(found - wanted))}")


class Away:
    """An environment that knows nothing of the checkout, and an empty folder to work in."""

    def __init__(self, programs: Path, work: Path) -> None:
        self.python, self.program, self.work = programs / "python", programs / "tilewright", work

    @classmethod
    def make(cls, folder: Path, wheel: Path) -> "Away":
        """With the wheel and what it asks for."""
        venv.create(folder / "venv", with_pip=True)
        (folder / "work").mkdir()
        away = cls(folder / "venv" / ("Scripts" if os.name == "nt" else "bin"), folder / "work")
        away.install(str(wheel))
        return away

    def install(self, what: str) -> None:
        """Through pip."""
        # Without compiling: most modules are never imported here.
        options = ("--quiet", "--no-compile", "--disable-pip-version-check")
        self.run(self.python, "-m", "pip", "install", *options, what)

    def run(self, *command: object) -> str:
        """What a program prints."""
        return call([str(part) for part in command], self.work)

    def commands(self) -> list[str]:
        """The names of all commands, from the program's own help."""
        listed = self.run(self.program, "--help").partition("Commands:")[2]
        names = re.findall(r"^  (\w+)", listed, re.MULTILINE)
        if len(names) < 12:
            raise Missing(f"tilewright --help lists only {names}")
        return names

    def do(self, job: str) -> None:
        """A job of the program, and what it must have written."""
        words = job.split()
        self.run(self.program, *words)
        made = self.work / words[words.index("-o") + 1]
        if not made.exists() or (made.is_dir() and not any(made.iterdir())) or made.stat().st_size == 0:
            raise Missing(f"`tilewright {job}` wrote no {made.name}")


def check_version(away: Away, wheel: Path) -> None:
    """The package, its metadata, the program and the wheel's name agree, and none is of the checkout."""
    version, _, home = away.run(away.python, "-c", VERSIONS).strip().partition(" ")
    if not Path(home).resolve().is_relative_to(away.work.parent):
        raise Missing(f"tilewright was imported from {home}")
    said = away.run(away.program, "--version").strip()
    if said != f"tilewright {version}" or wheel.name.split("-")[1] != version:
        raise Missing(f"the package is {version}, the program says {said}, and the wheel is {wheel.name}")


def python_blocks(page: Path) -> list[str]:
    """The code of a page."""
    return re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)


def call(command: list[str], folder: Path) -> str:
    """Run to the end without this environment's own packages; what it printed."""
    clean = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    done = subprocess.run(command, cwd=folder, env=clean, capture_output=True, text=True)
    if done.returncode != 0:
        complaint = (done.stderr.strip() or done.stdout.strip() or "it said nothing").splitlines()[-1]
        shown = " ".join(command[1:] if Path(command[0]).stem == "python" else command).splitlines()
        raise Missing(f"`{next(filter(None, shown))}` ended with {done.returncode}: {complaint}")
    return done.stdout


class step:
    """Prints what is done and how long it took."""

    def __init__(self, what: str) -> None:
        self.what = what

    def __enter__(self) -> None:
        self.started = time.perf_counter()

    def __exit__(self, failed: object, *rest: object) -> None:
        if failed is None:
            print(f"{time.perf_counter() - self.started:6.1f} s  {self.what}", flush=True)


if __name__ == "__main__":
    try:
        main()
    except Missing as error:
        sys.exit(f"dist: {error}")
