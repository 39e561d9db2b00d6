"""Structured text between drives and a tool: a function block that keeps the last configuration, in LREAL.

    kinematics(inverse := FALSE, joint := drives);     axes X Y Z [m], A B C [rad] of the tool
    kinematics(inverse := TRUE, world := axes);        drives [m, rad]

The same way as in C (`drive_kinematics.c`), but that a step is looked at by the rates at its start, to first order,
in place of the proof: proofs need bounds of rounding, of which nothing is known on a controller. What no such steps
lead to is refused with the statuses of C. Everything is written out, number by number: loops are those of Newton's
method.
"""

from __future__ import annotations

from collections.abc import Sequence

from symscrew.export.drive_kinematics import DriveKinematics
from symscrew.export.drive_kinematics_c import AXES, axes_text
from symscrew.export.listing import banner, check_names, decimal, plain, wrapped
from symscrew.export.structured_text import ANGLE, block_ports, print_structured_text
from symscrew.model import Model
from symscrew.program import Iteration

STEPS, HALVES = 4096, 1024  # configurations of a call at most, and the part of the way that is the smallest step
NEWTON = 24  # steps of Newton's method to the commanded axes: six are enough where it converges
HERE = 1e-11  # of the commanded axes, lengths by the characteristic one: the last digits of what is followed
TOLERANCE = 1e-6  # [m or rad] of drives that the others determine: rounding of encoders, not of the mechanism

REALS = ("sb", "cb", "sc", "cc", "wx", "wy", "wz", "vx", "vy", "vz", "along", "part", "done", "reach", "largest")
INTS = ("i", "j", "k", "best", "count", "turn")


def print_structured_text_drives(model: Model, kinematics: DriveKinematics) -> dict[str, str]:
    """File name to text: `<name>_drives.st`."""
    check_names(model)
    (text,) = print_structured_text(kinematics.model).values()
    name = kinematics.model.name
    about = [*banner(model)[:3], *wrapped(plain(axes_text(kinematics)), later="  ")]
    lines = ["(*", *(f"  {line.replace('*)', '* )')}" for line in about), "*)", text]
    own = _Sizes(kinematics)
    if f"FUNCTION {name}_angle " not in text:
        lines += [ANGLE.replace("MODEL", name), ""]
    wanted = {own.q, own.free, own.free**2, own.joints, 9, 7, 6, 3, *([len(own.parameters)] if own.parameters else [])}
    types = [size for size in sorted(wanted) if f" {name}_vector{size} :" not in text]
    if types:
        lines += ["TYPE", *(f"  {name}_vector{k} : ARRAY [0..{k - 1}] OF LREAL;" for k in types), "END_TYPE", ""]
    lines += [*_sure(own), "", *_follow(own), "", *_kinematics(own), ""]
    return {f"{name}.st": "\n".join(lines)}


class _Sizes:
    """What the blocks are made of."""

    def __init__(self, kinematics: DriveKinematics) -> None:
        self.kinematics, self.model = kinematics, kinematics.model
        self.name = kinematics.model.name
        system = kinematics.model.system
        self.q, self.v = len(system.tree.q), len(system.tree.v)
        self.free, self.joints = len(kinematics.chosen), len(kinematics.drives)
        self.chosen = [kinematics.driven[k] for k in kinematics.chosen]
        self.length = float(system.length)
        self.parameters = [float(x) for x in system.parameter_values]

    def type(self, size: int) -> str:
        return f"{self.name}_vector{size}"

    def call(self, instance: str, function: str, *given: str) -> str:
        """The call of a block of the model; run-time parameters have their values."""
        program = self.model.programs[function]
        ports, _ = block_ports(program.step if instance == "one_step" and isinstance(program, Iteration) else program)
        values = [*given, *(["parameters"] if len(ports) > len(given) else [])]
        return f"{instance}({', '.join(f'{port} := {x}' for port, x in zip(ports, values, strict=True))});"

    def made(self, instance: str, function: str) -> str:
        """The first output of a block."""
        _, (first, *_) = block_ports(self.model.programs[function])
        return f"{instance}.{first}"

    def declared(self) -> list[str]:
        return [f"  parameters : {self.type(len(self.parameters))};"] if self.parameters else []

    def valued(self) -> list[str]:
        return [f"parameters[{k}] := {number(x)};" for k, x in enumerate(self.parameters)]


