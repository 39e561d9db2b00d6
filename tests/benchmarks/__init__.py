"""Benchmarks: time, operations and growth. Printed, never asserted; `python -m tests.benchmarks --help`."""
