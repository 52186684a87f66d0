# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""One line a figure: its name, ours, the peer or reference, the goal, met or NOT MET."""
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
        """One that has no goal."""
        print(f"{name:48} {ours:>12} {reference:>14}", flush=True)

    def finish(self):
        print(f"{self.not_met} not met" if self.not_met else "all met")
        sys.exit(1 if self.not_met else 0)


def stay_on_one_core():
    """This program and all that it starts from now on: from core to core costs what caches hold."""
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
            # An SRDF belongs to the URDF that stands first.
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
    """What a program that failed said first."""
    return ((run.stderr or run.stdout).strip().splitlines() or ["no output"])[0]


def robot_arguments(description, poses):
    """The options of figures about every shared robot, and those robots that are asked for."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--poses", type=int, default=poses)
    parser.add_argument("--robot", help="only robots whose name holds this")
    arguments = parser.parse_args()
    robots = [robot for robot in shared_robots()
              if not arguments.robot or arguments.robot in robot[0]]
    return arguments.poses, robots


def package_path(folder):
    """The environment in which package:// names of a shared robot resolve."""
    environment = dict(os.environ)
    environment["ROS_PACKAGE_PATH"] = f"{folder}:{environment.get('ROS_PACKAGE_PATH', '')}"
    return environment
