"""What the name of a file tells: which map it is, and of which material."""

import re
from collections.abc import Sequence
from typing import NamedTuple

from tilewright.pixels import MAP_WORDS

_SIZE = re.compile(r"\d+k|[1-9]\d{2,4}(x\d{3,5})?|png|jpg|exr|tif|lod\d|\d+bit|var\d+")
_WORKFLOWS = ("metalness", "metallic", "specular")
"""For which way of shading maps were made, which some shops put at the end of all their names."""
_PREFIXES = ("t", "tx", "tex", "m", "mi")
"""What Unreal's projects put before the names of textures and materials."""
_ENDINGS = {ending.replace("_", ""): name for name, known in MAP_WORDS.items() for ending in known.endings}
_LONGEST = 4
"""Words of an ending: ``Ambient_Occlusion_Map``."""
_SHORT = {
    **{"bc": "albedo", "d": "albedo", "a": "albedo", "n": "normal", "r": "roughness"},
    **{"mt": "metalness", "m": "metalness", "s": "specular", "h": "height", "o": "ao", "e": "emissive"},
}
"""Unreal's endings of a letter or two, the surer one first where two say the same."""


class MapName(NamedTuple):
    """What a name tells.

    Attributes
    ----------
    map : str or None
        Which map; None where the name does not say it.
    material : str
        The words before, by which files of one material are told; all words where there is no map.
    """

    map: str | None
    material: str


def name_maps(stems: Sequence[str]) -> list[MapName]:
    """What the names of a folder's files tell, without their suffixes, each read beside the others."""
    lists = _without_shared_ends([_words(stem) for stem in stems])
    names = [_name(words) for words in lists]
    short = _find_short(names, lists)
    return [short.get(n, name) for n, name in enumerate(names)]


def recognize_map(stem: str) -> str | None:
    """Which map a file of this name is, None where it does not say: ``Moss002_2K-PNG_NormalGL``."""
    return _name(_words(stem)).map


def material_of(name: str) -> str:
    """What `MapName.material` is for files whose names begin with this one."""
    return _material(_words(name))


def _words(stem: str) -> list[str]:
    """Words in small letters: ``wall_AOMap`` has wall, ao and map."""
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", stem)
    return [w for w in re.split(r"[^a-z0-9]+", spaced.lower()) if w]


def _without_shared_ends(lists: list[list[str]]) -> list[list[str]]:
    """Names without the words at which all of them end, as these tell no file from another."""
    while len(lists) > 1 and all(len(words) > 1 and words[-1] == lists[0][-1] for words in lists):
        last = lists[0][-1]
        if last in _ENDINGS and last not in _WORKFLOWS:
            break
        lists = [words[:-1] for words in lists]
    return lists


def _name(words: list[str]) -> MapName:
    words = _without_sizes(words)
    for length in range(min(_LONGEST, len(words)), 0, -1):
        ending, before = "".join(words[-length:]), words[:-length]
        for told in (ending, ending.removesuffix("map"), ending.removesuffix("texture")):
            if told in _ENDINGS:
                return MapName(_ENDINGS[told], _material(before))
    return MapName(None, _material(words))


def _without_sizes(words: list[str]) -> list[str]:
    """Words up to the last that is no size, nor the workflow after a map's: ``COL_2K_METALNESS``."""
    while words:
        after_size = words[-1] in _WORKFLOWS and len(words) > 2 and _SIZE.fullmatch(words[-2])
        if not (_SIZE.fullmatch(words[-1]) or (after_size and _name(words[:-1]).map)):
            break
        words = words[:-1]
    return words


def _material(words: list[str]) -> str:
    kept = [word for word in words if not _SIZE.fullmatch(word)]
    while kept and kept[0] in _PREFIXES:
        kept = kept[1:]
    return " ".join(kept)


def _find_short(names: list[MapName], lists: list[list[str]]) -> dict[int, MapName]:
    """Files told by a letter or two, where files of the same words show that it stands for a map.

    Letters count beside a map that is told by a whole word, or beside normals (``_N``), and where no file of
    these words ends in a letter that stands for none: ``photo_a`` to ``photo_e`` are photographs.
    """
    found: dict[int, MapName] = {}
    ends: dict[str, dict[str, int]] = {}
    for n, (name, words) in enumerate(zip(names, lists, strict=True)):
        words = _without_sizes(words)
        if name.map is None and len(words) > 1 and (len(words[-1]) == 1 or words[-1] in _SHORT):
            ends.setdefault(_material(words[:-1]), {})[words[-1]] = n
    for material, letters in ends.items():
        told = {name.map for name in names if name.map is not None and name.material == material}
        if not letters.keys() <= _SHORT.keys() or not (told or ("n" in letters and len(letters) > 1)):
            continue
        for letter in (letter for letter in _SHORT if letter in letters):
            if _SHORT[letter] not in told:  # else it stands for something else
                told.add(_SHORT[letter])
                found[letters[letter]] = MapName(_SHORT[letter], material)
    return found
