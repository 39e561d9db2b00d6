"""An effect of one's own: the text of its file, as tests put it into a copy of the package."""

MAGNETIC_BRAKE = '''
"""A brake of eddy currents."""

from dataclasses import dataclass

from symscrew.effects.acting import Acting
from symscrew.effects.effect import Effect, Number


@dataclass(frozen=True, repr=False)
class MagneticBrake(Effect):
    """A torque -c w / (1 + (w / w0)^2) [N m] on a joint."""

    joint: str
    c: Number = "0.2"
    w0: Number = 3

    def act(self, acting: Acting) -> None:
        """Brake the joint, and say what power that takes."""
        c, w0 = acting.number(self.c, "c", least=0), acting.number(self.w0, "w0", above=0)
        rate = acting.rate(self.joint, 0)
        ratio = rate / w0
        force = -c * rate / (acting.system.tape.one + ratio * ratio)
        acting.drive(self.joint, 0, force)
        acting.feed(f"magnetic_brake_{self.joint}", force * rate)
'''
