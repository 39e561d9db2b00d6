"""Benchmarks: time, operations and growth. Printed, never asserted; `python -m tests.benchmarks --help`."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))  # where the tests find `support`, too
