# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The running node beside robot_state_publisher, at 100 Hz on moving robots: the CPU it takes,
the time until UNKNOWN when joint states stop, and whether it comes back when they do."""
import argparse
import math
import os
import subprocess
import time
import xml.etree.ElementTree as ElementTree
import xmlrpc.client

import rospy
from rosgraph import Master
from sensor_msgs.msg import JointState

from collision_monitor.msg import State
from figure import Figures, package_path, shared_robots

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
    """The newest state, and waiting for one that satisfies a condition."""

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


def node_pid(name):
    uri = Master("/figures").lookupNode(name)
    return xmlrpc.client.ServerProxy(uri).getPid("/figures")[2]


def cpu_seconds(pid):
    with open(f"/proc/{pid}/stat", encoding="ascii") as stat:
        fields = stat.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def resident_megabytes(pid):
    with open(f"/proc/{pid}/status", encoding="ascii") as status:
        for line in status:
            if line.startswith("VmRSS:"):
                return int(line.split()[1]) / 1024.0
    return math.nan


def measure(label, folder, urdf, srdf, seconds, figures):
    environment = package_path(folder)
    rospy.set_param("robot_description", urdf.read_text(encoding="utf-8"))
    # From the file, not from the parameter: some of these robots name meshes relative to it.
    robot = {"name": label, "file": str(urdf)}
    if srdf:
        robot["semantic_file"] = str(srdf)
    rospy.set_param("collision_monitor/robots", [robot])
    processes = [subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL) for command in (
        ["rosrun", "robot_state_publisher", "robot_state_publisher",
         f"_publish_frequency:={RATE}"],
        ["rosrun", "collision_monitor", "monitor", f"_rate:={RATE}", f"_max_age:={MAX_AGE}"])]
    watcher = Watcher()
    source = JointSource(urdf)
    try:
        started = watcher.wait(lambda state: state.level != State.UNKNOWN, 60.0)
        if math.isinf(started):
            why = watcher.state.sentence if watcher.state else "no state was published"
            figures.add(f"{label}: start", "-", "-", f"leaves UNKNOWN ({why})", False)
            return
        report(label, watcher, source, seconds, figures)
    finally:
        source.timer.shutdown()
        for process in processes:
            process.terminate()
        for process in processes:
            process.wait()
        rospy.delete_param("robot_description")
        rospy.delete_param("collision_monitor")


def report(label, watcher, source, seconds, figures):
    pid = node_pid("/collision_monitor")
    time.sleep(1.0)
    cpu, cycles, start = cpu_seconds(pid), watcher.state.cycles, time.monotonic()
    time.sleep(seconds)
    elapsed = time.monotonic() - start
    percent = 100.0 * (cpu_seconds(pid) - cpu) / elapsed
    rate = (watcher.state.cycles - cycles) / elapsed
    figures.add(f"{label}: CPU at {RATE:.0f} Hz", f"{percent:.1f} %", "-", "< 10 % of a core",
                percent < 10.0)
    figures.add(f"{label}: cycles", f"{rate:.1f} Hz", f"{RATE:.0f} Hz", "within 5 %",
                abs(rate - RATE) <= 0.05 * RATE)
    figures.add(f"{label}: memory", f"{resident_megabytes(pid):.0f} MB", "-", "< 150 MB",
                resident_megabytes(pid) < 150.0)
    source.is_on = False
    silent = watcher.wait(lambda state: state.level == State.UNKNOWN, 10.0)
    # A period of the source and one of the cycle lie between the last stamp and the verdict.
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
    port = 11411
    os.environ["ROS_MASTER_URI"] = f"http://localhost:{port}"
    core = subprocess.Popen(["roscore", "-p", str(port)], stdout=subprocess.DEVNULL,
                            stderr=subprocess.DEVNULL)
    figures = Figures()
    try:
        rospy.init_node("figures", disable_signals=True)
        for label, folder, urdf, srdf, _ in shared_robots():
            if label in ROBOTS and (not arguments.robot or arguments.robot in label):
                measure(label, folder, urdf, srdf, arguments.seconds, figures)
    finally:
        core.terminate()
        core.wait()
    figures.finish()


if __name__ == "__main__":
    main()
