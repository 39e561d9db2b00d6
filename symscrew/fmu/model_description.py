"""modelDescription.xml of FMI 2.0 and 3.0: the variables of a unit, their units and how they depend on each other.

2.0: <ScalarVariable><Real/></ScalarVariable>, indices from 1       3.0: <Float64/>, value references from 0
"""

from __future__ import annotations

from collections.abc import Sequence
from xml.etree.ElementTree import Element, SubElement, indent, tostring

from symscrew import __version__
from symscrew.fmu.unit_variables import Variable

# unit -> exponents of the SI base units, which the standards ask for; a unit that is not here goes by its name alone
BASE_UNITS = {
    "s": {"s": 1}, "m": {"m": 1}, "rad": {"rad": 1}, "kg": {"kg": 1}, "m/s": {"m": 1, "s": -1},
    "rad/s": {"rad": 1, "s": -1}, "m/s^2": {"m": 1, "s": -2}, "rad/s^2": {"rad": 1, "s": -2},
    "N": {"kg": 1, "m": 1, "s": -2}, "N m": {"kg": 1, "m": 2, "s": -2}, "kg m^2": {"kg": 1, "m": 2},
    "1/s": {"s": -1}, "N/m": {"kg": 1, "s": -2}, "N s/m": {"kg": 1, "s": -1}, "m^2": {"m": 2},
}  # fmt: skip


def describe(
    listed: Sequence[Variable], *, version: int, name: str, token: str, text: str, duration: float, step: float
) -> bytes:
    """The model description.

    Args:
        listed: the variables, in the order of their value references.
        version: of FMI, 2 or 3.
        name: the model identifier.
        token: by which an importer tells that sources and description belong together.
        text: what the model is.
        duration: default length of a simulation [s].
        step: default communication step [s].
    """
    root = Element("fmiModelDescription", {
        "fmiVersion": f"{version}.0", "modelName": name, "description": text,
        "instantiationToken" if version == 3 else "guid": token,
        "generationTool": f"symscrew {__version__}", "variableNamingConvention": "structured",
        **({"numberOfEventIndicators": "0"} if version == 2 else {}),
    })  # fmt: skip
    states = {"canGetAndSetFMUState": "true", "canSerializeFMUState": "true"}
    if version == 2:
        states = {key.replace("FMUState", "FMUstate"): value for key, value in states.items()}
    exchange = SubElement(root, "ModelExchange", {"modelIdentifier": name, **states})
    stepping = {"canHandleVariableCommunicationStepSize": "true", **states}
    simulation = SubElement(root, "CoSimulation", {"modelIdentifier": name, **stepping})
    if version == 2:
        for part in (exchange, simulation):
            SubElement(SubElement(part, "SourceFiles"), "File", {"name": f"{name}.c"})
    _units(root, listed)
    categories = SubElement(root, "LogCategories")
    for category in ("logStatusError", "logAll"):
        SubElement(categories, "Category", {"name": category})
    SubElement(root, "DefaultExperiment", {"startTime": "0", "stopTime": repr(duration), "stepSize": repr(step)})
    parts = SubElement(root, "ModelVariables")
    for reference, variable in enumerate(listed):
        (_two if version == 2 else _three)(parts, reference, variable)
    _structure(version, root, listed)
    indent(root)
    body: bytes = tostring(root, encoding="utf-8")
    return b'<?xml version="1.0" encoding="UTF-8"?>\n' + body


def _units(root: Element, listed: Sequence[Variable]) -> None:
    definitions = SubElement(root, "UnitDefinitions")
    for unit in sorted({variable.unit for variable in listed}):
        entry = SubElement(definitions, "Unit", {"name": unit})
        base = {} if unit == "1" else BASE_UNITS.get(unit)
        if base is not None:
            SubElement(entry, "BaseUnit", {key: str(power) for key, power in base.items()})


def _initial(variable: Variable) -> dict[str, str]:
    if variable.causality in ("independent", "input"):
        return {}
    return {"initial": "exact" if variable.start is not None else "calculated"}


def _two(parts: Element, reference: int, variable: Variable) -> None:
    entry = SubElement(parts, "ScalarVariable", {
        "name": variable.name, "valueReference": str(reference), "description": variable.description,
        "causality": variable.causality, "variability": variable.variability, **_initial(variable),
    })  # fmt: skip
    real = {"unit": variable.unit}
    if variable.start is not None:
        real["start"] = repr(variable.start)
    if variable.derivative is not None:
        real["derivative"] = str(variable.derivative + 1)
    SubElement(entry, "Real", real)


def _three(parts: Element, reference: int, variable: Variable) -> None:
    entry = {
        "name": variable.name, "valueReference": str(reference), "description": variable.description,
        "causality": variable.causality, "variability": variable.variability, **_initial(variable),
        "unit": variable.unit,
    }  # fmt: skip
    if variable.start is not None:
        entry["start"] = repr(variable.start)
    if variable.derivative is not None:
        entry["derivative"] = str(variable.derivative)
    SubElement(parts, "Float64", entry)


def _structure(version: int, root: Element, listed: Sequence[Variable]) -> None:
    structure = SubElement(root, "ModelStructure")
    outputs = [k for k, variable in enumerate(listed) if variable.causality == "output"]
    rates = [k for k, variable in enumerate(listed) if variable.derivative is not None]
    if version == 2:
        for tag, chosen in (("Outputs", outputs), ("Derivatives", rates), ("InitialUnknowns", rates)):
            if chosen:
                group = SubElement(structure, tag)
                for k in chosen:
                    SubElement(group, "Unknown", {"index": str(k + 1)})
        return
    for tag, chosen in (("Output", outputs), ("ContinuousStateDerivative", rates), ("InitialUnknown", rates)):
        for k in chosen:
            SubElement(structure, tag, {"valueReference": str(k)})
