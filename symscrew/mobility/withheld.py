"""What is said in place of a statement that is not made: its check failed, or it cannot be made."""

WITHDRAWN = {
    "symbols": "no symbols: they do not agree with the numbers, so they are withheld",
    "loops": "no symbols: the joint rates do not keep the loops closed, so they are withheld",
    "poses": "withheld: it does not agree with screws displaced by exponentials",
    "branches": "withheld: dimensions or directions are not those of the closure",
    "margins": "withheld: they do not agree with determinants and ranks of the same screws",
    "finite": "undecided: another route does not confirm how the configuration was judged",
}
"""Statement that falls with a failed check -> what is said instead of it."""
NOT_ALONE = "no symbols: other bodies or loops than its limbs, side by side, carry it"
TIED = "no symbols: gears and tendons couple the angles themselves, not their sines and cosines"
AS_MEANT = "no symbols: the geometry meant was solved for in numbers of 60 digits"
SOLVED_FOR = "the geometry meant was solved for in 60 digits"
IN_SYMBOLS = frozenset({"symbols", "loops", "poses", "finite"})
"""What geometry that was solved for has no symbols for, and judges by its numbers alone."""
