"""Values by name that are made when somebody asks for them: programs of functions, states to try them on."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from typing import Any, TypeVar

T = TypeVar("T")


class Asked(Mapping[str, T]):
    """Values that are made when they are first asked for; `given` is what they are made of."""

    def __init__(self, given: Mapping[str, Any], make: Callable[[Any], T]) -> None:
        """`make` makes the value of what is in `given`."""
        self.given, self._make, self._made = given, make, dict[str, T]()

    def __getitem__(self, name: str) -> T:
        """The value, made now if nobody asked before."""
        given = self.given[name]
        if name not in self._made:
            self._made[name] = self._make(given)
        return self._made[name]

    def only(self, names: Collection[str]) -> Asked[T]:
        """Those of these names; what is made for the one is made for the other."""
        few = Asked({name: value for name, value in self.given.items() if name in names}, self._make)
        few._made = self._made
        return few

    def __contains__(self, name: object) -> bool:
        return name in self.given

    def __iter__(self) -> Iterator[str]:
        return iter(self.given)

    def __len__(self) -> int:
        return len(self.given)
