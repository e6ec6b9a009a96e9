"""The wireframes of many clouds."""

from __future__ import annotations

import os
import threading
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any, Iterable

from . import _numbers
from ._extraction import extract
from ._wireframe import Wireframe


class _Stopped(Exception):
    """Raised within extractions that are no longer wanted."""


def _number_of_processors() -> int:
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def extract_many(clouds: Iterable[Any], *, jobs: int | None = None, threads: int | None = None, errors: str = "raise",
                 progress: Any = None, **parameters: Any) -> list[Any]:
    """Extract the wireframes of many clouds, some at the same time.

    They run in threads of this process: no array is copied for them, and all processors are used.

    Parameters
    ----------
    clouds : iterable
        What `extract()` takes as `points`: arrays, or names of files; or pairs of points and distances.
    jobs : int, optional
        How many at the same time; as many as there are processors if it is not given.
    threads : int, optional
        The largest number of threads for each; such that they share the processors if it is not given.
    errors : {"raise", "return"}
        What becomes of a cloud that has none: its exception is raised once the clouds before it are done, and the
        others are stopped; or it stands in the place of the wireframe, and the others go on.
    progress : callable, optional
        Called with the share of the clouds that are done, from 0 to 1, in the thread that called.
    **parameters
        Those of `extract()`, the same for all clouds.

    Returns
    -------
    list of Wireframe
        In the order of the clouds.

    Raises
    ------
    TypeError, ValueError
        As of `extract()`.
    """
    if errors not in ("raise", "return"):
        raise ValueError(f"errors is {errors!r}; it has to be 'raise' or 'return'")
    if isinstance(clouds, (str, bytes, os.PathLike)):
        raise TypeError("clouds is a single name; give a list of them, or use extract()")
    number_of_jobs = _number_of_processors() if jobs is None else _numbers.integer("jobs", jobs, 1, 1024)
    if threads is None:
        threads = max(1, _number_of_processors() // number_of_jobs)
    inputs = [_arguments(cloud) for cloud in clouds]
    is_stopped = threading.Event()

    def check(share: float) -> None:
        if is_stopped.is_set():
            raise _Stopped

    with ThreadPoolExecutor(number_of_jobs, "wireframe_extraction") as pool:
        futures = [pool.submit(extract, *arguments, threads=threads, progress=check, **parameters)
                   for arguments in inputs]
        try:
            return _gathered(futures, errors, progress)
        finally:   # whatever happened, also Ctrl-C: what has not begun never does, and the rest ends soon
            is_stopped.set()
            for future in futures:
                future.cancel()


def _gathered(futures: list[Future[Wireframe]], errors: str, progress: Any) -> list[Any]:
    results: list[Any] = []
    for future in futures:
        error = future.exception()
        if error is not None and errors == "raise":
            raise error
        results.append(future.result() if error is None else error)
        if progress is not None:
            progress(len(results) / len(futures))
    return results


def _arguments(cloud: Any) -> tuple[Any, ...]:
    """Return points, and distances if there is a pair of both."""
    return tuple(cloud) if isinstance(cloud, tuple) and len(cloud) == 2 else (cloud,)
