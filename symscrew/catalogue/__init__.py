"""The mechanisms that come with the package, each a TOML file in this folder."""

from symscrew.catalogue.by_name import find, load, names, text

__all__ = ["find", "load", "names", "text"]
