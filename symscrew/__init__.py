"""symscrew: symbolic models of mechanisms on screw theory, with code export."""

__version__ = "0.1.0"
