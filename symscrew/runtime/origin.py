"""Where the functions that are loaded come from, and how far that is trusted.

    Model                        its programs, printed here
    folder                       mechanism.toml, effects --derive, print_c--> C; its own must be the same, byte for byte
    folder, trusted              its own C, as it stands

Of a folder nothing is compiled, imported or deserialised that was not made here: its C is compared with what its
description gives, and it is the C made here that is compiled. What was made of the same description by the same version
is kept as text in the user's cache, so that this takes its time once.
"""

from __future__ import annotations

import hashlib
import json
import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

from symscrew.description import check_name, load_description
from symscrew.errors import DescriptionError, shorten
from symscrew.export import (
    HASHES,
    PRECISIONS,
    Form,
    OutputError,
    Precision,
    effect_from_json,
    interface,
    library_sources,
    model_hash,
    plain,
    print_c,
    read_form,
    read_hashes,
    read_manifest,
    read_port,
)
from symscrew.functions import HESSIAN, PRODUCT
from symscrew.model import Model, derive
from symscrew.program import STATUS, Port, status_texts
from symscrew.runtime import user_cache
from symscrew.runtime.versions import version

Ports = Mapping[str, tuple[tuple[Port, ...], tuple[Port, ...]]]  # function -> inputs, outputs
DESCRIPTION = "mechanism.toml"
DESCRIBING = (DESCRIPTION, "manifest.json")  # files that say what a folder's C is
FOLDER = "/"  # beside functions: what is compared of the whole folder
LARGEST_ARRAY = 1 << 31  # entries of a port: a manifest that says more was not written here, and sizes could overflow


@dataclass(frozen=True)
class Origin:
    """A model's name, functions with their arrays, precision; `model` derives it.

    `files`: the C of one function, or of all (""). `sources`: C files of a folder, which are compiled as they stand.
    `texts`: what statuses mean.
    """

    name: str
    ports: Ports
    precision: Precision
    model: Callable[[], Model]
    files: Callable[[str], Mapping[str, str]]
    sources: tuple[Path, ...] = ()
    texts: Mapping[int, str] = field(default_factory=lambda: STATUS)


def origin_of(source: Model | str | Path, precision: str | None, *, trusted: bool, lanes: bool) -> Origin:
    """The origin of a model or of a folder that `generate` wrote.

    Raises:
        OutputError: the folder holds nothing that `generate` wrote, only hashes, or something else than it would write.
        ValueError: a precision that the folder does not have.
    """
    if isinstance(source, Model):
        real, made = PRECISIONS[precision or "double"], source
        known = {name: made.declared(name) for name in made.programs}
        own_ports = {name: (f.inputs, f.outputs) for name, f in known.items()}

        def printed(function: str) -> Mapping[str, str]:
            return print_c(made.only([function]) if function else made, precision=real, lanes=lanes)

        return Origin(made.name, own_ports, real, lambda: made, printed, texts=status_texts(*known.values()))
    directory = Path(source)
    content = read_manifest(directory)
    name, ports, own = read_interface(directory, content)
    if read_hashes(directory):
        raise OutputError(f"{source}: holds hashes in place of its code ({HASHES}); generate it without --hashes-only")
    told = _status_texts(content)
    if precision not in (None, own.name):
        raise ValueError(f"{source}: expected its own precision, {own.name}, got {precision}; generate it again")

    def derived() -> Model:
        model = model_of(directory, content)
        _same_interface(directory, model, name, ports=ports, precision=own)
        return model

    if trusted:
        named = (f for f in content["files"] if isinstance(f, str) and Path(f).name == f)
        sources = library_sources(named, name)
        if not sources:
            raise OutputError(f"{directory}/manifest.json: lists no C files; generate the target c")
        if not read_form(content).batches:
            raise OutputError(
                f"{directory}: has no functions of many states, by which it is called; load it without trusted=True, "
                "which compiles the same functions with these"
            )
        return Origin(name, ports, own, derived, lambda _: {}, tuple(directory / f for f in sources), told)
    code = _FolderCode(directory, own, derived, read_form(content))
    return Origin(name, ports, own, derived, code.of, texts=told)