def number(value: float) -> str:
    """A constant of LREAL."""
    return decimal(value).replace("e", "E")


def _sum(terms: Sequence[str]) -> str:
    return " + ".join(terms)


def _sure(own: _Sizes) -> list[str]:
    """Whether `next` is where the rates at `from_q` say that steps of the chosen drives lead: within a quarter."""
    null, sliding = own.made("rates", "null_space"), set(own.kinematics.sliding)
    lines = [f"FUNCTION_BLOCK {own.name}_sure", "VAR_INPUT", f"  from_q : {own.type(own.q)};"]
    lines += [f"  ways : {own.type(own.free)};", f"  next : {own.type(own.q)};", "END_VAR", "VAR_OUTPUT"]
    lines += ["  sure : BOOL;", "END_VAR", "VAR", f"  rates : {own.name}_null_space;", *own.declared()]
    lines += ["  size : LREAL;", "  error : LREAL;", "  expected : LREAL;", "  off : LREAL;"]
    lines += ["  wx : LREAL;", "  wy : LREAL;", "  wz : LREAL;", "END_VAR", *own.valued()]
    lines += [own.call("rates", "null_space", "from_q"), "size := 0.0;", "error := 0.0;"]

    def rate(k: int) -> str:
        return _sum([f"{null}[{k + j * own.v}] * ways[{j}]" for j in range(own.free)])

    scalar = dict(own.kinematics.scalar)
    for k, v in scalar.items():
        unit = number(1 / own.length if k in sliding else 1.0)
        lines += [f"expected := ({rate(v)}) * {unit};", f"off := (next[{k}] - from_q[{k}]) * {unit} - expected;"]
        lines += ["size := size + expected * expected;", "error := error + off * off;"]
    for q, v in _turns(own):
        lines += [f"w{axis} := {rate(v + i)};" for i, axis in enumerate("xyz")]
        w, x, y, z = (f"from_q[{q + i}]" for i in range(4))
        rates = [
            f"-0.5 * ({x} * wx + {y} * wy + {z} * wz)", f"0.5 * ({w} * wx + {y} * wz - {z} * wy)",
            f"0.5 * ({w} * wy + {z} * wx - {x} * wz)", f"0.5 * ({w} * wz + {x} * wy - {y} * wx)",
        ]  # fmt: skip
        for i, text in enumerate(rates):
            lines += [f"expected := {text};", f"off := next[{q + i}] - from_q[{q + i}] - expected;"]
            lines += ["size := size + expected * expected;", "error := error + off * off;"]
    # of steps below 1e-10 only rounding is left
    lines += ["sure := rates.valid AND error <= 0.0625 * size + 1.0E-20;", "END_FUNCTION_BLOCK"]
    return _wrapped(lines)


def _turns(own: _Sizes) -> list[tuple[int, int]]:
    """First entries of quaternions in q, and of their rates in v."""
    links = own.model.system.tree.links[1:]
    return [(link.q.start, link.v.start) for link in links if link.motion.spherical]


def _follow(own: _Sizes) -> list[str]:
    """The configuration at `drive` (the chosen ones) on the mode of `from_q`, by steps that are halved."""
    lines = [f"FUNCTION_BLOCK {own.name}_follow", "VAR_INPUT", f"  drive : {own.type(own.free)};"]
    lines += [f"  from_q : {own.type(own.q)};", "END_VAR", "VAR_OUTPUT", f"  q : {own.type(own.q)};"]
    lines += ["  status : INT;", "END_VAR", "VAR", f"  close : {own.name}_assemble;", f"  look : {own.name}_sure;"]
    lines += [f"  target : {own.type(own.free)};", f"  ways : {own.type(own.free)};", *own.declared()]
    lines += ["  part : LREAL;", "  done : LREAL;", "  reach : LREAL;", "  count : INT;", "  good : BOOL;", "END_VAR"]
    lines += [*own.valued(), "q := from_q;", "part := 1.0;", "done := 0.0;", "count := 0;", "status := 0;"]
    lines += [f"WHILE count < {STEPS} AND done < 1.0 AND status = 0 DO", "  count := count + 1;"]
    lines += ["  reach := done + part;", "  IF reach > 1.0 THEN", "    reach := 1.0;", "  END_IF;"]
    for j, at in enumerate(own.chosen):
        lines += [f"  target[{j}] := from_q[{at}] + (drive[{j}] - from_q[{at}]) * reach;"]
        lines += ["  IF reach = 1.0 THEN", f"    target[{j}] := drive[{j}];", "  END_IF;"]
        lines += [f"  ways[{j}] := target[{j}] - q[{at}];"]
    made = own.made("close", "assemble")
    lines += [f"  {own.call('close', 'assemble', 'target', 'q')}", "  good := FALSE;"]
    lines += ["  IF close.status = 2 OR close.status = 5 THEN", "    status := close.status;", "  END_IF;"]
    lines += ["  IF close.status = 0 THEN", f"    look(from_q := q, ways := ways, next := {made});"]
    lines += ["    good := look.sure;", "  END_IF;", "  IF good THEN", f"    q := {made};", "    done := reach;"]
    lines += [
        "    part := 2.0 * part;",
        "  ELSE",
        "    part := 0.5 * part;",
        f"    IF part < {number(1 / HALVES)} THEN",
    ]
    lines += ["      status := 101;", "    END_IF;", "  END_IF;", "END_WHILE;"]
    lines += ["IF status = 0 AND done < 1.0 THEN", "  status := 101;", "END_IF;", "END_FUNCTION_BLOCK"]
    return lines


