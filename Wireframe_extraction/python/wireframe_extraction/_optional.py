"""Libraries that are imported when they are asked for."""

from __future__ import annotations

import importlib
from typing import Any


def import_optional(module: str, purpose: str) -> Any:
    """Return a module.

    Raises
    ------
    ImportError
        If it is missing; the message says what it is needed for, and how to get it.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        library = module.partition(".")[0]
        raise ImportError(f"{purpose} needs {library}, which is not installed or does not work ({error}); install it "
                          f"with: pip install {library}", name=library) from error
