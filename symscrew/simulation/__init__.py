"""Simulation of a scene: from its programs to a run, its report and its files."""
