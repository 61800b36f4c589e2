"""What the benchmarks share."""

import time


def best(job, repeats=5):
    """Least seconds of several runs."""
    took = []
    for _ in range(repeats):
        started = time.perf_counter()
        job()
        took.append(time.perf_counter() - started)
    return min(took)
