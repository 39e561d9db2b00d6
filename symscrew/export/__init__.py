"""Printers: one small module per target language, over one shared traversal, without algebra.

`symscrew.export.listing` walks a program; `c`, `casadi`, `numpy` and `latex` say how an operation looks.
Nothing here writes files: `symscrew.generation` does.
"""
