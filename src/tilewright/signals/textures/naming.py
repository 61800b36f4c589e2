"""What maps may be called: their names become those of folders and files, on any system."""

import re
from collections.abc import Iterable
from typing import Any

from tilewright.errors import TilewrightValueError

LONGEST_NAME = 100
_RESERVED = '<>:"/\\|?*'
_DEVICES = re.compile(r"(con|prn|aux|nul|conin\$|conout\$|(com|lpt)[0-9¹²³])(\..*)?", re.IGNORECASE)


def check_map_names(names: Iterable[Any]) -> None:
    """Raise unless every map can have a folder of its own, beside the others', on any system.

    Windows keeps names of devices for these; it and macOS take names that differ only in small and capital
    letters for one (Microsoft, "Naming Files, Paths, and Namespaces").

    Raises
    ------
    TilewrightValueError
        A name that is none, or two that some systems take for one.
    """
    seen: dict[str, str] = {}
    for name in names:
        if not (isinstance(name, str) and name.isprintable() and 1 <= len(name.encode()) <= LONGEST_NAME):
            raise TilewrightValueError(
                f"a map is named {str(name)[:80]!a}; a name is a text of 1 to {LONGEST_NAME} bytes, of "
                "letters, digits and other characters that can be printed",
                value=name,
            )
        if _DEVICES.fullmatch(name):
            raise _unfit(name, "Windows keeps that name for a device")
        other = seen.setdefault(name.casefold(), name)
        if other != name:
            raise TilewrightValueError(
                f"two maps are named {other!r} and {name!r}, which is one folder on Windows and macOS",
                value=name,
                advice="give one another name",
            )


def check_new_names(names: Iterable[str], beside: Iterable[str] = ()) -> None:
    """Raise unless maps may be called so from now on, beside those that are there.

    Stricter than `check_map_names`: in files, characters that Windows reserves, and dots and blanks at the
    end, become underscores, so that sets with such names can be read; new ones are named as they will be.

    Raises
    ------
    TilewrightValueError
        A name that no folder has on Windows, or that differs only by case from another.
    """
    names = list(names)
    check_map_names([*dict.fromkeys([*beside, *names])])
    for name in names:
        reserved = [c for c in name if c in _RESERVED]
        if reserved:
            raise _unfit(name, f"none has {reserved[0]!r} in it on Windows")
        if name[-1] in ". ":
            raise _unfit(name, "none ends in a dot or a blank on Windows")


def _unfit(name: str, reason: str) -> TilewrightValueError:
    return TilewrightValueError(
        f"a map is named {name!r}, and folders are named after maps: {reason}",
        value=name,
        advice="give it another name",
    )