def _status_texts(content: Mapping[str, Any]) -> Mapping[int, str]:
    """What statuses mean, as far as a manifest says it in words of a length that an error can hold."""
    tables = [entry.get("status") for entry in content["functions"].values() if isinstance(entry, dict)]
    rows = [row for table in tables if isinstance(table, dict) for row in table.items()]
    told = {int(code): plain(str(text))[:200] for code, text in rows if re.fullmatch(r"1[1-9]|[2-9]\d", code)}
    return {**STATUS, **told}


def read_interface(directory: Path, content: Mapping[str, Any]) -> tuple[str, Ports, Precision]:
    """Name, ports of every function, and precision, as a manifest says.

    Raises:
        OutputError: it is no manifest of this tool.
    """
    try:
        name = check_name(content["mechanism"], "manifest.json, mechanism")
        functions = {check_name(f, "manifest.json, function"): entry for f, entry in content["functions"].items()}
        ports = {f: (_ports(entry["inputs"]), _ports(entry["outputs"])) for f, entry in functions.items()}
        precision = PRECISIONS["single" if content.get("precision") == "single" else "double"]
    except DescriptionError as error:
        raise OutputError(f"{directory}: {error}") from error
    except (AttributeError, KeyError, TypeError, ValueError, OverflowError, RecursionError) as error:
        what = f"{type(error).__name__}: {shorten(str(error))}"
        text = f"{directory}/manifest.json: expected functions with ports ({what}); generate again"
        raise OutputError(text) from error
    if not ports:
        raise OutputError(f"{directory}/manifest.json: expected functions, found none; generate again")
    return name, ports, precision


def _ports(entries: Sequence[Any]) -> tuple[Port, ...]:
    found = tuple(map(read_port, entries))
    for entry, port in zip(entries, found, strict=True):
        check_name(port.name, "manifest.json, port")
        if any(type(n) is not int or n < 0 for n in entry["shape"]) or not 1 <= len(port.shape) <= 2:
            raise ValueError(f"{port.name}: shape {entry['shape']}")
        if math.prod(port.shape) > LARGEST_ARRAY or len(port.units) != port.size:
            raise ValueError(f"{port.name}: {len(port.units)} units for shape {entry['shape']}")
    if len({port.name for port in found}) != len(found):
        raise ValueError("two ports of one name")
    return found


def model_of(directory: Path, content: Mapping[str, Any]) -> Model:
    """The model that a folder was generated from, derived again from its description and the effects in its manifest.

    Raises:
        OutputError: an effect that does not exist.
        DescriptionError: mechanism.toml describes no mechanism.
    """
    mechanism = load_description(directory / DESCRIPTION)
    effects = tuple(effect_from_json(entry) for entry in content["effects"])
    functions = content.get("functions", {})
    wanted: dict[str, Any] = {
        "derivatives": any(name == "linearisation" or name.endswith("_derivatives") for name in functions),
        "second_derivatives": any(name.endswith((PRODUCT, HESSIAN)) for name in functions),
        "regressor": any("regressor" in name for name in functions),
        "one_mode": content.get("one_mode") is True,
        "checked": any(name.endswith("_checked") for name in functions),
    }
    # the derivation's own choice of coordinates first: where it gives the model of the manifest, none were named; of a
    # selection without first derivatives nothing says whether they were derived, and second ones are written by them
    chosen = content.get("independent") or None
    unnamed = wanted["second_derivatives"] and not wanted["derivatives"]
    ways = [wanted, *([{**wanted, "derivatives": True}] if unnamed else [])]
    ways += [{**way, "independent": chosen} for way in ways] if chosen else []
    model = first = _selected(derive(mechanism, effects, **wanted), content)
    for way in ways[1:]:
        if model_hash(model) == content.get("hash"):
            return model
        model = _selected(derive(mechanism, effects, **way), content)
    return model if model_hash(model) == content.get("hash") else first


def _selected(model: Model, content: Mapping[str, Any]) -> Model:
    """The model, with the functions of the manifest only if these were selected."""
    if content.get("selected") is not True:
        return model
    return model.only([name for name in content.get("functions", {}) if name in model.programs])


