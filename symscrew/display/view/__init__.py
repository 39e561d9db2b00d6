"""A mechanism in a web page: one self-contained file with its model in JavaScript, to be turned, moved and played."""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.display.view.mode_chooser import page_modes
    from symscrew.display.view.motion_file import RecordedMotion, read_mechanism_and_motion, read_motion
    from symscrew.display.view.page import Limits, Pictures, make_page, open_made, write_made
    from symscrew.display.view.page_data import page_scene

__all__ = [
    "Limits",
    "Pictures",
    "RecordedMotion",
    "make_page",
    "open_made",
    "page_modes",
    "page_scene",
    "read_mechanism_and_motion",
    "read_motion",
    "write_made",
]

__getattr__ = doors(__name__)