def _world(own: _Sizes, source: str, indent: str) -> list[str]:
    """`at` and `now_axes` of the tool at a configuration; FALSE in `seen` where there are none."""
    pose, first = own.made("place", "body_poses"), 12 * own.kinematics.platform
    r = [f"{pose}[{first + k}]" for k in range(9)]
    lines = [own.call("place", "body_poses", source), "seen := place.valid;"]
    for i in range(3):
        terms = [f"{r[i + 3 * j]} * (tool[{j}] + {number(x)})" for j, x in enumerate(own.kinematics.tool)]
        lines += [f"tip[{i}] := {pose}[{first + 9 + i}] + {_sum(terms)};", f"now_axes[{i}] := tip[{i}];"]
    lines += [f"now_axes[3] := {own.name}_angle({r[5]}, {r[8]});"]
    lines += [f"now_axes[4] := {own.name}_angle(-{r[2]}, SQRT({r[0]} * {r[0]} + {r[1]} * {r[1]}));"]
    lines += [f"now_axes[5] := {own.name}_angle({r[1]}, {r[0]});"]
    return [indent + line for line in lines]


def _kinematics(own: _Sizes) -> list[str]:
    """The block that keeps the configuration."""
    closed = bool(own.kinematics.pose.entries)
    blocks = {"place": "body_poses", "rates": "null_space", "screws": "platform_jacobian"}
    blocks = {"place": "body_poses", "solve": "inverse_kinematics"} if closed else blocks
    lines = [f"FUNCTION_BLOCK {own.name}_kinematics", "VAR_INPUT", "  inverse : BOOL;", "  reset : BOOL;"]
    lines += [f"  joint : {own.type(own.joints)};", f"  world : {own.type(6)};", f"  tool : {own.type(3)};", "END_VAR"]
    lines += ["VAR_OUTPUT", f"  axes : {own.type(6)};", f"  drives : {own.type(own.joints)};"]
    lines += [f"  q : {own.type(own.q)};", "  status : INT;", "  valid : BOOL;", "END_VAR", "VAR"]
    lines += [f"  {instance} : {own.name}_{function};" for instance, function in blocks.items()]
    lines += [f"  lead : {own.name}_follow;", f"  look : {own.name}_sure;", *own.declared()]
    lines += [f"  y : {own.type(own.free)};", f"  found : {own.type(own.q)};", f"  tip : {own.type(3)};"]
    lines += [f"  now_axes : {own.type(6)};", "  started : BOOL;", "  seen : BOOL;", "  total : LREAL;"]
    back = _closed(own) if closed else _newton(own)
    lines += [*back[0], "END_VAR", *own.valued(), "IF reset OR NOT started THEN"]
    lines += [f"  q[{k}] := {number(float(x))};" for k, x in enumerate(own.model.system.reference)]
    lines += ["  started := TRUE;", "END_IF;", "status := 0;", "IF inverse THEN", *(f"  {x}" for x in back[1]), "ELSE"]
    lines += [f"  total := {_sum([f'ABS(joint[{k}])' for k in range(own.joints)])};"]
    lines += ["  IF NOT (total <= 1.0E37) THEN", "    status := 2;", "  ELSE"]
    lines += [f"    y[{j}] := joint[{k}];" for j, k in enumerate(own.kinematics.chosen)]
    lines += ["    lead(drive := y, from_q := q);", "    status := lead.status;", "    found := lead.q;", "  END_IF;"]
    lines += ["  IF status = 0 THEN", *_world(own, "found", "    "), "    IF NOT seen THEN", "      status := 100;"]
    lines += ["    END_IF;", "  END_IF;"]
    for k, entry in enumerate(own.kinematics.driven):
        lines += [f"  IF status = 0 AND ABS(found[{entry}] - joint[{k}]) > {number(TOLERANCE)} THEN"]
        lines += ["    status := 102;", "  END_IF;"]
    lines += ["  IF status = 0 THEN", "    q := found;", "    axes := now_axes;", "  END_IF;", "END_IF;"]
    lines += ["valid := status = 0;", "END_FUNCTION_BLOCK"]
    return _wrapped(lines)


