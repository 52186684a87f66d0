# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times beside peers in the same run, as ratios: how many times faster, and the goal. Each group is
one benchmark, pinned to one core. Figures are medians of several repetitions, of processor time if
the benchmark measures it. Hulls and meshes stand beside Coal, too, if the benchmarks have it."""
import argparse
import json
import os
import statistics
import subprocess
import sys

import broad_phase
import node_cost
from figure import Figures, shared_data, stay_on_one_core

HUMANOIDS = ("atlas", "icub")

INSTRUCTION_SETS = {"AVX3": 1.0, "AVX2": 0.5}  # the share of a goal that each has to reach

# By group: its program, then (figure, ours, peer, goal).
GROUPS = {
    # Mixed pairs with witness points, against FCL's distance of separated pairs.
    "pairs": ("pairs_bench", [
        (f"{pair}, batches, {instructions}", f"{pair}/mixed/batch_{instructions}",
         f"{pair}/separated/fcl_distance", goal * share)
        for pair, goal in (("sphere-box", 11.4), ("capsule-capsule", 13.2), ("capsule-box", 61.5),
                           ("box-box", 21.6))
        for instructions, share in INSTRUCTION_SETS.items()]),
    "hulls": ("convex_bench", [
        (f"hulls of {n} vertices, {words}", f"hull{n}-hull{n}/{case}/warm",
         f"hull{n}-hull{n}/{case}/{peer}", goal)
        for n, case, words, peer, goal in (
            (64, "apart_1cm", "1 cm apart", "fcl_distance", 5.0),
            (256, "apart_1cm", "1 cm apart", "fcl_distance", 4.9),
            (64, "deep_1cm", "1 cm deep", "fcl_signed", 6.9),
            (256, "deep_1cm", "1 cm deep", "fcl_signed", 7.7))]),
    "meshes": ("mesh_bench", [
        ("meshes of 50,000, build", "build", "fcl_build", 7.1),
        ("meshes, overlap test at 1 cm", "gap_1cm/overlap", "gap_1cm/fcl_overlap", 5.7),
        ("meshes, distance at 1 cm, cold", "gap_1cm/distance_cold", "gap_1cm/fcl_distance", 10.1),
        ("meshes, distance at 1 cm, coherent", "gap_1cm/distance_warm", "gap_1cm/fcl_distance",
         21.8)]),
    "poses": ("poses_bench", [
        ("poses of 11 links, peer tf2", "arm_11_links/read/manual_time",
         "arm_11_links/tf2/manual_time", 1.5),
        ("poses of 60 links, peer tf2", "humanoid_60_links/read/manual_time",
         "humanoid_60_links/tf2/manual_time", 1.8)]),
}

# [ns] FCL's distance of separated pairs, on the machine where the node's goals were set.
FCL_THERE = {"sphere-box": 91.0, "capsule-capsule": 79.0, "capsule-box": 1230.0, "box-box": 864.0}

WITH_LANES = ("hulls", "meshes")  # measured once for each instruction set

# Goals of collision_monitor_states_bench, which prints a table: for panda, for humanoids.
STATE_GOALS = {"capsules/many_states_contact": (23.0, None),
               "capsules/many_states_nearest": (8.0, None)}


def is_missing(run, instructions):
    """Whether a program reports that this machine lacks an instruction set; prints a note if so."""
    missing = run.returncode != 0 and "--only: this machine has" in run.stderr
    if missing:
        print(f"{instructions}: not on this machine, its rows are left out", file=sys.stderr)
    elif run.returncode != 0:
        sys.exit(f"{' '.join(run.args)}: {run.stderr}")
    return missing


def add_states(figures):
    """Adds many states of enclosing shapes, with their kinematics."""
    for instructions, share in INSTRUCTION_SETS.items():
        run = subprocess.run(
            ["rosrun", "collision_monitor", "collision_monitor_states_bench", "panda_moveit", "atlas",
             "icub", "--only", instructions],
            capture_output=True, text=True, check=False,
            env=dict(os.environ, COLLISION_MONITOR_SHARED_DATA=str(shared_data())))
        if is_missing(run, instructions):
            continue
        for line in run.stdout.splitlines():
            robot, _, figure = line.split()[0].partition("/")
            goal = STATE_GOALS.get(figure, (None, None))[robot in HUMANOIDS]
            if goal:
                ours, peer = (float(time) * 1e3 for time in line.split()[1:])
                figures.add(f"{robot}: {figure.replace('_', ' ')}, {instructions}", text(ours),
                            f"{text(peer)}, {peer / ours:.3g}x", f"{goal * share:.3g}x",
                            peer / ours >= goal * share)


def measure(program, names, repetitions, instructions):
    """Median nanoseconds of each benchmark of the program; none without the instruction set."""
    command = ["rosrun", "collision_monitor", f"collision_monitor_{program}",
               "--benchmark_filter=^(" + "|".join(names) + ")$", "--benchmark_format=json",
               "--benchmark_min_time=0.2", f"--benchmark_repetitions={repetitions}",
               "--benchmark_report_aggregates_only=true"]
    command += ["--only", instructions] if instructions else []
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if is_missing(run, instructions):
        return {}
    scale = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}
    times = {}
    for entry in json.loads(run.stdout)["benchmarks"]:
        if entry["aggregate_name"] == "median":
            kind = "real_time" if entry["run_name"].endswith("/manual_time") else "cpu_time"
            times[entry["run_name"]] = (1e9 / entry["items_per_second"]
                                        if "items_per_second" in entry
                                        else entry[kind] * scale[entry["time_unit"]])
    return times


def text(nanoseconds):
    for unit, size in (("ms", 1e6), ("us", 1e3)):
        if nanoseconds >= size:
            return f"{nanoseconds / size:.3g} {unit}"
    return f"{nanoseconds:.3g} ns"


def add_group(group, repetitions, figures, instructions=None):
    """Adds the rows of a group, for one instruction set or for those that the rows name."""
    program, rows = GROUPS[group]
    names = {name for row in rows for name in (*row[1:3], coals(row[2]))}
    times = measure(program, sorted(names), repetitions, instructions)
    for figure, ours, peer, goal in rows:
        if ours not in times:
            continue  # this machine does not have the instruction set
        ratio, goal = times[peer] / times[ours], goal * INSTRUCTION_SETS.get(instructions, 1.0)
        figures.add(figure + (f", {instructions}" if instructions else ""), text(times[ours]),
                    f"{text(times[peer])}, {ratio:.3g}x", f"{goal:.3g}x", ratio >= goal)
        if coals(peer) in times:
            coal = times[coals(peer)]
            figures.tell("  beside Coal", text(times[ours]),
                         f"{text(coal)}, {coal / times[ours]:.3g}x")


def coals(peer):
    """The benchmark of Coal that does what this one of FCL does; there may be none."""
    return peer.replace("fcl", "coal")


def node_allowance(repetitions):
    """The factor on the node's goals of processor time, which have no peer in the same run: FCL's
    time here over its time where the goals were set. Twice that without AVX-512, as for all
    goals."""
    peers = {f"{pair}/separated/fcl_distance": there for pair, there in FCL_THERE.items()}
    with_avx512 = "sphere-box/mixed/batch_AVX3"
    times = measure("pairs_bench", [*peers, with_avx512], repetitions, None)
    pace = statistics.median(times[name] / there for name, there in peers.items())
    share = INSTRUCTION_SETS["AVX3" if with_avx512 in times else "AVX2"]
    print(f"node: goals of processor time are for another machine; FCL takes {pace:.3g} times as long"
          f" here{'' if share == 1.0 else ', and without AVX-512 twice as much is allowed'}", flush=True)
    return pace / share


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--group", choices=[*GROUPS, "states", "broad_phase", "node"],
                        help="one group only")
    parser.add_argument("--robots", nargs="+", default=[], metavar="ROBOT",
                        help="of group node: these alone, also such as have no goals")
    parser.add_argument("--repetitions", type=int, default=5)
    arguments = parser.parse_args()
    stay_on_one_core()
    figures = Figures()
    for group in GROUPS:
        if arguments.group not in (None, group):
            continue
        for instructions in INSTRUCTION_SETS if group in WITH_LANES else [None]:
            add_group(group, arguments.repetitions, figures, instructions)
    if arguments.group in (None, "states"):
        add_states(figures)
    if arguments.group in (None, "broad_phase"):
        broad_phase.add_rows(figures)
    if arguments.group in (None, "node"):
        node_cost.add_rows(figures, node_allowance(arguments.repetitions), arguments.robots)
    figures.finish()


if __name__ == "__main__":
    main()
