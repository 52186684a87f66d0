# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The cost of the running node: joint states and tf come 1000 times a second, and state, contacts
and distances go out as often. Measures processor time, the time from the arrival of tf to the sent
state, and memory. The reference is a node that answers each tf message at once with such messages
and does nothing else: roscpp's share. Goals of processor time hold for the machine where they were
set; others may take `allowance` times as much. They assume an idle machine, so only the runs count
from which the host of a virtual machine took the least time."""
import contextlib
import os
import pathlib
import statistics
import subprocess
import sys

import running
from figure import shared_robots

SECONDS = 4.0
RUNS = 3
MOST_RUNS = 6
QUIET = 0.015  # [s] a host may take from a run that counts: about one tick of its clock, 10 ms
RATE = 1000
CORE_GOALS = {"panda_moveit": 8.0, "ur5_robotiq": 10.0, "atlas": 15.0, "tiago_pro": 20.0}  # [%]
MEMORY_GOALS = {"panda_moveit": 50.0, "atlas": 150.0, "stretch": 100.0}  # [MB]


def stolen():
    """Seconds that the host of a virtual machine took from this program's cores so far."""
    own = {f"cpu{core}" for core in os.sched_getaffinity(0)}
    lines = [line.split() for line in pathlib.Path("/proc/stat").read_text().splitlines()]
    return sum(int(line[8]) for line in lines if line[0] in own) / os.sysconf("SC_CLK_TCK")


def measure(label, *options):
    """Processor time [%], states per second [Hz], median and 99th percentile of the delay [us] and
    memory [MB] of the running node: medians of the quietest runs."""
    command = ["rosrun", "collision_monitor", "collision_monitor_node_bench", label,
               str(running.process_id(60.0)), str(SECONDS), *options]
    runs = []  # the time stolen from each, and its numbers
    while len(runs) < MOST_RUNS and sum(taken <= QUIET for taken, _ in runs) < RUNS:
        before = stolen()
        run = subprocess.run(command, capture_output=True, text=True, check=True)
        numbers = [float(number) for number in run.stdout.splitlines()[-1].split()]
        runs.append((stolen() - before, numbers))
    quietest = sorted(runs)[:RUNS]
    if quietest[-1][0] > QUIET:
        print(f"(no idle machine: of runs of {SECONDS:g} s its host took "
              f"{1e3 * quietest[0][0]:.0f} to {1e3 * quietest[-1][0]:.0f} ms, at least)")
    return [statistics.median(column) for column in zip(*(numbers for _, numbers in quietest))]


def measure_relay(label):
    with running.running([["rosrun", "collision_monitor", "collision_monitor_relay_node"]]):
        return measure(label)


def add_motion(label, motion, relay, allowance, figures):
    """Adds rows of a robot that swings "free" of contact or stays in "contact" with itself."""
    node = measure(label, motion)

    def add_delay(what, ours, reference, most):
        figures.add(f"node, {label}, {motion}: {what}", f"{ours:.3g} us", f"{reference:.3g} us",
                    f"< {most} us", ours < most)

    def add_share(what, ours, reference, most):
        row = (f"node, {label}, {motion}: {what}", f"{ours:.3g} %", reference)
        if most:
            figures.add(*row, f"< {most:g} % x {allowance:.3g}", ours < most * allowance)
        else:
            figures.tell(*row)

    add_share("of a core at 1 kHz", node[0], f"{relay[0]:.3g} %", CORE_GOALS.get(label))
    figures.add(f"node, {label}, {motion}: states a second", f"{node[1]:.0f}", f"{relay[1]:.0f}",
                "within 2 % of 1000", abs(node[1] - RATE) < 0.02 * RATE)
    # The bench's times include both ways through TCP; subtracting the relay's removes them.
    add_delay("arrival of tf to state sent, median", node[2] - relay[2], relay[2], 300)
    add_delay("tf sent to state received, 99 of 100", node[3], relay[3], 1000)
    add_share("markers at 30 Hz on top", measure(label, motion, "markers")[0] - node[0], "-", 5)


def add_robot(robot, allowance, figures):
    label = robot[0]
    relay = measure_relay(label)
    with running.monitor(robot, {"rate": RATE, "trigger": "pose"}):
        for motion in ("free", "contact"):
            add_motion(label, motion, relay, allowance, figures)
        memory = measure(label)[4]
    row = (f"node, {label}: memory", f"{memory:.3g} MB", f"{relay[4]:.3g} MB")
    if label in MEMORY_GOALS:
        figures.add(*row, f"< {MEMORY_GOALS[label]:g} MB", memory < MEMORY_GOALS[label])
    else:
        figures.tell(*row)


def chosen_robots(labels):
    """The shared robots with these labels; without labels, those that have goals."""
    robots = {robot[0]: robot for robot in shared_robots()}
    unknown = set(labels) - set(robots)
    if unknown:
        sys.exit(f"--robots: no robot '{min(unknown)}'; there are: {', '.join(robots)}")
    return [robots[label] for label in labels or sorted({*CORE_GOALS, *MEMORY_GOALS})]


@contextlib.contextmanager
def real_time_priority():
    """Imitates an idle machine: other programs do not interrupt what is started within. Changes
    nothing if the user lacks the permission."""
    policy, parameters = os.sched_getscheduler(0), os.sched_getparam(0)
    try:
        os.sched_setscheduler(0, os.SCHED_RR, os.sched_param(50))
    except PermissionError:
        print("(no permission for real-time priority: others' work is in the figures of the node)")
    try:
        yield
    finally:
        os.sched_setscheduler(0, policy, parameters)


def add_rows(figures, allowance, labels):
    robots = chosen_robots(labels)
    with real_time_priority(), running.master():
        for robot in robots:
            add_robot(robot, allowance, figures)