def _wrapped(lines: Sequence[str]) -> list[str]:
    """Long statements on several lines, behind their own blanks."""
    found = []
    for text in lines:
        blanks = " " * (len(text) - len(text.lstrip()))
        found += wrapped(text.strip(), first=blanks, later=blanks + "  ")
    return found


def _update(own: _Sizes) -> list[str]:
    """The drives of what was found; a question about a far pose does not move where the machine is."""
    lines = ["IF status = 0 THEN"]
    lines += [f"  drives[{k}] := found[{entry}];" for k, entry in enumerate(own.kinematics.driven)]
    lines += [f"  y[{j}] := found[{at}] - q[{at}];" for j, at in enumerate(own.chosen)]
    return [*lines, "  look(from_q := q, ways := y, next := found);", "  IF look.sure THEN", "    q := found;",
            "  END_IF;", "END_IF;"]  # fmt: skip


def _orientation(own: _Sizes, source: str) -> list[str]:
    """The sign of the branch at a configuration, as `one_step.orientation[0]`."""
    step = own.model.programs["assemble"]
    assert isinstance(step, Iteration)
    lines = [f"y[{j}] := {source}[{at}];" for j, at in enumerate(own.chosen)]
    return [*lines, own.call("one_step", "assemble", source, "y")]


def _pose(name: str) -> str:
    """A variable for X, Y, Z of the platform or w, x, y, z of its rotation: they differ in more than case."""
    return f"shift_{name.lower()}" if name.isupper() else f"pose_{name}"


def _closed(own: _Sizes) -> tuple[list[str], list[str]]:
    """Further variables, and the way back in closed form, on the mode of the last configuration."""
    pose = own.kinematics.pose
    step = own.model.programs["assemble"]
    assert isinstance(step, Iteration)
    _, results = block_ports(step.step)
    (port, *_), _ = block_ports(own.model.programs["inverse_kinematics"])
    names = ["sa", "ca", "sb", "cb", "sc", "cc", *(_pose(x) for x in AXES), "branch", *(f"r{k}" for k in range(9))]
    declared = [f"  {name} : LREAL;" for name in names]
    declared += [f"  solve_pose : {own.type(7)};", f"  one_step : {own.name}_assemble_step;"]
    lines = [f"total := {_sum([f'ABS(world[{k}])' for k in range(6)])};", "IF NOT (total <= 1.0E37) THEN"]
    lines += ["  status := 2;", "END_IF;"]
    for letter, entry in zip("abc", (3, 4, 5), strict=True):
        lines += [f"s{letter} := SIN(0.5 * world[{entry}]);", f"c{letter} := COS(0.5 * world[{entry}]);"]
    w, x, y, z = (f"pose_{name}" for name in "wxyz")
    lines += [f"{w} := cc * cb * ca + sc * sb * sa;", f"{x} := cc * cb * sa - sc * sb * ca;"]
    lines += [f"{y} := cc * sb * ca + sc * cb * sa;", f"{z} := sc * cb * ca - cc * sb * sa;"]
    entries = [
        f"1.0 - 2.0 * ({y} * {y} + {z} * {z})", f"2.0 * ({x} * {y} + {w} * {z})", f"2.0 * ({x} * {z} - {w} * {y})",
        f"2.0 * ({x} * {y} - {w} * {z})", f"1.0 - 2.0 * ({x} * {x} + {z} * {z})", f"2.0 * ({y} * {z} + {w} * {x})",
        f"2.0 * ({x} * {z} + {w} * {y})", f"2.0 * ({y} * {z} - {w} * {x})", f"1.0 - 2.0 * ({x} * {x} + {y} * {y})",
    ]  # fmt: skip
    lines += [f"r{k} := {entry};" for k, entry in enumerate(entries)]
    ends = list(zip(pose.centre, own.kinematics.tool, strict=True))
    for i, axis in enumerate("XYZ"):
        terms = [f"r{i + 3 * j} * ({number(c)} - {number(t)} - tool[{j}])" for j, (c, t) in enumerate(ends)]
        lines += [f"{_pose(axis)} := world[{i}] + {_sum(terms)};"]
    lines += [f"solve_pose[{k}] := {_pose(name)};" for k, name in enumerate(pose.entries)]
    solved = own.made("solve", "inverse_kinematics")
    given = [f"{port} := solve_pose", *(["p := parameters"] if own.parameters else [])]
    lines += ["IF status = 0 THEN", f"  solve({', '.join(given)});", "  status := solve.status;", "END_IF;"]
    lines += ["IF status = 0 THEN", f"  found := {solved};", *(f"  {x}" for x in _orientation(own, "q"))]
    lines += [f"  branch := one_step.{results[3]}[0];", *(f"  {x}" for x in _orientation(own, "found"))]
    lines += [f"  IF NOT (one_step.{results[3]}[0] * branch > 0.0) THEN", "    status := 104;", "  END_IF;", "END_IF;"]
    return declared, [*lines, *_update(own)]


