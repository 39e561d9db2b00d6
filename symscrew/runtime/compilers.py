"""The system's C compiler, and what it made kept for the next time.

    C file, options --key--> hash of all that goes in --user_cache--> library
                                  | not there: compiler, at most `LIMIT` seconds
                                  v
                              library, looked at before anybody loads it

Every compiled library of the package comes from `compile_c`. One that was made before from the same bytes by the same
compiler with the same options on the same processor is taken from the user's cache (see `user_cache`).
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import platform
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path

from symscrew.export import SPILLS
from symscrew.runtime import user_cache

COMPILERS = ("cc", "gcc", "clang")  # the first that is there
FLAGS = ("-std=c99", "-O2", "-fno-math-errno", "-ffp-contract=fast", "-shared", "-fPIC")
# Seconds for one file: the longest of the catalogue with every function and its derivatives takes a minute. A compiler
# that needs more hangs, or the file is better made with fewer functions.
LIMIT = 900.0
ANSWER = 20.0  # seconds to say a version: an installed compiler takes some milliseconds
# Options of which the result depends on nothing but the files that are named: what is made with others is not kept.
KNOWN = re.compile(
    r"-(D\w+(=\w*)?|U\w+|O\w?|std=[\w+]+|pedantic(-errors)?|g\w?|shared|fPIC|pthread|W(?![alp],)[\w+=-]+|m[\w=+.-]+"
    r"|f(?!plugin|profile|auto-profile|dump|diagnostics|wrapper)[\w=+-]+|-param=[\w=-]+)",
    re.ASCII,
)
DEMANDED = "-Werror"  # who compiles with it wants to hear of a warning, not to get a library made without the option
SOURCES = (".c", ".h")  # endings of files that are read here to find out what goes into a library
# Variables of the environment that change what a compiler finds and makes.
VARIABLES = ("CPATH", "C_INCLUDE_PATH", "LIBRARY_PATH", "COMPILER_PATH", "GCC_EXEC_PREFIX", "CCC_OVERRIDE_OPTIONS")
INCLUDE = re.compile(rb'^[ \t]*#[ \t]*include[ \t]*(?:"([^"\n]+)"|<[^>\n]+>|(\S))', re.MULTILINE)
PROCESSOR = ("vendor_id", "cpu family", "model", "stepping", "flags", "Features", "CPU implementer", "CPU part", "isa")


class CompileError(RuntimeError):
    """There is no C compiler, or it made no library of the generated code; the message holds what it said."""


def find_compiler() -> str | None:
    """Path of the system's C compiler, or None."""
    return next((path for path in map(shutil.which, COMPILERS) if path), None)


def attempts(flags: Sequence[str], *, native: bool) -> tuple[tuple[str, ...], ...]:
    """Options to try in turn: a compiler that does not know one of those that only make it faster refuses the file.

    With `DEMANDED` among them the next are tried only where it does not know them.
    """
    own: tuple[str, ...] = ("-march=native",) if native else ()
    return tuple((*FLAGS, *machine, *flags) for machine in dict.fromkeys(((*own, SPILLS), own, ())))


def compile_c(
    source: Path, library: Path, *, compiler: str | None = None, flags: Sequence[str] = (), native: bool = True
) -> None:
    """Compile a C file into a shared library, for this processor (`native`) where the compiler knows it.

    What was compiled before from the same is taken from the cache.

    Raises:
        CompileError: there is no compiler, it refused the file, did not end, or wrote no library.
    """
    command = compiler or find_compiler()
    if command is None:
        raise CompileError(f"no C compiler ({', '.join(COMPILERS)}); install one or use backend='casadi'")
    tried = attempts(flags, native=native)
    key = _key(source, command, tried)
    with user_cache.entry(key) as entry:
        kept = entry.read()
        if kept is not None and loadable(kept):
            library.write_bytes(kept)
            return
        _compile(source, library, command, tried)
        entry.write(library.read_bytes())


def _compile(source: Path, library: Path, command: str, tried: Sequence[Sequence[str]]) -> None:
    said = ""
    for options in tried:
        library.unlink(missing_ok=True)
        outcome, said = run_tool([command, *options, str(source), "-o", str(library), "-lm"], source.name)
        if outcome == 0:
            made = library.read_bytes() if library.is_file() else b""
            if not loadable(made):
                what = f"{len(made)} bytes that are no library" if made else "no library"
                raise CompileError(f"{command} ended well on {source.name}, but wrote {what}; is it a C compiler?")
            return
        if DEMANDED in options and _knows(command, options):
            break
    raise CompileError(f"{command} refused {source.name}:\n{said}")


def _knows(command: str, options: Sequence[str]) -> bool:
    """Whether a compiler takes these options for an empty file: what it refuses with them is then the file."""
    known = [word for word in options if not word.endswith(SOURCES)]
    outcome, _ = run_tool([command, *known, "-fsyntax-only", "-x", "c", os.devnull], "an empty file")
    return outcome == 0


