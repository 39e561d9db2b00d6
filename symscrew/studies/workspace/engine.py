"""Where the pieces of a sweep run: in processes of this machine, or on a Dask cluster. The results are the same.

Only the caller writes: a piece that runs twice, because its worker died, is stored once.
"""

from __future__ import annotations

import multiprocessing
import os
from collections.abc import Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, wait
from concurrent.futures.process import BrokenProcessPool

import numpy as np

from symscrew.errors import DescriptionError
from symscrew.studies.workspace.evaluation import evaluate, prepare_sweep
from symscrew.studies.workspace.plan import Plan
from symscrew.workers import pool

Results = dict[str, np.ndarray]
RESTARTS = 3  # of the pool when a worker dies (memory); more would hide what kills it every time


def run_locally(plan: Plan, chunks: Iterable[int], processes: int | None = None) -> Iterator[tuple[int, Results]]:
    """(number, results) of the pieces as they are done, on all cores.

    The model is compiled before the processes start; they have it from their parent where the system can fork.
    Pieces of a process that dies are given to a new pool, three times at most.
    """
    left = list(chunks)
    device = prepare_sweep(plan).engine.device  # which one process keeps busy, and cannot hand to its copies
    count = 1 if device else min(processes or os.cpu_count() or 1, len(left))
    if count <= 1:
        for chunk in left:
            yield chunk, evaluate(plan, chunk)
        return
    method = "fork" if "fork" in multiprocessing.get_all_start_methods() else "spawn"
    for attempt in range(RESTARTS + 1):
        try:
            for chunk, results in _pooled(plan, left, count, method):
                left.remove(chunk)
                yield chunk, results
            return
        except BrokenProcessPool:
            if attempt == RESTARTS:
                raise


def _pooled(plan: Plan, chunks: list[int], count: int, method: str) -> Iterator[tuple[int, Results]]:
    """A few pieces more than processes at a time, so that memory does not grow with the sweep."""
    with pool(count, method) as processes:
        waiting = iter(list(chunks))
        running: dict[Future[Results], int] = {}
        try:
            while True:
                for chunk in waiting:
                    running[processes.submit(evaluate, plan, chunk)] = chunk
                    if len(running) >= 3 * count:
                        break
                if not running:
                    return
                done, _ = wait(running, return_when=FIRST_COMPLETED)
                for future in done:
                    yield running.pop(future), future.result()
        finally:
            for future in running:
                future.cancel()


def run_on_dask(plan: Plan, chunks: Iterable[int], scheduler: str) -> Iterator[tuple[int, Results]]:
    """(number, results) of the pieces as they are done, on the cluster with this scheduler's address.

    Raises:
        DescriptionError: Dask is not installed, or there is no scheduler at this address.
    """
    try:
        from distributed import Client, as_completed
    except ImportError as error:
        raise DescriptionError('--dask needs Dask, which is not installed: pip install "symscrew[dask]"') from error
    prepare_sweep(plan)
    try:
        client = Client(scheduler, timeout="10s", set_as_default=False)
    except (OSError, ValueError) as error:
        raise DescriptionError(
            f"--dask: no scheduler answers at {scheduler}; start one with `dask scheduler`"
        ) from error
    with client:
        waiting = iter(list(chunks))
        numbers: dict[object, int] = {}
        queue = as_completed(loop=client.loop)

        def submit() -> None:
            chunk = next(waiting, None)
            if chunk is not None:
                future = client.submit(evaluate, plan, chunk, key=f"{plan.hash}-{chunk}", retries=5, pure=True)
                numbers[future.key] = chunk
                queue.add(future)

        for _ in range(4 * max(1, sum(client.nthreads().values()))):
            submit()
        for future in queue:
            yield numbers.pop(future.key), future.result()
            submit()
