"""Words of a file that look like ones that are read: misspelt, they would be left out without a word.

    element, its attributes and children --words that are read--> "attribute 'types' of <loop>: did you mean 'type'?"

URDF and MJCF files hold much that a mechanism does not: pictures, sensors, plugins, words of other programs. So a word
that nobody knows is left out and told in the account. One that is nearly a word that is read, where that word itself
is missing, is another thing: with it a limit, a mass or a type is lost.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from difflib import get_close_matches

from symscrew.formats.draft import Ledger
from symscrew.formats.safe_xml import Element, elements

Words = Mapping[str, Sequence[str]]
# twice the letters that agree, of those of both words: 'types' and 'type' have 0.89, 'xyzs' and 'xyz' 0.86; below,
# words that mean other things ('frictionloss' and 'friction': 0.8) would be taken for misspelt
NEAR = 0.85


def note_near_words(root: Element, ledger: Ledger, *, attributes: Words, children: Words) -> None:
    """Enter what is nearly a word that is read as lost, with influence on numbers.

    Args:
        root: of the file; all elements below it are looked at.
        ledger: what became of everything.
        attributes: those that are read of an element, by its tag.
        children: tags that are read in an element, by its tag.
    """
    for element in root.iter():
        if not isinstance(element.tag, str):
            continue
        for what, given, known in (
            ("attribute", [*element.attrib], attributes.get(element.tag, ())),
            ("element", [child.tag for child in elements(element)], children.get(element.tag, ())),
        ):
            for word, meant in _near(given, known):
                ledger.lost(f"{what} {word!r} of <{element.tag}>, which is not read: did you mean {meant!r}?")


def _near(given: Sequence[str], known: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Words that are not known, each with a missing one that it is nearly."""
    missing = [word for word in known if word not in given]
    for word in dict.fromkeys(given):
        if word not in known and "}" not in word:
            for meant in get_close_matches(word.lower()[:40], missing, n=1, cutoff=NEAR):
                yield word[:40], meant
