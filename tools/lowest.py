"""Try the lowest versions of the dependencies that pyproject.toml allows.

Makes an empty environment with the Python this runs in, which must be the lowest that is allowed, installs
the project and its ``test`` extra with every dependency at its lower bound, and runs tests there that between
them use every dependency. ``--list`` prints the versions, in the form of pip's constraints, and ends.
"""

import argparse
import re
import subprocess
import sys
import tempfile
import tomllib
import venv
from pathlib import Path

ROOT = Path(__file__).parents[1]
EXTRA = "test"
# Quick files that use numba, SciPy, OpenImageIO and tifffile, msgspec, typer, matplotlib, pyarrow, finufft,
# python-sat, wgpu, ezdxf, pypdf, pypdfium2, imageio-ffmpeg and trimesh; they are looked for in all folders of
# tests/.
TESTS = (
    "test_hashes.py",
    "test_mincut.py",
    "test_images.py",
    "test_tileset_folder.py",
    "test_cli.py",
    "test_analysis.py",
    "test_point_files.py",
    "test_point_spectra.py",
    "test_dappled_solving.py",
    "test_gpu_refusals.py",
    "test_drawing_files.py",
    "test_flow_pictures.py",
    "test_mesh_files.py",
)
SLOW = "not point_tiles_come_back"


def main() -> None:
    """List the lowest versions, or install and test them."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--list", action="store_true", help="print the versions and end")
    given = parser.parse_args()
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"]
    bounds = lower_bounds([*project["dependencies"], *requirements_of(EXTRA, extras)])
    if given.list:
        print("\n".join(bounds))
        return
    check_python(project["requires-python"])
    with tempfile.TemporaryDirectory(prefix="tilewright-lowest-") as folder:
        python = install(Path(folder), bounds)
        sys.exit(run_tests(python))


def requirements_of(extra: str, extras: dict[str, list[str]]) -> list[str]:
    """What an extra asks for, with that of the project's other extras which it names."""
    found = []
    for requirement in extras[extra]:
        match = re.fullmatch(r"tilewright\[([\w,]+)\]", requirement)
        named = match[1].split(",") if match else []
        found += (
            [part for name in named for part in requirements_of(name, extras)] if match else [requirement]
        )
    return found


def lower_bounds(requirements: list[str]) -> list[str]:
    """``name>=version`` as ``name==version``, each once."""
    found = {}
    for requirement in requirements:
        match = re.fullmatch(r"([\w.-]+)>=([\w.]+)", requirement)
        if match is None:
            sys.exit(f"lowest: {requirement!r} is not of the form name>=version")
        found[match[1]] = f"{match[1]}=={match[2]}"
    return [found[name] for name in sorted(found)]


def check_python(allowed: str) -> None:
    """The lowest Python is a lower bound too."""
    running = "{}.{}".format(*sys.version_info)
    if allowed != f">={running}":
        sys.exit(f"lowest: this is Python {running}; the lowest allowed is {allowed.removeprefix('>=')}")


def install(folder: Path, bounds: list[str]) -> Path:
    """An environment with the project and the lowest versions; its interpreter."""
    (folder / "lowest.txt").write_text("\n".join(bounds) + "\n")
    venv.create(folder / "venv", with_pip=True)
    python = folder / "venv" / ("Scripts" if sys.platform == "win32" else "bin") / "python"
    constrained = ["--constraint", str(folder / "lowest.txt"), f"{ROOT}[{EXTRA}]"]
    subprocess.run([python, "-m", "pip", "install", "--quiet", *constrained], check=True)
    print("Installed", *bounds, flush=True)
    return python


def run_tests(python: Path) -> int:
    """The chosen tests; how pytest ended."""
    files = []
    for name in TESTS:
        found = sorted((ROOT / "tests").rglob(name))
        if not found:
            sys.exit(f"lowest: there is no {name} in tests/")
        files += found
    # Old releases use what newer releases of their own dependencies deprecate; that is not ours to mend.
    relaxed = ["-W", "ignore::DeprecationWarning"]
    command = [python, "-m", "pytest", "-p", "no:cacheprovider", *relaxed, "-k", SLOW, *files]
    return subprocess.run(command, cwd=ROOT).returncode


if __name__ == "__main__":
    main()
