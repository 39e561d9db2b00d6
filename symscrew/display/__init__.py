"""What a person sees: text in the terminal, curves, pictures of mechanisms, and the page in 3-D (`view`)."""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.display.drawing import mechanism_figure
    from symscrew.display.plots import (
        COLOURS,
        DASHES,
        DPI,
        TIME,
        Curve,
        assumption_figure,
        curve_style,
        draw_curves,
        drive_figure,
        figure,
        joint_figure,
        reaction_figure,
        save_figure,
        symbol,
    )
    from symscrew.display.terminal import Progress, colours, installation, one_line, show, table
    from symscrew.display.view import open_page, read, write_page

__all__ = [
    "COLOURS",
    "DASHES",
    "DPI",
    "TIME",
    "Curve",
    "Progress",
    "assumption_figure",
    "colours",
    "curve_style",
    "draw_curves",
    "drive_figure",
    "figure",
    "installation",
    "joint_figure",
    "mechanism_figure",
    "one_line",
    "open_page",
    "reaction_figure",
    "read",
    "save_figure",
    "show",
    "symbol",
    "table",
    "write_page",
]

__getattr__ = doors(__name__)
