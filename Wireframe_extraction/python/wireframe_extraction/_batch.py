"""The wireframes of many clouds."""

from __future__ import annotations

import os
import threading
from collections import deque
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any, Iterable, Sized

import numpy as np

from . import _arrays, _numbers, _parameters
from ._extraction import extracted
from ._report import Report, texts_of_warnings, warn
from ._wireframe import Wireframe


class _Stopped(Exception):
    """Raised within extractions that are no longer wanted."""


def _number_of_processors() -> int:
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


@_parameters.listed(_parameters.EXTRACTION, _parameters.MESH, _parameters.READING)
def extract_many(clouds: Iterable[Any], *, jobs: int | None = None, threads: int | None = None, errors: str = "raise",
                 progress: Any = None, **parameters: Any) -> list[Any]:
    """Extract the wireframes of many clouds, some at the same time.

    They run in threads of this process: no array is copied for them, and all processors are used.

    Parameters
    ----------
    clouds : iterable
        What `extract()` takes as `points`: arrays, or names of files; or pairs of points and distances. From a
        generator, clouds are taken when there is a thread for them.
    jobs : int, optional
        How many at the same time; as many as there are processors if it is not given.
    threads : int, optional
        The largest number of threads for each; such that they share the processors if it is not given.
    errors : {"raise", "return"}
        What becomes of a cloud that has none: its exception is raised once the clouds before it are done, and the
        others are stopped; or it stands in the place of the wireframe, and the others go on.
    progress : callable, optional
        Called with the share of the clouds that are done, from 0 to 1, in the thread that called; of a generator, whose
        length nobody knows, at the end only.
    **parameters
        Those of `extract()`, the same for all clouds.

    Returns
    -------
    list of Wireframe
        In the order of the clouds.

    Raises
    ------
    OSError, TypeError, ValueError
        As of `extract()`; messages of the latter begin with ``clouds[3]:`` or the like.

    Warns
    -----
    ExtractionWarning
        As of `extract()`, with the same beginning.
    """
    if errors not in ("raise", "return"):
        raise ValueError(f"errors is {errors!r}; it has to be 'raise' or 'return'")
    _check_clouds(clouds)
    _parameters.checked(extract_many, parameters, {**_parameters.EXTRACTION, **_parameters.OF_CLOUDS})
    progress = _parameters.checked_progress(progress)
    number_of_jobs = _number_of_processors() if jobs is None else _numbers.integer("jobs", jobs, 1, 1024)
    if threads is None:
        threads = max(1, _number_of_processors() // number_of_jobs)
    threads = _parameters.checked_threads(threads)
    is_stopped = threading.Event()

    def check(share: float) -> None:
        if is_stopped.is_set():
            raise _Stopped

    def work(cloud: Any) -> tuple[Wireframe, Report]:
        points, distances = cloud if isinstance(cloud, tuple) and len(cloud) == 2 else (cloud, None)
        return extracted(extract_many, points, distances, None, None, threads, check, parameters)

    running: deque[Future[tuple[Wireframe, Report]]] = deque()
    results: list[Any] = []
    total = len(clouds) if isinstance(clouds, Sized) else None
    with ThreadPoolExecutor(number_of_jobs, "wireframe_extraction") as pool:
        def take() -> None:
            results.append(_outcome(running.popleft(), len(results), errors))
            if progress is not None and total:
                progress(len(results) / total)

        try:
            for cloud in clouds:
                while len(running) >= 2 * number_of_jobs:   # one in waiting for each that runs
                    take()
                running.append(pool.submit(work, cloud))
            while running:
                take()
        finally:   # whatever happened, also Ctrl-C: what has not begun never does, and the rest ends soon
            is_stopped.set()
            for future in running:
                future.cancel()
    if progress is not None and total is None:
        progress(1.0)
    return results


def _outcome(future: Future[tuple[Wireframe, Report]], index: int, errors: str) -> Any:
    """Return a wireframe, or the error in its place; warn of what the report has."""
    error = future.exception()
    if error is None:
        wireframe, report = future.result()
        warn([f"clouds[{index}]: {text}" for text in texts_of_warnings(report)], stacklevel=5)
        return wireframe
    if type(error) in (TypeError, ValueError):
        error = type(error)(f"clouds[{index}]: {error}").with_traceback(error.__traceback__)
    if errors == "raise":
        raise error
    return error


def _check_clouds(clouds: Any) -> None:
    """Refuse what is a single cloud."""
    if isinstance(clouds, (str, bytes, os.PathLike)):
        raise TypeError("clouds is a single name; give a list of them, or use extract()")
    if _arrays.is_pair(clouds):
        raise TypeError("clouds is a pair of points and distances; give a list of such pairs, or use extract()")
    if isinstance(clouds, np.ndarray) and clouds.ndim < 3:
        raise TypeError("clouds is a single array; give a list of them, or use extract()")
