"""What happened over time, as columns with names and units: for pandas, xarray, a notebook, a file.

    named arrays --Columns--> columns["q.limb1_P"], .pandas(), .xarray(), .save("run.csv")

Names are `q.LABEL`, `v.LABEL`, `a.LABEL`, `u.LABEL`, `reactions.JOINT.fx` ..., `margins.NAME`, `energy.kinetic`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from symscrew import notebook
from symscrew.errors import DescriptionError, did_you_mean
from symscrew.whole_files import replaced

Array = np.ndarray
FORMATS = (".csv", ".npz")  # ends of names of files that they can be written into


@dataclass(frozen=True, repr=False)
class Columns:
    """Columns (n,) over the times `t` (n,) [s], with their units; the keys are names as `q.LABEL`."""

    name: str
    t: Array
    columns: Mapping[str, Array]
    units: Mapping[str, str]

    def __repr__(self) -> str:
        span = f" from {self.t[0]:g} s to {self.t[-1]:g} s" if len(self.t) else ""
        return f"Columns({self.name}: {len(self.t)} states{span}, {len(self.columns)} columns)"

    def __getitem__(self, column: str) -> Array:
        """The column of this name, (n,). Raises DescriptionError where there is none."""
        if column not in self.columns:
            raise DescriptionError(
                f"expected the name of a column, got {column!r}; {did_you_mean(column, list(self.columns))}"
            )
        return self.columns[column]

    def pandas(self) -> Any:
        """A `pandas.DataFrame`, indexed by t [s]; units by column in `.attrs["units"]`. Needs pandas."""
        pandas = _library("pandas")
        frame = pandas.DataFrame(dict(self.columns), index=pandas.Index(self.t, name="t"))
        frame.attrs["units"] = dict(self.units)
        return frame

    def xarray(self) -> Any:
        """An `xarray.Dataset` over t [s], with `units` in the attributes of each variable. Needs xarray."""
        xarray = _library("xarray")
        made = {name: ("t", column, {"units": self.units[name]}) for name, column in self.columns.items()}
        return xarray.Dataset(made, coords={"t": ("t", self.t, {"units": "s"})}, attrs={"name": self.name})

    def save(self, path: str | Path) -> Path:
        """Write .csv (a column each, first `t`) or .npz (`t`, an array each, `columns` and `units` as texts).

        Raises:
            DescriptionError: the name ends in something else.
        """
        file = Path(path)
        if file.suffix not in FORMATS:
            raise DescriptionError(f"expected a file name that ends in .csv or .npz, got {file.name!r}")
        return replaced(file, self._table if file.suffix == ".csv" else self._archive)

    def _table(self, file: Path) -> None:
        rows = np.stack([self.t, *self.columns.values()], axis=1)
        np.savetxt(file, rows, delimiter=",", header=",".join(["t", *self.columns]), comments="", fmt="%.17g")

    def _archive(self, file: Path) -> None:
        texts = {"columns": np.array(list(self.columns)), "units": np.array([self.units[n] for n in self.columns])}
        np.savez_compressed(file, t=self.t, **texts, **self.columns)  # type: ignore[arg-type]

    def _repr_html_(self) -> str:
        rows = [
            (name, self.units[name], f"{c[0]:.6g}", f"{c.min():.6g}", f"{c.max():.6g}", f"{c[-1]:.6g}")
            for name, c in self.columns.items()
            if len(c)
        ]
        return notebook.table(repr(self), ("column", "unit", "first", "least", "largest", "last"), rows)


def _library(name: str) -> Any:
    """A library that this package does without."""
    from importlib import import_module

    try:
        return import_module(name)
    except ImportError as error:
        raise ImportError(f'{name} is not installed: pip install "symscrew[tables]"') from error
