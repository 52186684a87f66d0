# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""All pairs of boxes that meet, a frame: `automatic` against FCL.

FCL is taken at its best in the same scene: updated, or with all objects registered anew. With
100,000 boxes in random motion nothing of it ends in time, and its coherent motion stands in."""
import argparse
import math
import subprocess

from figure import Figures

PROGRAM = ["taskset", "-c", "1", "rosrun", "collision_monitor",
           "collision_monitor_broad_phase_bench"]
FCL = ("fcl_tree", "fcl_tree_anew", "fcl_sap")
# How many times as fast as FCL.
GOALS = {("coherent", 100): 3.9, ("coherent", 1000): 4.4, ("coherent", 10000): 3.1,
         ("coherent", 100000): 3.7, ("random", 100): 6.7, ("random", 1000): 7.9,
         ("random", 10000): 24.7, ("random", 100000): 2.0}
STYLES = {"fcl_tree": "--", "fcl_tree_anew": "--", "fcl_sap": "--",
          "fcl_spatial_hash": "--", "bullet_dbvt": ":", "bullet_sweep": ":"}


def measure(*arguments):
    """{(scene, number): {method: microseconds}}"""
    run = subprocess.run([*PROGRAM, *arguments], capture_output=True, text=True, check=True)
    times = {}
    for line in run.stdout.splitlines():
        scene, number, method, microseconds, _ = line.split()
        times.setdefault((scene, int(number)), {})[method] = float(microseconds)
    return times


def add_rows(figures):
    times = {**measure("coherent"), **measure("random")}
    for (scene, number), goal in GOALS.items():
        ours = times[(scene, number)]["automatic"]
        peers = {method: time for method, time in times[(scene, number)].items() if method in FCL}
        fcl = min((peers or times[("coherent", number)]).get(method, math.inf) for method in FCL)
        figures.add(f"broad phase, {scene}, {number} boxes", f"{ours:.1f} us", f"{fcl:.1f} us",
                    f"{fcl / ours:.1f} times as fast as FCL, {goal} wanted", fcl / ours >= goal)


def plot(file):
    import matplotlib  # pylint: disable=import-outside-toplevel
    matplotlib.use("Agg")
    from matplotlib import pyplot  # pylint: disable=import-outside-toplevel
    times = measure()
    scenes = list(dict.fromkeys(scene for scene, _ in times))
    methods = sorted({method for row in times.values() for method in row})
    colours = dict(zip(methods, pyplot.get_cmap("tab20").colors[::2] +
                       pyplot.get_cmap("tab20").colors[1::2]))
    figure, axes = pyplot.subplots(2, 2, figsize=(11, 9), sharex=True, sharey=True)
    for axis, scene in zip(axes.flat, scenes):
        rows = {number: row for (name, number), row in times.items() if name == scene}
        for method in methods:
            numbers = sorted(number for number, row in rows.items() if method in row)
            axis.loglog(numbers, [rows[number][method] for number in numbers],
                        STYLES.get(method, "-"), marker=".", label=method, color=colours[method],
                        linewidth=3 if method == "automatic" else 1.2)
        axis.set_title(scene)
        axis.grid(True, which="major", alpha=0.4)
        axis.set_xlabel("boxes")
        axis.set_ylabel("us a frame")
    axes.flat[0].legend(fontsize="small")
    figure.tight_layout()
    figure.savefig(file)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--plot", metavar="FILE",
                        help="draw every method in every scene instead; needs python3-matplotlib")
    arguments = parser.parse_args()
    if arguments.plot:
        plot(arguments.plot)
        return
    figures = Figures()
    add_rows(figures)
    figures.finish()


if __name__ == "__main__":
    main()
