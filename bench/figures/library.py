# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The library as its users call it, for joint values: one distances(q) of every pair of exact
geometries, with points and normals, beside FCL's distance of every pair in the same run, in the faster
of two forms: meshes, or convex solids where the geometry is convex. Our time includes placing the
links; FCL's elements are placed before. Times are processor time of one core."""
import os
import subprocess

from figure import Figures, shared_data, stay_on_one_core
from library_python import add_python

PROGRAM = ("rosrun", "collision_monitor", "collision_monitor_library_bench")
# Times as fast as FCL: the goals that `scripts/figures speed` has for every pair of hulls.
GOALS = {"panda_moveit": 10.0, "atlas": 12.0}


def measure(robots):
    """{"robot/figure": microseconds}"""
    run = subprocess.run([*PROGRAM, *robots], capture_output=True, text=True, check=True,
                         env=dict(os.environ, COLLISION_MONITOR_SHARED_DATA=str(shared_data())))
    return {name: float(time) for name, time in map(str.split, run.stdout.splitlines())}


def main():
    stay_on_one_core()
    figures = Figures()
    times = measure(GOALS)
    for robot, goal in GOALS.items():
        ours = times[f"{robot}/every_distance"]
        fcl = min(times[f"{robot}/every_distance/{form}"] for form in ("fcl", "fcl_solids"))
        figures.add(f"{robot}: distances(q), every pair", f"{ours:.4g} us",
                    f"{fcl:.4g}, {fcl / ours:.3g}x", f"{goal:g}x FCL's distance", fcl >= goal * ours)
        for figure in ("every_distance_and_gradient", "distances_within_0.2_m", "check_contact",
                       "check_nearest"):
            figures.tell(f"{robot}: {figure.replace('_', ' ')}", f"{times[f'{robot}/{figure}']:.4g} us",
                         "-")
    add_python(figures)
    figures.finish()


if __name__ == "__main__":
    main()
