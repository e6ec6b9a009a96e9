"""Messages of the library in the words of Python."""

from __future__ import annotations

import os
import re
from typing import Any

# the library speaks of its C++ parameters, and the readers of meshes of options of the tool
_REPLACEMENTS = (
    (r"(skip_invalid|clamp_negative)\(true\)", r"\1=True"),
    (r"--(mesh|field) (cad|scan|given|estimated)", r'\1="\2"'),
    (r"--(\w+(?:-\w+)*)", lambda match: match[1].replace("-", "_")),
)


def as_text(path: Any) -> str:
    """Return the name of a file as messages have it: bytes that are no UTF-8 stand there as ``\\xff``."""
    return os.fsencode(path).decode("utf-8", "backslashreplace")


def in_python(text: str, *paths: Any) -> str:
    """Return a message with the names that parameters have here; those of files stay as they are."""
    names = sorted({as_text(path) for path in paths}, key=len, reverse=True)
    if not names:
        return _replaced(text)
    # at odd places there are names
    pieces = re.split("(" + "|".join(map(re.escape, names)) + ")", text)
    return "".join(piece if i % 2 else _replaced(piece) for i, piece in enumerate(pieces))


def _replaced(text: str) -> str:
    for pattern, replacement in _REPLACEMENTS:
        text = re.sub(pattern, replacement, text)   # type: ignore[call-overload]
    return text
