# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of other projects beside panda and fetch, read as a monitor reads its `world_file`: every
verdict of a link against an object beside FCL's, where a slow reference decides differences, and
the time of check_states beside FCL's on the same states and pairs, on one core."""
import argparse
import re
import statistics
import subprocess
import tempfile

from figure import Figures, shared_data, stay_on_one_core
from scene_files import all_sets, scenes_without_meshes

ROWS = ("load", "verdicts", "times")
TIME_GOAL = 20
TIMED_ROBOT = "panda"
ROBOTS = {"panda": "panda_vamp/panda.urdf", "fetch": "fetch/fetch.urdf"}


def measure(robot, files, packages, options):
    """(numbers by name, one dictionary a file; what was said of faults)"""
    command = ["rosrun", "collision_monitor", "collision_monitor_scenes_bench", ROBOTS[robot],
               *options]
    for folder in packages:
        command += ["--packages", str(folder)]
    run = subprocess.run([*command, *map(str, files)], capture_output=True, text=True, check=False)
    found = []
    for line in run.stdout.splitlines():
        words = line.split()
        found.append(dict(zip(words[1::2], map(float, words[2::2]))))
    return found, run.stderr.strip()


def sum_of(found, name):
    return sum(numbers.get(name, 0.0) for numbers in found)


def add_load(figures, label, files, found, faults):
    loaded = sum("objects" in numbers for numbers in found)
    objects = sum_of(found, "objects")
    figures.add(f"{label}: scenes that load", f"{loaded}", f"of {len(files)}",
                f"all ({objects:.0f} objects)", loaded == len(files))
    if loaded < len(files):
        print(faults.splitlines()[0] if faults else "nothing was said", flush=True)


def add_missing_meshes(figures, scenes, packages):
    """Scenes whose meshes are not at hand as they are: each of these meshes must be named."""
    named = missing = 0
    for scene, meshes in scenes:
        _, faults = measure("fetch", [scene], packages, ["--states", "1"])
        named += sum(mesh.removeprefix("package://") in faults for mesh in meshes)
        missing += len(meshes)
    figures.add("scenes that lack meshes: meshes named", f"{named}", f"of {missing}",
                f"every one, in {len(scenes)} scenes", named == missing)


def add_verdicts(figures, label, found, faults):
    wrong = sum_of(found, "ours_wrong")
    figures.add(f"{label}: verdicts, wrong", f"{wrong:.0f}",
                f"{sum_of(found, 'compared'):.0f}",
                f"0 ({sum_of(found, 'contacts'):.0f} contacts; {sum_of(found, 'different'):.0f} "
                f"other than FCL's: {sum_of(found, 'touching'):.0f} just touch, "
                f"{sum_of(found, 'inside'):.0f} inside a mesh, FCL wrong "
                f"{sum_of(found, 'fcl_wrong'):.0f})", wrong == 0)
    states = sum_of(found, "states_wrong")
    figures.add(f"{label}: check_states, wrong", f"{states:.0f}",
                f"{sum_of(found, 'states'):.0f}", "0", states == 0)
    wrong_lines = [line for line in faults.splitlines() if re.match(r"state \d", line)]
    for line in wrong_lines[:3]:
        print(f"  {line}", flush=True)


def add_times(figures, label, robot, found):
    def median_of(part, peer):
        times = [(numbers[part], numbers[peer]) for numbers in found]
        return (statistics.median(ours for ours, _ in times),
                statistics.median(theirs for _, theirs in times),
                statistics.median(theirs / ours for ours, theirs in times))

    ours, theirs, ratio = median_of("objects_us", "objects_fcl_us")
    row = (f"{label}: check_states", f"{ours:.3g} us", f"{theirs:.3g}, {ratio:.3g}x")
    if robot == TIMED_ROBOT:
        figures.add(*row, f"{TIME_GOAL}x FCL's collide", ratio >= TIME_GOAL)
    else:
        figures.tell(*row)
    for title, part, peer in (("FCL to the first contact", "objects_us", "objects_fcl_first_us"),
                              ("links among each other too", "all_us", "all_fcl_us"),
                              ("these, FCL to the first", "all_us", "all_fcl_first_us")):
        ours, theirs, ratio = median_of(part, peer)
        figures.tell(f"  {title}", f"{ours:.3g} us", f"{theirs:.3g}, {ratio:.3g}x")


def add_rows(figures, one, arguments):
    files = one.files[:arguments.scenes]
    options = ["--states", str(arguments.states)]
    if "load" in arguments.rows or "verdicts" in arguments.rows:
        states = options if "verdicts" in arguments.rows else ["--states", "1"]
        found, faults = measure(one.robot, files, one.packages, states)
        if "load" in arguments.rows:
            add_load(figures, one.label, files, found, faults)
        if "verdicts" in arguments.rows:
            add_verdicts(figures, one.label, found, faults)
    if "times" in arguments.rows and one.is_timed:
        found, _ = measure(one.robot, files[:arguments.timed], one.packages,
                           [*options, "--times"])
        add_times(figures, one.label, one.robot, [one for one in found if "objects" in one])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rows", nargs="+", default=ROWS, choices=ROWS)
    parser.add_argument("--only", default="", metavar="TEXT", help="sets whose name holds this")
    parser.add_argument("--scenes", type=int, metavar="N", help="the first of each set (all)")
    parser.add_argument("--timed", type=int, default=5, metavar="N", help="scenes of each set")
    parser.add_argument("--states", type=int, default=1000, help="random ones of each scene")
    arguments = parser.parse_args()
    stay_on_one_core()
    figures = Figures()
    with tempfile.TemporaryDirectory() as folder:
        for one in all_sets(shared_data(), folder):
            if arguments.only in one.label:
                add_rows(figures, one, arguments)
        if "load" in arguments.rows and not arguments.only:
            scenes, packages = scenes_without_meshes(shared_data())
            add_missing_meshes(figures, scenes, packages)
    figures.finish()


if __name__ == "__main__":
    main()
