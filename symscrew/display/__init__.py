"""What a person sees: text in the terminal, curves, pictures of mechanisms, and the page in 3-D (`view`)."""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.display.drawing import mechanism_figure
    from symscrew.display.end_labels import End, label_ends
    from symscrew.display.film import write_film
    from symscrew.display.installed_parts import installation
    from symscrew.display.modes_picture import modes_figure
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
        empty_figure,
        indexed_symbol,
        joint_figure,
        reaction_figure,
        save_figure,
    )
    from symscrew.display.shown import Page, Picture, draw, show_page
    from symscrew.display.terminal import (
        Progress,
        aligned_table,
        bar_on_terminal,
        colours,
        fitting_table,
        one_line,
        print_table,
        print_text,
    )
    from symscrew.display.view import (
        Limits,
        Pictures,
        RecordedMotion,
        make_page,
        open_made,
        page_modes,
        read_mechanism_and_motion,
        write_made,
    )

__all__ = [
    "COLOURS",
    "DASHES",
    "DPI",
    "TIME",
    "Curve",
    "End",
    "Limits",
    "Page",
    "Picture",
    "Pictures",
    "Progress",
    "RecordedMotion",
    "aligned_table",
    "assumption_figure",
    "bar_on_terminal",
    "colours",
    "curve_style",
    "draw",
    "draw_curves",
    "drive_figure",
    "empty_figure",
    "fitting_table",
    "indexed_symbol",
    "installation",
    "joint_figure",
    "label_ends",
    "make_page",
    "mechanism_figure",
    "modes_figure",
    "one_line",
    "open_made",
    "page_modes",
    "print_table",
    "print_text",
    "reaction_figure",
    "read_mechanism_and_motion",
    "save_figure",
    "show_page",
    "write_film",
    "write_made",
]

__getattr__ = doors(__name__)
