# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""One line a figure: its name, ours, the peer or reference, the goal, met or NOT MET."""
import json
import os
import pathlib
import sys

PACKAGE = pathlib.Path(__file__).resolve().parents[2]


class Figures:
    """Prints figures as they are measured and remembers whether all were met."""

    def __init__(self):
        self.not_met = 0
        print(f"{'figure':48} {'ours':>12} {'reference':>14}  goal", flush=True)

    def add(self, name, ours, reference, goal, is_met):
        verdict = "met" if is_met else "NOT MET"
        print(f"{name:48} {ours:>12} {reference:>14}  {goal}: {verdict}", flush=True)
        self.not_met += 0 if is_met else 1

    def finish(self):
        print(f"{self.not_met} not met" if self.not_met else "all met")
        sys.exit(1 if self.not_met else 0)


def shared_data():
    """The folder of shared robots; ends the program with a sentence if it is not there."""
    folder = pathlib.Path(os.environ.get("COLLISION_MONITOR_SHARED_DATA",
                                         PACKAGE.parent / "shared" / "data"))
    if not (folder / "robots").is_dir():
        sys.exit(f"no robots in {folder}: set COLLISION_MONITOR_SHARED_DATA to the folder that "
                 "holds 'robots'")
    return folder


def shared_robots():
    """(label, folder, URDF, SRDF or None, missing meshes) of every URDF of the shared data."""
    for description in sorted((shared_data() / "robots").glob("*/robot.json")):
        robot = json.loads(description.read_text(encoding="utf-8"))
        for i, urdf in enumerate(robot["urdf"]):
            label = robot["name"] if i == 0 else f"{robot['name']}:{pathlib.Path(urdf).stem}"
            # An SRDF belongs to the URDF that stands first.
            srdf = description.parent / robot["srdf"][0] if robot["srdf"] and i == 0 else None
            yield (label, description.parent, description.parent / urdf, srdf,
                   robot["missing_collision_meshes"])


def package_path(folder):
    """The environment in which package:// names of a shared robot resolve."""
    environment = dict(os.environ)
    environment["ROS_PACKAGE_PATH"] = f"{folder}:{environment.get('ROS_PACKAGE_PATH', '')}"
    return environment
