"""`pytest tests/fuzz --hypothesis-profile=hunt` looks at new files, thousands of each format."""

from hypothesis import settings
from support.fuzzing import HUNT

settings.register_profile("hunt", HUNT)
