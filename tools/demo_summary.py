#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints what the collision monitor reports while a joint path is played, with a summary at the end.

Exit code: 0 if the monitor reported until the end and measured distances; 1 if it never reported or fell silent,
knew no distance, or the path did not finish; 2 if the command line is faulty.
"""
import argparse
import math
import sys
import threading
import time

import rosgraph
import rospy
from collision_monitor.msg import Contacts, LinkDistance, State, PairWarning
from std_msgs.msg import Float64

LEVELS = {State.OK: "ok", State.WARNING: "warning", State.UNKNOWN: "unknown", State.CONTACT: "contact"}
VERDICTS = {PairWarning.CLEAR: "clear", PairWarning.WARNING: "WARNING",
            PairWarning.UNKNOWN: "UNKNOWN", PairWarning.CONTACT: "CONTACT"}
QUALITIES = {LinkDistance.EXACT: "exact", LinkDistance.LOWER_BOUND: "or more", LinkDistance.UNKNOWN: "unknown",
             LinkDistance.ESTIMATE: "or deeper"}
COLOURS = {"clear": "32", "WARNING": "33", "CONTACT": "31", "UNKNOWN": "90"}
LONGEST_SILENCE = 3.0  # [s]; the monitor promises a state at least once a second


class Record:
    """Data of a run, from the first step of the path on, without start-up."""

    def __init__(self):
        self.closest = None
        self.levels = []
        self.changes = {name: 0 for name in VERDICTS.values()}
        self.depths = {}
        self.oldest, self.slowest = 0.0, 0.0
        self.soonest, self.least_scale = math.inf, 1.0
        self.first_cycle = self.last = None
        self.overruns_before = 0

    def add_state(self, state):
        if self.first_cycle is None:
            self.first_cycle, self.overruns_before = state.cycles, state.overruns
        self.last = state
        if state.has_closest and (self.closest is None or state.closest.distance < self.closest.distance):
            self.closest = state.closest
        if not self.levels or self.levels[-1] != LEVELS[state.level]:
            self.levels.append(LEVELS[state.level])
        if not math.isnan(state.time_to_contact):
            self.soonest = min(self.soonest, state.time_to_contact)
        self.least_scale = min(self.least_scale, state.speed_scale)
        self.oldest = max(self.oldest, state.age)
        self.slowest = max(self.slowest, state.cycle_time)

    def add_contacts(self, message):
        for contact in message.contacts:
            pair = (contact.link_a, contact.link_b)
            self.depths[pair] = max(self.depths.get(pair, 0.0), contact.depth)

    def lines(self):
        if self.last is None:
            return ["the monitor published no state on the way"]
        lines = ["way of the state   " + " > ".join(self.levels)]
        if self.closest is None:
            lines.append("closest pair       none: no distance was ever known")
        else:
            lines.append(f"closest pair       {self.closest.link_a} and {self.closest.link_b}: "
                         f"{1000 * self.closest.distance:.1f} mm ({QUALITIES[self.closest.quality]})")
        soonest = "none foretold" if math.isinf(self.soonest) else f"at least {1000 * self.soonest:.0f} ms"
        lines.append(f"time to contact    {soonest}; speed scale at least {self.least_scale:.2f}")
        counted = ", ".join(f"{count} to {name}" for name, count in self.changes.items() if count)
        lines.append(f"changes of verdict {counted or 'none'}")
        contacts = [f"{a} and {b}, {1000 * depth:.1f} mm deep" for (a, b), depth in self.depths.items()]
        lines += ["pairs in contact   " + (contacts[0] if contacts else "none")]
        lines += ["                   " + text for text in contacts[1:]]
        lines.append(f"cycles             {self.last.cycles - self.first_cycle}, slowest {1e6 * self.slowest:.0f} us, "
                     f"{self.last.overruns - self.overruns_before} overruns")
        lines.append(f"age of the data    at most {1000 * self.oldest:.0f} ms")
        return lines


class Reporter:
    """Listens, prints each change at once, and detects the end of the path."""

    def __init__(self, monitor, player):
        self.record, self.lock = Record(), threading.Lock()
        self.progress, self.begin = 0.0, None
        self.heard_at, self.silent = None, 0.0
        self.subscribers = [
            rospy.Subscriber(f"{monitor}/state", State, self.on_state, queue_size=100),
            rospy.Subscriber(f"{monitor}/warnings", PairWarning, self.on_change, queue_size=1000),
            rospy.Subscriber(f"{monitor}/contacts", Contacts, self.on_contacts, queue_size=100),
            rospy.Subscriber(f"{player}/progress", Float64, self.on_progress, queue_size=100)]

    def is_running(self):
        return self.begin is not None

    def on_progress(self, message):
        self.begin = self.begin or time.monotonic()
        self.progress = message.data

    def on_state(self, state):
        with self.lock:
            self.heard_at = time.monotonic()
            if self.is_running():
                self.record.add_state(state)

    def on_contacts(self, message):
        with self.lock:
            if self.is_running():
                self.record.add_contacts(message)

    def on_change(self, change):
        name = VERDICTS[change.after]
        with self.lock:
            if self.is_running():
                self.record.changes[name] += 1
        self.say(name, change.sentence)

    def say(self, name, sentence):
        begin = self.begin or time.monotonic()
        text = f"{name:8}"
        if sys.stdout.isatty():
            text = f"\r\033[K\033[{COLOURS[name]}m{text}\033[0m"
        print(f"{text} {time.monotonic() - begin:6.2f} s  {sentence}", flush=True)

    def show_progress(self):
        state = self.record.last
        if sys.stdout.isatty() and state is not None:
            done = int(20 * self.progress)
            line = f"[{'=' * done:20}] {100 * self.progress:3.0f} %  {state.sentence}"
            print(f"\r\033[K{line[:110]}", end="", flush=True)

    def wait_for_monitor(self, patience):
        deadline = time.monotonic() + patience
        while self.heard_at is None and time.monotonic() < deadline and not rospy.is_shutdown():
            time.sleep(0.05)
        return self.heard_at is not None

    def wait_for_end(self, patience):
        """@return a sentence if the run did not finish, else None."""
        last_progress, moved_at = None, time.monotonic()
        while self.progress < 1.0:
            now = time.monotonic()
            if rospy.is_shutdown():
                return "interrupted before the path was over"
            if now - self.heard_at > LONGEST_SILENCE:
                return f"the monitor fell silent for {now - self.heard_at:.1f} s"
            if self.progress != last_progress:
                last_progress, moved_at = self.progress, now
            elif now - moved_at > patience:
                return f"the player did not move on for {patience:.0f} s"
            self.show_progress()
            time.sleep(0.1)
        time.sleep(0.5)  # for messages still in transit
        return None


def report(reporter, fault):
    """Prints the summary. @return the exit code."""
    if sys.stdout.isatty():
        print("\r\033[K", end="")
    print("\nSummary")
    for line in reporter.record.lines():
        print("  " + line)
    if fault:
        print(f"error: {fault}", file=sys.stderr)
        return 1
    if reporter.record.last is None:
        return 1
    if reporter.record.closest is None:
        print(f"error: no distance was ever known: {reporter.record.last.sentence}", file=sys.stderr)
        return 1
    return 0


def wait_for_master(patience):
    deadline = time.monotonic() + patience
    while not rosgraph.is_master_online():
        if time.monotonic() > deadline:
            return False
        time.sleep(0.1)
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--monitor", default="/collision_monitor", help="the monitor (default %(default)s)")
    parser.add_argument("--player", default="/play_joint_path", help="the player (default %(default)s)")
    parser.add_argument("--patience", type=float, default=30.0, metavar="S", help="longest wait (default %(default)s)")
    options = parser.parse_args(rospy.myargv()[1:])
    if not wait_for_master(options.patience):
        print(f"error: no ROS master at {rosgraph.get_master_uri()} within {options.patience:.0f} s", file=sys.stderr)
        return 1
    rospy.init_node("demo_summary", disable_rosout=True)
    reporter = Reporter(options.monitor, options.player)
    if not reporter.wait_for_monitor(options.patience):
        reason = "interrupted before" if rospy.is_shutdown() else f"{options.patience:.0f} s passed before"
        print(f"error: {reason} anything came on {options.monitor}/state", file=sys.stderr)
        return 1
    return report(reporter, reporter.wait_for_end(options.patience))


if __name__ == "__main__":
    sys.exit(main())