def _jacobian(own: _Sizes, source: str) -> list[str]:
    """The commanded rows of the rates of the axes by the chosen drives, without units, as `a` by columns."""
    null, screws = own.made("rates", "null_space"), own.made("screws", "platform_jacobian")
    lines = [own.call("rates", "null_space", source), own.call("screws", "platform_jacobian", source)]
    lines += ["seen := seen AND rates.valid AND screws.valid;"]
    lines += ["sb := SIN(now_axes[4]);", "cb := COS(now_axes[4]);"]
    lines += ["sc := SIN(now_axes[5]);", "cc := COS(now_axes[5]);"]
    for j, at in enumerate(own.chosen):
        unit = number(own.length if at in set(own.kinematics.sliding) else 1.0)
        for i, name in enumerate(("wx", "wy", "wz", "vx", "vy", "vz")):
            terms = [f"{screws}[{i + 6 * k}] * {null}[{k + j * own.v}]" for k in range(own.v)]
            lines += [f"{name} := {_sum(terms)};"]
        lines += ["along := cc * wx + sc * wy;"]
        rows = [
            "vx + wy * tip[2] - wz * tip[1]", "vy + wz * tip[0] - wx * tip[2]", "vz + wx * tip[1] - wy * tip[0]",
            "along / cb", "cc * wy - sc * wx", "wz + along * sb / cb",
        ]  # fmt: skip
        for i, axis in enumerate(own.kinematics.axes):
            scale = number(1 / own.length if axis < 3 else 1.0)
            lines += [f"a[{i + j * own.free}] := ({rows[axis]}) * {scale} * {unit};"]
    return lines


def _elimination(n: int) -> list[str]:
    """a x = b in place by columns, pivots by size; `seen` is FALSE where one is lost."""
    return f"""\
j := 0;
WHILE j < {n} AND seen DO
  best := j;
  i := j + 1;
  WHILE i < {n} DO
    IF ABS(a[i + j * {n}]) > ABS(a[best + j * {n}]) THEN
      best := i;
    END_IF;
    i := i + 1;
  END_WHILE;
  IF NOT (ABS(a[best + j * {n}]) > 1.0E-9) THEN
    seen := FALSE;
  ELSE
    k := 0;
    WHILE k < {n} DO
      total := a[j + k * {n}];
      a[j + k * {n}] := a[best + k * {n}];
      a[best + k * {n}] := total;
      k := k + 1;
    END_WHILE;
    total := b[j];
    b[j] := b[best];
    b[best] := total;
    i := 0;
    WHILE i < {n} DO
      IF i <> j THEN
        total := a[i + j * {n}] / a[j + j * {n}];
        k := j;
        WHILE k < {n} DO
          a[i + k * {n}] := a[i + k * {n}] - total * a[j + k * {n}];
          k := k + 1;
        END_WHILE;
        b[i] := b[i] - total * b[j];
      END_IF;
      i := i + 1;
    END_WHILE;
  END_IF;
  j := j + 1;
END_WHILE;
""".splitlines()


