# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects: until they are watched, the memory that they take, and a cycle with 10,000 of them, as world_bench
and crowd_bench print them beside the densest robots. Times begin when a service call arrives and end between two cycles.

Pairs that never touch, as `rosrun collision_monitor pairs` finds them with its default limit of time.
A pair that is truly never in contact touches in no state drawn, so the share that is proven of all pairs
that touch in no state is at most the share of those that truly never touch. Proofs run on all cores."""
import argparse
import re
import subprocess
import time

import late_cycles
import running
from figure import Figures, first_line, package_path, shared_robots

# The least share of pairs that are proven, and within how many seconds.
GOALS = {"panda_moveit": (0.9, 60.0), "atlas": (0.5, None)}
# Others reach into the nearer objects, and take longer for what they touch.
CROWDED = "atlas"
DENSE = ["atlas", "tiago_dual", "icub", "stretch"]
# [ms] until objects are watched.
OBJECT_GOALS = {"1000 boxes": 50.0, "10000 boxes": 1000.0, "a mesh of 100,352 triangles": 150.0}
TIME = re.compile(r"(.*\S) +([\d.]+) ms: ")
MEMORY = re.compile(r" +memory .* ([\d.]+) bytes a pair of (\d+)")
ATTACHED = re.compile(r"attached (\d+) times .* ms a change, (-?[\d.]+) MB more at the end, (\d+) times")
CROWD = re.compile(r"(.*): ([\d.]+) us alone, ([\d.]+) us with them")
COUNT = re.compile(r"(\d+) never(?: \((\d+) proven\))?$")


def prove(robot, states):
    """(pairs that touch in no state, those proven, seconds), or a sentence."""
    _, folder, urdf, _, _ = robot
    start = time.monotonic()
    run = subprocess.run(["rosrun", "collision_monitor", "pairs", str(urdf), "--states", str(states)],
                         env=package_path(folder), capture_output=True, text=True, check=False)
    taken = time.monotonic() - start
    count = COUNT.search(run.stdout.strip()) if run.returncode == 0 else None
    return (int(count[1]), int(count[2] or 0), taken) if count else first_line(run)


def add_robot(figures, robot, states):
    found = prove(robot, states)
    name = f"{robot[0]}: pairs that never touch, proven"
    share, limit = GOALS.get(robot[0], (None, None))
    if isinstance(found, str):
        print(f"{name}: {found}")
        figures.not_met += 1
        return
    never, proven, taken = found
    ours = f"{proven} in {taken:.1f} s"
    if share is None:
        figures.tell(name, ours, f"of {never}")
        return
    in_time = limit is None or taken <= limit
    figures.add(name, ours, f"of {never}", f"{share:.0%}" + (f" in {limit:g} s" if limit else ""),
                proven >= share * never and in_time)


def add_objects(figures, robot, times):
    """The figures of one robot; `times` an object is attached and detached."""
    run = subprocess.run(["rosrun", "collision_monitor", "collision_monitor_world_bench", robot, "1000", "10000",
                          "--attach", str(times)], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        print(f"{robot}: objects: {first_line(run)}")
        figures.not_met += 1
        return
    for line in run.stdout.splitlines():
        time_taken = TIME.match(line)
        if time_taken and time_taken[1] in OBJECT_GOALS:
            most = OBJECT_GOALS[time_taken[1]]
            figures.add(f"{robot}: {time_taken[1]}, watched after", f"{time_taken[2]} ms", "", f"{most:g} ms",
                        float(time_taken[2]) <= most)
        if memory := MEMORY.match(line):
            figures.tell(f"{robot}: memory of {memory[2]} pairs of bodies", f"{memory[1]} bytes a pair", "")
        if attached := ATTACHED.match(line):
            figures.add(f"{robot}: attached and detached {attached[1]} times, memory grows by", f"{attached[2]} MB",
                        "", "1 MB", float(attached[2]) <= 1.0)
            figures.add(f"{robot}: attached and detached {attached[1]} times, other verdicts changed", attached[3],
                        "", "0", attached[3] == "0")


def add_crowd(figures, robot):
    """The cycle of a robot that moves, with objects at rest and without."""
    run = subprocess.run(["rosrun", "collision_monitor", "collision_monitor_crowd_bench", robot],
                         capture_output=True, text=True, check=False)
    rows = CROWD.findall(run.stdout)
    if run.returncode != 0 or not rows:
        print(f"{robot}: cycle with objects: {first_line(run)}")
        figures.not_met += 1
    for what, alone, crowded in rows:
        row = (f"{robot}: cycle with {what}", f"{crowded} us", f"{alone} us alone")
        if robot == CROWDED:
            figures.add(*row, "2 times", float(crowded) <= 2.0 * float(alone))
        else:
            figures.tell(*row)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--states", type=int, default=50000, help="drawn for each robot")
    parser.add_argument("--robots", nargs="+", default=list(GOALS), metavar="ROBOT",
                        help="these alone, or all")
    parser.add_argument("--times", type=int, default=10000, help="an object is attached and detached so often")
    arguments = parser.parse_args()
    figures = Figures()
    for robot in DENSE:
        add_objects(figures, robot, arguments.times)
        add_crowd(figures, robot)
    with running.master():
        late_cycles.add_robots(figures, [robot for robot in shared_robots()
                                         if robot[0] in (*DENSE, *arguments.robots)
                                         or "all" in arguments.robots and ":" not in robot[0]])  # first URDFs
    for robot in shared_robots():
        if robot[0] in arguments.robots or "all" in arguments.robots:
            add_robot(figures, robot, arguments.states)
    figures.finish()


if __name__ == "__main__":
    main()
