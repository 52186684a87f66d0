# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Finds all pairs of boxes per frame: `automatic` against the fastest of FCL's managers in the same
scene, updated in each frame as FCL intends. In random motion one manager is faster if all objects
are registered anew; that is a separate row. With 100,000 boxes in random motion no method of FCL
ends in time, so its time in coherent motion is used instead."""
import argparse
import os
import subprocess
import sys

from figure import Figures, stay_on_one_core

PROGRAM = ["rosrun", "collision_monitor", "collision_monitor_broad_phase_bench"]
FCL = ("fcl_tree", "fcl_tree_array", "fcl_sap", "fcl_ssap", "fcl_interval", "fcl_spatial_hash")
# Speed relative to FCL.
GOALS = {("coherent", 100): 3.9, ("coherent", 1000): 4.4, ("coherent", 10000): 3.1,
         ("coherent", 100000): 3.7, ("random", 100): 6.7, ("random", 1000): 7.9,
         ("random", 10000): 24.7, ("random", 100000): 2.0}
# Registering anew takes 0.69 and 0.25 of the time of the fastest manager (fcl_ssap). So these goals
# are the same times of ours: twice the time of a grid swept by hand.
GOALS_ANEW = {("random", 1000): 5.5, ("random", 10000): 6.1}
STYLES = {"fcl": "--", "bullet": ":"}


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

    def add(scene, number, what, fcl, goal):
        ours = times[(scene, number)]["automatic"]
        figures.add(f"broad phase, {scene}, {number} boxes{what}", f"{ours:.1f} us",
                    f"{fcl:.1f} us", f"{fcl / ours:.1f} times as fast as FCL, {goal} wanted",
                    fcl / ours >= goal)

    for (scene, number), goal in GOALS.items():
        peers = [time for method, time in times[(scene, number)].items() if method in FCL]
        coherent = times[("coherent", number)]
        add(scene, number, "", min(peers or [coherent[method] for method in FCL
                                             if method in coherent]), goal)
    for (scene, number), goal in GOALS_ANEW.items():
        add(scene, number, ", FCL anew", times[(scene, number)]["fcl_tree_anew"], goal)


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
                        STYLES.get(method.partition("_")[0], "-"), marker=".", label=method, color=colours[method],
                        linewidth=3 if method == "automatic" else 1.2)
        axis.set_title(scene)
        axis.grid(True, which="major", alpha=0.4)
        axis.set_xlabel("boxes")
        axis.set_ylabel("us a frame")
    handles, labels = axes.flat[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=6, fontsize="small")
    figure.tight_layout(rect=(0.0, 0.08, 1.0, 1.0))  # the legend is below
    figure.savefig(file)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--plot", metavar="FILE",
                        help="draw every method in every scene instead; needs python3-matplotlib")
    parser.add_argument("--force", action="store_true", help="draw over a file that is there already")
    arguments = parser.parse_args()
    if arguments.plot and os.path.exists(arguments.plot) and not arguments.force:
        sys.exit(f"'{arguments.plot}' is there already; give the name of a new file, or --force to replace it")
    stay_on_one_core()
    if arguments.plot:
        plot(arguments.plot)
        return
    figures = Figures()
    add_rows(figures)
    figures.finish()


if __name__ == "__main__":
    main()