def _newton(own: _Sizes) -> tuple[list[str], list[str]]:
    """Further variables, and the way back by Newton's iteration along the straight way from the last configuration."""
    n, axes, solved = own.free, own.kinematics.axes, own.made("close", "assemble")
    names = REALS
    declared = [f"  {name} : LREAL;" for name in names] + [f"  {name} : INT;" for name in INTS]
    declared += [f"  a : {own.type(n * n)};", f"  b : {own.type(n)};"]
    declared += [f"  from_axes : {own.type(6)};", f"  goal : {own.type(6)};", f"  trial : {own.type(own.q)};"]
    declared += ["  arrived : BOOL;", "  going : BOOL;", f"  close : {own.name}_assemble;"]
    lines = [f"total := {_sum([f'ABS(world[{k}])' for k in range(6)])};", "found := q;", *_world(own, "q", "")]
    lines += ["IF NOT (total <= 1.0E37) THEN", "  status := 2;", "ELSIF NOT seen THEN", "  status := 100;", "END_IF;"]
    lines += ["from_axes := now_axes;", "part := 1.0;", "done := 0.0;", "count := 0;"]
    lines += [
        f"WHILE count < {STEPS} AND done < 1.0 AND status = 0 DO",
        "  count := count + 1;",
        "  reach := done + part;",
    ]
    lines += ["  IF reach > 1.0 THEN", "    reach := 1.0;", "  END_IF;"]
    for axis in axes:
        way = f"world[{axis}] - from_axes[{axis}]"
        way = way if axis < 3 else f"{own.name}_angle(SIN({way}), COS({way}))"
        lines += [f"  goal[{axis}] := from_axes[{axis}] + ({way}) * reach;"]
    lines += ["  trial := found;", "  arrived := FALSE;", "  going := TRUE;", "  turn := 0;"]
    lines += [f"  WHILE turn < {NEWTON} AND going DO", "    turn := turn + 1;", *_world(own, "trial", "    ")]
    lines += ["    largest := 0.0;"]
    for i, axis in enumerate(axes):
        way = f"goal[{axis}] - now_axes[{axis}]"
        way = f"({way}) * {number(1 / own.length)}" if axis < 3 else f"{own.name}_angle(SIN({way}), COS({way}))"
        lines += [f"    b[{i}] := {way};", f"    IF ABS(b[{i}]) > largest THEN", f"      largest := ABS(b[{i}]);"]
        lines += ["    END_IF;"]
    lines += [
        f"    IF seen AND largest < {number(HERE)} THEN",
        "      arrived := TRUE;",
        "      going := FALSE;",
        "    ELSE",
    ]
    lines += [f"      {line}" for line in [*_jacobian(own, "trial"), *_elimination(n)]]
    for j, at in enumerate(own.chosen):
        unit = number(own.length if at in set(own.kinematics.sliding) else 1.0)
        lines += [f"      y[{j}] := trial[{at}] + b[{j}] / a[{j + j * n}] * {unit};"]
    lines += ["      going := seen;", "      IF seen THEN", f"        {own.call('close', 'assemble', 'y', 'trial')}"]
    lines += [
        "        going := close.valid;",
        f"        trial := {solved};",
        "      END_IF;",
        "    END_IF;",
        "  END_WHILE;",
    ]
    lines += ["  IF arrived THEN", *(f"    y[{j}] := trial[{at}] - found[{at}];" for j, at in enumerate(own.chosen))]
    lines += ["    look(from_q := found, ways := y, next := trial);", "    arrived := look.sure;", "  END_IF;"]
    lines += ["  IF arrived THEN", "    found := trial;", "    done := reach;", "    part := 2.0 * part;", "  ELSE"]
    lines += [
        "    part := 0.5 * part;",
        f"    IF part < {number(1 / HALVES)} THEN",
        "      status := 101;",
        "    END_IF;",
    ]
    lines += ["  END_IF;", "END_WHILE;"]
    return declared, [*lines, *_update(own)]
