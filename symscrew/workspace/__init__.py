"""Maps over independent coordinates and parameters: workspace, design studies, tolerances; see `command`."""
