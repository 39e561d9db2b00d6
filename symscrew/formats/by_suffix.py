"""The table of formats: which reader a file takes by its root element, which writer by its suffix.

    file --root element--> Format.read --> Draft --> Mechanism --suffix--> Format.write --> text

A further format is a file with a reader, a writer or both, and a line in `FORMATS`. All formats here are XML.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from symscrew.description import Mechanism, to_toml
from symscrew.errors import DescriptionError, in_file, shorten
from symscrew.formats import mjcf_effects, urdf_effects
from symscrew.formats.draft import Draft
from symscrew.formats.drawn_meshes import MeshPictures, drawn
from symscrew.formats.file_names import safe_names
from symscrew.formats.from_draft import imported
from symscrew.formats.import_options import ImportOptions
from symscrew.formats.imported import Beside, Imported
from symscrew.formats.mjcf_reader import read_mjcf
from symscrew.formats.mjcf_writer import print_mjcf
from symscrew.formats.safe_xml import Element, read
from symscrew.formats.urdf_reader import read_urdf
from symscrew.formats.urdf_writer import print_urdf
from symscrew.whole_files import write_text

USUAL_GRAVITY = (0.0, 0.0, -9.81)
"""The field [m/s^2] that a file means which says nothing of it."""


@dataclass(frozen=True)
class Format:
    """A format of files.

    Attributes:
        root: tag of the root element, by which a file is known.
        suffixes: of its files; several formats may share one.
        read: (root element, path of the file, options) -> what the file says; None for a format that is only written.
        write: mechanism -> text of a file; None for a format that is only read. It takes what stands beside the
            mechanism as its second argument where it has `held` any of that.
        held: (mechanism, forces) -> those that its files hold beside each other; None where they hold none.
        gravity: whether they hold the field of gravity.
        all_limits: whether they hold greatest rates, and a reach with one end.
        words: whether they hold named points, the platform and the characteristic length.
    """

    root: str
    suffixes: tuple[str, ...]
    read: Callable[[Element, Path, ImportOptions], Draft] | None = None
    write: Callable[..., str] | None = None
    held: Callable[[Mechanism, Sequence[Mapping[str, Any]]], tuple[Mapping[str, Any], ...]] | None = None
    gravity: bool = False
    all_limits: bool = False
    words: bool = False


FORMATS = (
    Format("robot", (".urdf",), read_urdf, print_urdf, urdf_effects.held, all_limits=True),
    Format("mujoco", (".xml", ".mjcf"), read_mjcf, print_mjcf, mjcf_effects.held, gravity=True, words=True),
)


def readable(formats: Sequence[Format] = FORMATS) -> tuple[str, ...]:
    """Suffixes of the files that are read, the TOML of descriptions apart."""
    return tuple(dict.fromkeys(suffix for f in formats if f.read is not None for suffix in f.suffixes))


def writers(formats: Sequence[Format] = FORMATS) -> dict[str, Callable[..., str]]:
    """Suffix -> what writes its files, the TOML of descriptions as well."""
    found = {suffix: f.write for f in formats if f.write is not None for suffix in f.suffixes}
    return {**found, ".toml": to_toml}


READABLE = readable()
WRITERS: Mapping[str, Callable[..., str]] = writers()


def load_format(path: str | Path, *, formats: Sequence[Format] = FORMATS) -> Mechanism:
    """The validated mechanism in a URDF or MJCF file; its `source` says what the file holds besides.

    Args:
        path: of the file; its root element says which format it has, whatever its suffix is.
        formats: those that are known.

    Raises:
        DescriptionError: the file cannot be read, or holds what a mechanism cannot.
    """
    return import_file(path, formats=formats).mechanism


def import_file(
    path: str | Path, options: ImportOptions | None = None, *, formats: Sequence[Format] = FORMATS
) -> Imported:
    """The mechanism in a file with its effects, limits and configurations, and what became of all that the file says.

    Args:
        path: of the file; its root element says which format it has, whatever its suffix is.
        options: what is accepted beside what is read without asking.
        formats: those that are known.

    Raises:
        DescriptionError: the file cannot be read, or holds what a mechanism cannot, or what numbers depend on is left
            out and not accepted.
    """
    file, given = Path(path), options or ImportOptions()
    try:
        return imported(_draft(file, given, formats), given)
    except DescriptionError as error:
        raise in_file(file.name, error) from error
    except OverflowError as error:
        raise DescriptionError(
            f"{file.name}: products of its numbers go beyond 1.8e308; expected SI units, in which none does"
        ) from error


def mesh_pictures(path: str | Path, options: ImportOptions | None = None) -> MeshPictures:
    """What the bodies in a file look like: the triangles of its meshes by body, and what could not be drawn.

    Args:
        path: of the URDF or MJCF file.
        options: as for `import_file`; meshes are below the file's own folder, or below `folder`, as packages are.

    Raises:
        DescriptionError: the file cannot be read; of meshes that cannot be read the result says so.
    """
    file, given = Path(path), options or ImportOptions()
    try:
        draft = _draft(file, given, FORMATS)
        return drawn(draft.pictures, safe_names([draft.ground, *(body.name for body in draft.bodies)]))
    except DescriptionError as error:
        raise in_file(file.name, error) from error


def _draft(file: Path, options: ImportOptions, formats: Sequence[Format]) -> Draft:
    root = read(file)
    readers = {f.root: f.read for f in formats if f.read is not None}
    if root.tag not in readers:
        expected = " or ".join(f"<{tag}>" for tag in readers)
        raise DescriptionError(f"expected the root element {expected}, got <{shorten(root.tag)}>")
    return readers[root.tag](root, file, options)


def save_as(model: Mechanism, path: str | Path, *, beside: Beside | None = None) -> list[str]:
    """Write a mechanism to a file; its suffix says as what. An existing file is replaced at the end, or not at all.

    `beside`: forces, limits and gravity that the file is to have as well. Returns what of both the file does not hold.

    Raises:
        DescriptionError: no format has this suffix, or the format does not hold such a mechanism, or what stands
            beside it and is not accepted.
    """
    file = Path(path)
    text, left = _text_and_rest(model, file.suffix, beside, FORMATS)
    write_text(file, text)
    return left


def text_of(model: Mechanism, suffix: str, *, beside: Beside | None = None, formats: Sequence[Format] = FORMATS) -> str:
    """The text of a file of this suffix that describes a mechanism.

    Raises:
        DescriptionError: no format has this suffix, or the format does not hold such a mechanism (a URDF no loops), or
            what stands beside it and is not accepted.
    """
    return _text_and_rest(model, suffix, beside, formats)[0]


def _text_and_rest(
    model: Mechanism, suffix: str, beside: Beside | None, formats: Sequence[Format]
) -> tuple[str, list[str]]:
    """(text, what of the mechanism and of what stands beside it is not in it)."""
    known = writers(formats)
    if suffix not in known:
        raise DescriptionError(f"expected a file name that ends in {', '.join(known)}, got {shorten(suffix)}")
    form = next((f for f in formats if suffix in f.suffixes and f.write is not None), None)
    unheld = [] if form is None else _words_left(model, form)
    if beside is None or form is None or form.held is None:
        return known[suffix](model), unheld
    left = [*beside.others]
    kept = form.held(model, beside.forces)
    left += [f"{f['kind']} of {f.get('joint', f.get('point', f.get('body')))}" for f in beside.forces if f not in kept]
    if not form.gravity and beside.gravity not in (None, USUAL_GRAVITY):
        left.append(f"gravity {beside.gravity}")
    if left and not beside.accept:
        raise DescriptionError(
            f"a {suffix} file does not hold {', '.join(left)}; write another format, leave these effects out (--bare), "
            "or accept that with --accept"
        )
    return known[suffix](model, replace(beside, forces=kept)), left + _limits_left(beside, form) + unheld


def _limits_left(beside: Beside, form: Format) -> list[str]:
    if form.all_limits:
        return []
    rates = [joint for joint, found in beside.limits.items() if found.velocity is not None]
    ends = [joint for joint, found in beside.limits.items() if (found.lower is None) != (found.upper is None)]
    kinds = (("greatest rates", rates), ("reaches with one end", ends))
    return [f"{what} ({', '.join(named)})" for what, named in kinds if named]


def _words_left(model: Mechanism, form: Format) -> list[str]:
    """What of a mechanism the files do not hold, on which none of their numbers depends: formulas and names."""
    kinds = [("formulas of the parameters", [*model.parameters]), ("names of limbs", [*model.limbs])]
    if not form.words:
        ends = [end for joint in model.joints.values() for end in (joint.parent, joint.child)]
        tips = [body for body in model.bodies if body != model.ground and ends.count(body) == 1]
        platform = (
            [model.platform] if model.platform and tips != [model.platform] else []
        )  # the only tip is found again
        kinds += [("named points", [*model.points]), ("the platform", platform)]
        length = model.characteristic_length
        kinds.append(("characteristic length", [] if length is None else [f"{float(model.number(length)):g} m"]))
    return [f"{what} ({', '.join(named)})" for what, named in kinds if named]
