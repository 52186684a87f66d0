# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The running node beside robot_state_publisher, at 100 Hz on moving robots: whether it keeps the
rate, the time until UNKNOWN after joint states stop, and whether it recovers when they return. Its
cost is a group of speed (node_cost.py)."""
import argparse
import math
import time
import xml.etree.ElementTree as ElementTree

import rospy
from sensor_msgs.msg import JointState

import running
from collision_monitor.msg import State
from figure import Figures, shared_robots

ROBOTS = ("panda_moveit", "ur5_robotiq", "fetch", "atlas")
RATE = 100.0
MAX_AGE = 0.5


def moving_joints(urdf):
    """(name, lower, upper) of the joints that joint states must name."""
    joints = []
    for joint in ElementTree.parse(urdf).getroot().findall("joint"):
        if joint.get("type") not in ("revolute", "continuous", "prismatic"):
            continue
        if joint.find("mimic") is None:
            limit = joint.find("limit")
            low, high = ((-1.0, 1.0) if limit is None else
                         (float(limit.get("lower", -1.0)), float(limit.get("upper", 1.0))))
            joints.append((joint.get("name"), low, high))
    return joints


class JointSource:
    """Publishes slow sine motions of all joints at RATE while it is on."""

    def __init__(self, urdf):
        self.joints = moving_joints(urdf)
        self.is_on = True
        self.publisher = rospy.Publisher("joint_states", JointState, queue_size=10)
        self.timer = rospy.Timer(rospy.Duration(1.0 / RATE), self.publish)

    def publish(self, _event):
        if self.is_on:
            phase = 0.3 * math.sin(0.5 * time.monotonic())
            message = JointState(name=[name for name, _, _ in self.joints],
                                 position=[low + (high - low) * (0.5 + phase)
                                           for _, low, high in self.joints])
            message.header.stamp = rospy.Time.now()
            self.publisher.publish(message)


class Watcher:
    """Holds the newest state, and waits for one that satisfies a condition."""

    def __init__(self):
        self.state = None
        rospy.Subscriber("collision_monitor/state", State, self.keep)

    def keep(self, state):
        self.state = state

    def wait(self, condition, deadline):
        start = time.monotonic()
        while time.monotonic() - start < deadline:
            if self.state is not None and condition(self.state):
                return time.monotonic() - start
            time.sleep(0.002)
        return math.inf


def measure(robot, seconds, figures):
    label, _, urdf, _, _ = robot
    publisher = ["rosrun", "robot_state_publisher", "robot_state_publisher",
                 f"_publish_frequency:={RATE}"]
    with running.monitor(robot, {"rate": RATE, "max_age": MAX_AGE}, [publisher]):
        watcher = Watcher()
        source = JointSource(urdf)
        try:
            started = watcher.wait(lambda state: state.level != State.UNKNOWN, 60.0)
            if math.isinf(started):
                why = watcher.state.sentence if watcher.state else "no state was published"
                figures.add(f"{label}: start", "-", "-", f"leaves UNKNOWN ({why})", False)
            else:
                report(label, watcher, source, seconds, figures)
        finally:
            source.timer.shutdown()


def report(label, watcher, source, seconds, figures):
    time.sleep(1.0)
    cycles, start = watcher.state.cycles, time.monotonic()
    time.sleep(seconds)
    rate = (watcher.state.cycles - cycles) / (time.monotonic() - start)
    figures.add(f"{label}: cycles", f"{rate:.1f} Hz", f"{RATE:.0f} Hz", "within 5 %",
                abs(rate - RATE) <= 0.05 * RATE)
    source.is_on = False
    silent = watcher.wait(lambda state: state.level == State.UNKNOWN, 10.0)
    # One period of the source and one of the cycle lie between the last stamp and the verdict.
    limit = MAX_AGE + 3.0 / RATE
    figures.add(f"{label}: UNKNOWN after", f"{silent:.3f} s", f"{MAX_AGE} s", f"<= {limit:.2f} s",
                silent <= limit)
    source.is_on = True
    back = watcher.wait(lambda state: state.level != State.UNKNOWN, 10.0)
    figures.add(f"{label}: back after", f"{back:.3f} s", "-", "< 1 s", back < 1.0)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=10.0, help="of measuring, each robot")
    parser.add_argument("--robot", help="only robots whose name holds this")
    arguments = parser.parse_args()
    figures = Figures()
    with running.master():
        for robot in shared_robots():
            if robot[0] in ROBOTS and (not arguments.robot or arguments.robot in robot[0]):
                measure(robot, arguments.seconds, figures)
    figures.finish()


if __name__ == "__main__":
    main()
