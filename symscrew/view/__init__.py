"""A mechanism in a web page: one self-contained file with its model in JavaScript, to be turned, moved and played."""

from symscrew.view.motion_file import RecordedMotion, read, read_motion
from symscrew.view.page import make_page, open_page, write_page
from symscrew.view.scene import scene

__all__ = ["RecordedMotion", "make_page", "open_page", "read", "read_motion", "scene", "write_page"]
