"""Comments of a description that is written anew: none is lost, wherever it stands, and no value changes."""

from __future__ import annotations

import random
import re
import tomllib
from pathlib import Path

import pytest

from symscrew import catalogue
from symscrew.description import parse_description, to_toml, with_comments

FOLDER = Path(catalogue.__file__).parent


def commented(text: str, seed: int) -> tuple[str, list[str]]:
    """The text with comments of their own at random places where TOML takes them, inside of arrays too."""
    random_number, made, depth, said = random.Random(seed), list[str](), 0, list[str]()

    def comment() -> str:
        said.append(f"# comment {len(said)}, with \" ' ] = and [x]")
        return said[-1]

    for line in text.splitlines():
        if depth == 0 and random_number.random() < 0.2:
            made += [comment(), *([""] if random_number.random() < 0.3 else [])]
        inside = re.fullmatch(r"(\w+ = \[)(.*\])", line)
        if inside and not re.search(r"[\"'#]", line) and random_number.random() < 0.5:
            made += [f"{inside[1]} {comment()}", f"  {comment()}", inside[2]]
        elif "#" not in line and line.strip() and random_number.random() < 0.2:
            made.append(f"{line} {comment()}")
        else:
            made.append(line)
    return "\n".join([*made, comment(), ""]), said


@pytest.mark.parametrize("name", ["delta", "four_bar", "gear_train", "three_ups_upu_s"])
@pytest.mark.parametrize("seed", range(3))
def test_no_comment_is_lost_and_no_value_changed(name: str, seed: int) -> None:
    text = (FOLDER / f"{name}.toml").read_text()
    old, said = commented(text, seed)
    assert tomllib.loads(old) == tomllib.loads(text), "the comments are where TOML takes them"
    new = to_toml(parse_description(old))
    written = with_comments(new, old)
    assert tomllib.loads(written) == tomllib.loads(new)
    for comment in said:
        assert written.count(comment + "\n") == 1, comment
    assert with_comments(new, written) == written, "and the next time nothing moves"


OLD = """\
# licence

# about the rail
[parameters]
rail = { value = "0.45", unit = "m" }  # by the drawing
# of one half
half.value = 1
half.unit = "m"  # a dotted key
gone.value = 3  # of what is not there any more

[bodies.block]
# in kg
mass = 1.20
name = 'a # no comment'
com = [ # of the block
  0.5,  # along
  # nothing across
  0, 0,
]
inertia = [1,  # about x
  2, 3]
text = \"\"\"
# no comment either
\"\"\"
# the end"""
NEW = """\
[parameters.rail]
value = 0.45
unit = "m"

[parameters.half]
value = 1
unit = "m"

[bodies.block]
mass = 1.2
com = [0.5, 0, 0]
inertia = [[1, 0, 0], [0, 2, 0], [0, 0, 3]]
"""
MADE = """\
# licence

# about the rail
[parameters.rail]  # by the drawing
value = 0.45
unit = "m"

[parameters.half]
# of one half
value = 1
unit = "m"  # a dotted key

[bodies.block]
# in kg
mass = 1.2
com = [ # of the block
  0.5,  # along
  # nothing across
  0, 0,
]
# about x
inertia = [[1, 0, 0], [0, 2, 0], [0, 0, 3]]
# the end
"""


def test_where_comments_go() -> None:
    """Inline tables and dotted keys that become sections; arrays that stay, and one that is written otherwise."""
    written = with_comments(NEW, OLD)
    assert written.replace("# of what is not there any more\n", "") == MADE
    assert written.count("# of what is not there any more") == 1
    assert with_comments(NEW, OLD.replace("\n", "\r\n")) == written


@pytest.mark.parametrize("old", ["", "# only this", "\n\n# a\n\n\n# b\n", "[x] # unknown\n[y]\n# last", 'a = "#"'])
def test_files_of_little(old: str) -> None:
    written = with_comments(NEW, old)
    assert tomllib.loads(written) == tomllib.loads(NEW)
    assert [written.count(c) for c in re.findall(r"# ?\w+", old)] == [1] * len(re.findall(r"# ?\w+", old))
