"""The targets that a folder of generated code can have."""

TARGETS = ("c", "casadi", "numpy", "external", "javascript", "fmu", "mjcf", "urdf", "markdown")
USUAL = ("c", "casadi", "numpy")
SINGLE_TARGETS = ("c", "markdown")  # those that single precision has