def _same_interface(directory: Path, model: Model, name: str, *, ports: Ports, precision: Precision) -> None:
    """What a manifest says of functions against the model that it should be of."""
    own = {name: (known.inputs, known.outputs) for name in model.programs for known in [model.declared(name)]}
    if model.name != name:
        text = f"{directory}/manifest.json: it is of {name}, {DESCRIPTION} of {model.name}; generate again"
        raise OutputError(text)
    here, there = interface(precision.real, own), interface(precision.real, ports)
    if here != there:
        wrong = sorted(set(here) ^ set(there))[0]
        raise OutputError(
            f"{directory}/manifest.json: its functions are not those of {DESCRIPTION} ({shorten(wrong, 100)}); "
            "generate again"
        )


class _FolderCode:
    """The C that a folder's description gives, of one function or of all, as far as somebody asks for it.

    Before the first of it is given, the C in the folder has been found to be the same.
    """

    def __init__(self, directory: Path, precision: Precision, derived: Callable[[], Model], form: Form) -> None:
        self._directory, self._precision, self._form = directory, precision, form
        self._derived = cache(derived)
        self._read = [_bytes(directory / file) for file in DESCRIBING]
        self._whole = cache(self._print_whole)
        self._texts: dict[str, Mapping[str, str]] = {}

    def of(self, function: str) -> Mapping[str, str]:
        """C files by name, of a function or of all ("").

        Raises:
            OutputError: the folder holds other C than its description gives.
        """
        if not self._texts:
            self._compare()
        if function not in self._texts:
            self._texts[function] = self._kept(function, lambda: self._printed(function))
        return self._texts[function]

    def _printed(self, function: str) -> Mapping[str, str]:
        if function:
            return print_c(self._derived().only([function]), precision=self._precision, lanes=False)
        return self._whole(True)

    def _print_whole(self, batches: bool) -> Mapping[str, str]:
        several = not self._form.one_file
        return print_c(self._derived(), precision=self._precision, several=several, batches=batches)

    def _compare(self) -> None:
        digests = self._kept(FOLDER, self._digests)
        for file, digest in digests.items():
            if _digest(_bytes(self._directory / file)) != digest:
                raise OutputError(
                    f"{self._directory}/{file}: is not the code that {DESCRIPTION} and manifest.json give with this "
                    "version; generate it again, or load it with trusted=True if you know where it comes from"
                )

    def _digests(self) -> Mapping[str, str]:
        texts = self._whole(self._form.batches)
        return _compared({file: text.encode("utf-8") for file, text in texts.items()})

    def _kept(self, what: str, make: Callable[[], Mapping[str, str]]) -> Mapping[str, str]:
        key = _key(what, self._precision.name, self._read)
        with user_cache.entry(key) as entry:  # not held while it is made
            found: Mapping[str, str] | None = _texts(entry.read())
        if found is None:
            found = make()
            with user_cache.entry(key) as entry:
                entry.write(json.dumps(found).encode("utf-8"))
        return found


def remember_folder(files: Mapping[str, bytes]) -> None:
    """Keep in the user's cache what C belongs to the description of a folder that this version has just made.

    `files`: content by name. Loading the folder compares its C with that, and derives it no second time for this.
    """
    if not files.keys() >= set(DESCRIBING):
        return
    content = json.loads(files["manifest.json"])
    name, precision = content["mechanism"], content.get("precision", "double")
    own = {*library_sources(files, name), f"{name}_support.h"}
    digests = _compared({file: data for file, data in files.items() if file in own})
    if not digests:
        return
    with user_cache.entry(_key(FOLDER, precision, [files[file] for file in DESCRIBING])) as entry:
        entry.write(json.dumps(digests).encode("utf-8"))


def _key(what: str, precision: str, read: Sequence[bytes]) -> str:
    return user_cache.key_of(b"C of a folder", what.encode(), version().encode(), precision.encode(), *read)


def _compared(files: Mapping[str, bytes]) -> dict[str, str]:
    """Digests of what is compared: the C files and the header that they share, which are made of the description."""
    return {file: _digest(data) for file, data in files.items() if file.endswith((".c", "_support.h"))}


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


def _texts(kept: bytes | None) -> dict[str, str] | None:
    """Texts by name that were kept as JSON, if that is what it is."""
    try:
        found = json.loads(kept) if kept is not None else None
    except (ValueError, RecursionError):
        return None
    texts = isinstance(found, dict) and found and all(isinstance(text, str) for text in found.values())
    return found if texts else None


def _bytes(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except OSError as error:
        raise OutputError(f"{path}: cannot be read ({error.strerror}); generate again") from error
