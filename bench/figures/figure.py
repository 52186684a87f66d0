# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""One line per figure: its name, ours, the peer or reference, the goal, met or NOT MET."""
import argparse
import json
import os
import pathlib
import subprocess
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

    def tell(self, name, ours, reference):
        """Prints a figure that has no goal."""
        print(f"{name:48} {ours:>12} {reference:>14}", flush=True)

    def finish(self):
        print(f"{self.not_met} not met" if self.not_met else "all met")
        sys.exit(1 if self.not_met else 0)


def stay_on_one_core():
    """Pins this program and all that it starts later: a change of core loses what caches hold."""
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})


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
            # An SRDF belongs to the first URDF.
            srdf = description.parent / robot["srdf"][0] if robot["srdf"] and i == 0 else None
            yield (label, description.parent, description.parent / urdf, srdf,
                   robot["missing_collision_meshes"])


def compare_with_fcl(robot, options):
    """Runs the comparison on one of shared_robots()."""
    _, folder, urdf, srdf, _ = robot
    command = ["rosrun", "collision_monitor", "compare_with_fcl", str(urdf), *options]
    if srdf:
        command += ["--srdf", str(srdf)]
    return subprocess.run(command, env=package_path(folder), capture_output=True, text=True,
                          check=False)


def first_line(run):
    """The first line of output of a program that failed."""
    return ((run.stderr or run.stdout).strip().splitlines() or ["no output"])[0]


def robot_arguments(description, poses):
    """Parses the options of figures about shared robots; also returns the robots asked for."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--poses", type=int, default=poses)
    parser.add_argument("--robot", help="only robots whose name holds this")
    arguments = parser.parse_args()
    robots = [robot for robot in shared_robots()
              if not arguments.robot or arguments.robot in robot[0]]
    return arguments.poses, robots


def package_path(folder):
    """The environment that resolves package:// names of a shared robot."""
    environment = dict(os.environ)
    environment["ROS_PACKAGE_PATH"] = f"{folder}:{environment.get('ROS_PACKAGE_PATH', '')}"
    return environment
