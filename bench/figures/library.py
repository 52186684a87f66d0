# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The library as its users call it, for joint values of a robot in motion: distances(q) of every pair
of exact geometries, with points and normals, nearest(q), and contacts(q) with depths and points. FCL
runs in the same run: the distance of every pair in the faster of two forms (meshes, or convex solids
where the geometry is convex), the least distance and whether each pair is in contact, which skip pairs
by their boxes. Both place their objects; our time includes the kinematics, too. Times are processor
time of one core."""
import os
import subprocess

from figure import Figures, shared_data, stay_on_one_core
from library_python import add_python

PROGRAM = ("rosrun", "collision_monitor", "collision_monitor_library_bench")
# Times as fast as FCL; None: no goal. FCL tells of contacts only whether there are some.
ARM = {"every_distance": 10.0, "nearest": 19.5, "contacts": None}
HUMANOID = {"every_distance": 12.0, "nearest": 37.0, "contacts": None}
GOALS = {"panda_moveit": ARM, "atlas": HUMANOID}
QUESTIONS = {"every_distance": "distances(q), every pair", "nearest": "nearest(q)",
             "contacts": "contacts(q)"}
FORMS = ("fcl", "fcl_solids")


def measure(robots):
    """{"robot/figure": microseconds}"""
    run = subprocess.run([*PROGRAM, *robots], capture_output=True, text=True, check=True,
                         env=dict(os.environ, COLLISION_MONITOR_SHARED_DATA=str(shared_data())))
    return {name: float(time) for name, time in map(str.split, run.stdout.splitlines())}


def main():
    stay_on_one_core()
    figures = Figures()
    times = measure(GOALS)
    for robot, goals in GOALS.items():
        for question, goal in goals.items():
            ours = times[f"{robot}/{question}"]
            fcl = min(times[name] for form in FORMS if (name := f"{robot}/{question}/{form}") in times)
            row = (f"{robot}: {QUESTIONS[question]}", f"{ours:.4g} us",
                   f"FCL {fcl:.4g}, {fcl / ours:.3g}x")
            if goal is None:
                figures.tell(*row)
            else:
                figures.add(*row, f"{goal:g}x", fcl >= goal * ours)
        for figure in ("every_distance_and_gradient", "distances_within_0.2_m", "check_contact",
                       "check_nearest"):
            figures.tell(f"{robot}: {figure.replace('_', ' ')}", f"{times[f'{robot}/{figure}']:.4g} us",
                         "-")
    add_python(figures)
    figures.finish()


if __name__ == "__main__":
    main()
