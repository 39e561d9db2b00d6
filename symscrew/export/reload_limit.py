"""An option of gcc for long functions."""

# Without it the register allocation of a long function takes most of the time, for no faster code.
SPILLS = "--param=lra-max-considered-reload-pseudos=5"
