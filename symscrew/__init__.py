"""symscrew: symbolic models of mechanisms on screw theory, with code export.

    import symscrew
    mechanism = symscrew.load_description("mechanism.toml")   # or symscrew.MechanismBuilder(...).build()
    model = symscrew.derive(mechanism)                        # named straight-line programs
    symscrew.generate(model, "out")                           # C, CasADi, NumPy
    compiled = symscrew.load("out")                           # compiled C, called with NumPy arrays

The names, a line each; `help(symscrew.derive)` and so on say the rest. Units are SI, angles are in rad, vectors in
absolute axes, screws at the origin O.

  to describe
    load_catalogue("four_bar")        -> Mechanism: one of those that come with the package (`symscrew list`)
    load_description("arm.toml")      -> Mechanism: read from a file, validated
    MechanismBuilder("arm")           a Mechanism part by part: .parameter, .body, .joint, .point, .limb, .build()
    Mechanism                         bodies, joints, points, limbs, parameters: exact numbers, frozen
    DescriptionError                  what input is wrong: where, what was expected, what came, the cure
  to derive
    derive(mechanism, effects)        -> Model: every function, by default under gravity alone
    Model                             .programs by name; model("velocity", q, y_dot) -> (results, status) on NumPy
    Effect                            what acts on a mechanism; all kinds are in `symscrew.effects`, one file each
    Gravity((0, 0, "-9.81"))          an Effect: the weight of every body
    ExternalWrench("tool")            an Effect: force and moment at a named point, as an input or given
  to look at
    analyse_mobility(mechanism)       -> Mobility: constraints and freedoms by reciprocal screws; .report() in words
    inverse_kinematics(mechanism, at)  -> Configuration: all coordinates from some, {"z": "1mm"}: .status, .drives
    Quantities(mechanism)             screws, twists, momenta, constraints as formulas: .twist("tool").latex()
    inertial_parameters(mechanism)    -> the parameters pi (10 per body) in which the dynamics are linear
    assembly_modes(mechanism)         -> AssemblyModes: every solution of the closure, certified; of one: assemble
    base_parameters(mechanism)        -> those combinations of pi that a motion can tell apart
    view(mechanism)                   -> Page: in 3-D, of a model or a run too; opened in the browser, or in a notebook
    draw(mechanism)                   -> Picture: .save("seed.pdf"); a notebook shows it
    report(mechanism)                 -> Document: all that is known of it; .save("seed.html")
  to compute
    generate(model, "out")            -> paths of the files: C, CasADi, NumPy and further targets, in one folder
    check("out")                      -> CheckResult: is the folder what would be written today, clean and right?
    load("out")                       -> CompiledModel: compiled.velocity(q, y_dot) on one state or on many
    load_scene("fall.toml")           -> Scene: mechanism, effects, start, drives, integrator
    simulate(scene)                   -> Run: .t, .q, .v, energies, closure error; .ok, .status
    simulate_many(scene, starts)      -> Runs: arrays by name in, arrays of all runs out; .ok, .status of each
    optimise(problem)                 -> Trajectory: of a problem from `symscrew.optimisation.load_problem`
    optimisation_problem(problem)     built once, solved often: .solve(start=..., goal=..., warm=...) -> Trajectory
    assemble(model, {"A": 0.3})       -> AssembledConfiguration: the one nearby: ["B"], .q, .ok; all: assembly_modes
    workspace(mechanism, over)        -> Sweep: ["margin"], .summary; over {"tilt": "0:20deg:21", "azimuth": ...}
    formulas(mechanism)               -> Paper: screws, limbs, wrenches, inverse kinematics; .save("seed.tex")
    drives(mechanism, motion)         -> DriveStudy: .u, .wrenches, .margins, .columns; of a file or expressions in t
    joint_wrenches(model, q, v, a)    -> JointWrenches: ["limb2_S"].about_joint().in_body_axes().force
    __version__                       of the package

The map: rooms in the order of the flow. A file imports only from rooms above its own, through their doors (what
their `__init__` names); `tests/unit/test_structure.py` reads the order from here.

    errors          what input can do wrong, in one sentence
    kinds           what public functions are given, held against what their signatures say
    doors           rooms whose parts are imported when somebody asks for them
    garbage         times at which nobody searches for unused objects
    workers         processes that end with the one that started them
    notebook        how objects look in a notebook: tables and texts as HTML
    whole_files     files and folders that are there whole or not at all
    array_archives  archives of arrays by anybody, read within bounds
    description     mechanisms as people write them: bodies, joints, limbs, parameters; TOML
    reference       independent formulations that results are held against: maximal coordinates, Newton-Euler
    formats         URDF and MJCF
    catalogue       the mechanisms that come with the package
    algebra         screws; the tape of nodes, its derivatives, elimination and rank volumes
    program         straight-line programs, evaluation, passes, lanes
    kinematics      spanning tree, frames, screws and their rates, momentum screws, cut joints
    mobility        reciprocal screws, finite mobility, branches, proofs; margins of singularities
    effects         what acts on a mechanism: one file each
    loops           rows of cut joints, dependent rates, operation modes, limbs in closed form
    dynamics        balance of every body, drives, reactions, free motion, and derivatives of all these
    functions       the named functions of a model
    model           the pipeline on one page: `derive`
    paper_formulas  formulas for a paper, in names that an author writes
    export          printers: C, CasADi, NumPy, JavaScript, LaTeX, Markdown
    runtime         compiled libraries, called from Python
    assembly        every assembly mode: the closure in Study's parameters, all its zeros, certified
    results         wrenches of joints by name; columns over time for pandas, xarray, files
    display         terminal, plots, drawings, the page in 3-D
    scene           scenes: start, drives, effects, integrator
    simulation      motion of a scene
    optimisation    best motions between conditions
    fmu             functional mock-up units
    generation      folders of generated code: the table of targets
    verification    whether a folder is what the tool would write, and agrees by number
    studies         timing, machine, bill of effects
    studies/demo    the source paper's example from end to end
    studies/given_motion    motion in, tables out: joints, rates, drives, reactions, margins
    studies/accuracy    what accuracy costs in time
    studies/benchmark   functions beside other libraries
    studies/workspace   maps over coordinates and parameters
    studies/certificate boxes of coordinates that are proved free of singularities
    reporting       one document on a mechanism
    cli             the command line

Nothing heavy is imported before it is used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.assembly import assembly_modes as assembly_modes
    from symscrew.catalogue import load as load_catalogue
    from symscrew.description import Mechanism as Mechanism
    from symscrew.description import MechanismBuilder as MechanismBuilder
    from symscrew.description import load_description as load_description
    from symscrew.display import draw as draw
    from symscrew.display import show_page as view
    from symscrew.effects import Effect as Effect
    from symscrew.effects import ExternalWrench as ExternalWrench
    from symscrew.effects import Gravity as Gravity
    from symscrew.errors import DescriptionError as DescriptionError
    from symscrew.functions import Quantities as Quantities
    from symscrew.functions import base_parameters as base_parameters
    from symscrew.functions import inertial_parameters as inertial_parameters
    from symscrew.generation import generate as generate
    from symscrew.mobility import analyse_mobility as analyse_mobility
    from symscrew.mobility import inverse_kinematics as inverse_kinematics
    from symscrew.model import Model as Model
    from symscrew.model import derive as derive
    from symscrew.optimisation import optimisation_problem as optimisation_problem
    from symscrew.optimisation import solve as optimise
    from symscrew.paper_formulas import paper_formulas as formulas
    from symscrew.reporting import report as report
    from symscrew.results import assemble as assemble
    from symscrew.results import joint_wrenches as joint_wrenches
    from symscrew.runtime import load as load
    from symscrew.scene import load_scene as load_scene
    from symscrew.simulation import simulate as simulate
    from symscrew.simulation import simulate_many as simulate_many
    from symscrew.studies.given_motion import drives as drives
    from symscrew.studies.workspace import workspace as workspace
    from symscrew.verification import check as check

__version__ = "0.1.0"

__all__ = [
    "DescriptionError",
    "Effect",
    "ExternalWrench",
    "Gravity",
    "Mechanism",
    "MechanismBuilder",
    "Model",
    "Quantities",
    "__version__",
    "analyse_mobility",
    "assemble",
    "assembly_modes",
    "base_parameters",
    "check",
    "derive",
    "draw",
    "drives",
    "formulas",
    "generate",
    "inertial_parameters",
    "inverse_kinematics",
    "joint_wrenches",
    "load",
    "load_catalogue",
    "load_description",
    "load_scene",
    "optimisation_problem",
    "optimise",
    "report",
    "simulate",
    "simulate_many",
    "view",
    "workspace",
]

__getattr__ = doors(__name__)


def __dir__() -> list[str]:
    return __all__
