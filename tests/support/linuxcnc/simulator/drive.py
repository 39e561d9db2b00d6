#!/usr/bin/python3
"""In place of LinuxCNC's screen: homes, moves by G-code, writes what came of it as JSON."""

import json
import subprocess
import time

import linuxcnc

command, status, errors = linuxcnc.command(), linuxcnc.stat(), linuxcnc.error_channel()


def pins():
    done = subprocess.run(["halcmd", "show", "pin", "five_barkins"], capture_output=True, text=True, check=True)
    rows = [line.split() for line in done.stdout.splitlines() if "five_barkins" in line]
    return {row[4].partition(".")[2]: row[3] for row in rows if len(row) >= 5}


def moved(x, z):
    """Where the machine is after a move, and what was said of it."""
    command.mdi(f"G1 F6000 X{x:.9f} Z{z:.9f}")
    command.wait_complete(20)
    said = []
    while True:
        error = errors.poll()
        if error is None:
            break
        said.append(error[1])
    status.poll()
    return {"place": list(status.actual_position[:3]), "joints": list(status.joint_actual_position[:2]), "said": said}


for state in (linuxcnc.STATE_ESTOP_RESET, linuxcnc.STATE_ON):
    command.state(state)
    command.wait_complete()
command.mode(linuxcnc.MODE_MANUAL)
command.wait_complete()
command.teleop_enable(0)
command.wait_complete()
command.home(-1)
for _ in range(100):
    time.sleep(0.1)
    status.poll()
    if all(status.homed[:2]):
        break
home = list(status.actual_position[:3])
command.mode(linuxcnc.MODE_MDI)
command.wait_complete()
ways = [(40, 0), (40, 30), (-40, 30), (-40, -30), (0, 0), (0, 350)]
found = [{"wanted": [home[0] + x, home[2] + z], **moved(home[0] + x, home[2] + z)} for x, z in ways]
with open("found.json", "w") as file:
    json.dump({"home": home, "homed": list(status.homed[:2]), "moves": found, "pins": pins()}, file)