def run_tool(arguments: Sequence[str], name: str, *, folder: Path | None = None) -> tuple[int, str]:
    """Exit status of a compiler or another tool, and the end of what it said, in whatever encoding.

    With all that it started, it is ended at the limit.

    Args:
        arguments: the command.
        name: what it is about, for the error.
        folder: where it runs.

    Raises:
        CompileError: it cannot be run, or does not end.
    """
    with tempfile.TemporaryFile(prefix="symscrew_") as said:
        try:
            process = subprocess.Popen(
                arguments, stdin=subprocess.DEVNULL, stdout=said, stderr=said, cwd=folder, start_new_session=True
            )
        except OSError as error:
            raise CompileError(f"{arguments[0]} cannot be run: {error.strerror or error}") from error
        try:
            outcome = process.wait(LIMIT)
        except subprocess.TimeoutExpired as error:
            raise CompileError(
                f"{arguments[0]} did not end within {LIMIT:g} s on {name}; compile fewer functions"
            ) from error
        finally:
            if process.poll() is None:  # interrupted, too
                with contextlib.suppress(OSError):
                    os.killpg(process.pid, signal.SIGKILL) if hasattr(os, "killpg") else process.kill()
                process.wait()
        said.seek(max(said.seek(0, os.SEEK_END) - 4000, 0))
        return outcome, said.read().decode("utf-8", "replace")


def loadable(content: bytes) -> bool:
    """Whether this is a whole shared library: one that is cut off ends the process that loads it.

    Of ELF, sizes are looked at; of other formats, that there is something.
    """
    if not content.startswith(b"\x7fELF"):
        return len(content) > 0 and sys.platform != "linux"
    wide, little = content[4:5] == b"\x02", content[5:6] == b"\x01"
    order = "little" if little else "big"

    def number(at: int, size: int) -> int:
        return int.from_bytes(content[at : at + size], order)  # type: ignore[arg-type]

    # e_type 3: a shared object; e_shoff, e_shentsize, e_shnum: the table of sections stands at the end of the file
    table, entry, count = (number(40, 8), number(58, 2), number(60, 2)) if wide else (
        number(32, 4), number(46, 2), number(48, 2))  # fmt: skip
    return number(16, 2) == 3 and len(content) >= 64 and 0 < table <= table + entry * count <= len(content)


def _key(source: Path, command: str, tried: Sequence[Sequence[str]]) -> str | None:
    """Hash of all that a library is made of; None where that cannot be told."""
    files = [source, *(Path(word) for options in tried[:1] for word in options if word.endswith(SOURCES))]
    options = [word for words in tried for word in _options(words).decode().split("\0")]
    compiler = compiler_key(command)
    read = dict(_read(files))
    if compiler is None or None in read.values() or not all(KNOWN.fullmatch(word) for word in options):
        return None
    parts: list[bytes] = [compiler, b"\n".join(_options(w) for w in tried)]
    for name, content in sorted(read.items()):
        parts += [name.encode("utf-8", "surrogateescape"), content or b""]
    found = hashlib.sha256()
    for part in parts:
        found.update(len(part).to_bytes(8, "little") + part)
    return found.hexdigest()


def _options(words: Sequence[str]) -> bytes:
    """A command without its files, whose contents count, and not their places."""
    return "\0".join(word for word in words if not word.endswith(SOURCES)).encode("utf-8", "surrogateescape")


def _read(files: Sequence[Path]) -> Iterator[tuple[str, bytes | None]]:
    """Name and content of C files and of what they include in quotes; None where somebody else's file may be meant."""
    seen: set[Path] = set()
    wanted = [(path, number) for number, path in enumerate(files)]
    while wanted:
        path, number = wanted.pop()
        if path in seen:
            continue
        seen.add(path)
        name = f"{number} {os.path.relpath(path, files[number].parent)}"  # wherever the folder is
        try:
            content = path.read_bytes()
        except OSError:
            yield name, None
            continue
        yield name, content
        for quoted, computed in INCLUDE.findall(content):
            if computed:
                yield f"{name}: #include {computed!r}", None
            elif quoted:
                wanted.append((path.parent / os.fsdecode(quoted), number))


def compiler_key(command: str | None) -> bytes | None:
    """What a library depends on beside its text and options: compiler, processor, environment; None: it is not known.

    `command`: the compiler; without one, None.
    """
    compiler = None if command is None else identity(command)
    if compiler is None:
        return None
    parts: list[bytes] = [compiler.encode("utf-8", "surrogateescape"), processor().encode("utf-8", "surrogateescape")]
    parts += [os.fsencode(f"{name}={os.environ[name]}") for name in VARIABLES if name in os.environ]
    return b"".join(len(part).to_bytes(8, "little") + part for part in parts)


def identity(command: str) -> str | None:
    """Place, size, time and version of a compiler; None where it does not answer."""
    try:
        path = os.path.realpath(shutil.which(command) or command)
        found = os.stat(path)
        return f"{path} {found.st_size} {found.st_mtime_ns} {_version(command, found.st_size, found.st_mtime_ns)}"
    except (OSError, subprocess.SubprocessError):
        return None


@cache
def _version(command: str, *_: int) -> str:
    """What a compiler says of itself, which is asked once while its file stays as it is."""
    answer = subprocess.run(
        [command, "--version"],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        timeout=ANSWER,
        check=True,
    )
    return answer.stdout.decode("utf-8", "replace")


@cache
def processor() -> str:
    """What code for this processor depends on: its kind and instructions; where that is unknown, the machine's name."""
    facts = [sys.platform, platform.machine(), *platform.libc_ver()]
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace").partition("\n\n")[0].splitlines()
    except OSError:
        return "\n".join([*facts, platform.processor(), platform.node()])
    fields = [line for line in lines if line.partition(":")[0].strip() in PROCESSOR]
    return "\n".join([*facts, *fields] if fields else [*facts, platform.node()])
