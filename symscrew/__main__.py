"""`python -m symscrew`: the same as the command `symscrew`."""

from symscrew.cli import main

raise SystemExit(main())
