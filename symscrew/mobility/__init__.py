"""Mobility by reciprocal screws: instantaneous and finite, with the evidence for every rank."""

from symscrew.mobility.analysis import Mobility, analyse_mobility
from symscrew.mobility.instantaneous import BodyFreedoms, LimbMobility
from symscrew.mobility.screw_systems import ScrewSystem

__all__ = ["BodyFreedoms", "LimbMobility", "Mobility", "ScrewSystem", "analyse_mobility"]
