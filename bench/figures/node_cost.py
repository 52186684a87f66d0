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

import running
from figure import shared_robots

SECONDS = 4.0
RUNS = 3
MOST_RUNS = 6
QUIET = 0.015  # [s] a host may take from a run that counts: about one tick of its clock, 10 ms
RATE = 1000
# By robot: the allowed share of a core [%], if a goal was set, and memory [MB].
GOALS = {"panda_moveit": (8.0, 50.0), "atlas": (15.0, 150.0), "stretch": (None, 150.0)}


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


def add_motion(label, motion, relay, goal, allowance, figures):
    """Adds rows of a robot that swings "free" of contact or stays in "contact" with itself."""
    node = measure(label, motion)

    def add_delay(what, ours, reference, most):
        figures.add(f"node, {label}, {motion}: {what}", f"{ours:.3g} us", f"{reference:.3g} us",
                    f"< {most} us", ours < most)

    def add_share(what, ours, reference, most):
        figures.add(f"node, {label}, {motion}: {what}", f"{ours:.3g} %", reference,
                    f"< {most:g} % x {allowance:.3g}", ours < most * allowance)

    add_share("of a core at 1 kHz", node[0], f"{relay[0]:.3g} %", goal)
    figures.add(f"node, {label}, {motion}: states a second", f"{node[1]:.0f}", f"{relay[1]:.0f}",
                "within 2 % of 1000", abs(node[1] - RATE) < 0.02 * RATE)
    # The bench's times include both ways through TCP; subtracting the relay's removes them.
    add_delay("arrival of tf to state sent, median", node[2] - relay[2], relay[2], 300)
    add_delay("tf sent to state received, 99 of 100", node[3], relay[3], 1000)
    add_share("markers at 30 Hz on top", measure(label, motion, "markers")[0] - node[0], "-", 5)


def add_robot(robot, allowance, figures):
    label = robot[0]
    most_of_core, most_memory = GOALS[label]
    relay = measure_relay(label)
    with running.monitor(robot, {"rate": RATE, "trigger": "pose"}):
        if most_of_core:
            for motion in ("free", "contact"):
                add_motion(label, motion, relay, most_of_core, allowance, figures)
        memory = measure(label)[4]
        figures.add(f"node, {label}: memory", f"{memory:.3g} MB", f"{relay[4]:.3g} MB",
                    f"< {most_memory:.0f} MB", memory < most_memory)


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


def add_rows(figures, allowance):
    with real_time_priority(), running.master():
        for robot in shared_robots():
            if robot[0] in GOALS:
                add_robot(robot, allowance, figures)
