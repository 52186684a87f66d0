# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by figures of the running node: a separate master, and a monitor of one robot."""
import contextlib
import os
import subprocess
import time
import xmlrpc.client

import rospy
from rosgraph import Master, MasterError

from figure import package_path

PORT = 11411
NODE = "/collision_monitor"


@contextlib.contextmanager
def running(commands, environment=None):
    """Starts processes that end with the block."""
    processes = [subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL) for command in commands]
    try:
        yield
    finally:
        for process in processes:
            process.terminate()
        for process in processes:
            process.wait()


@contextlib.contextmanager
def master():
    os.environ["ROS_MASTER_URI"] = f"http://localhost:{PORT}"
    with running([["rosmaster", "--core", "-p", str(PORT)]]):
        rospy.init_node("figures", disable_signals=True)
        yield


@contextlib.contextmanager
def monitor(robot, parameters, others=()):
    """The node with one of shared_robots(), and other processes that need its description."""
    label, folder, urdf, srdf, _ = robot
    rospy.set_param("robot_description", urdf.read_text(encoding="utf-8"))
    # From the file, not the parameter: some of these robots name meshes relative to it.
    description = {"name": label, "file": str(urdf)}
    if srdf:
        description["semantic_file"] = str(srdf)
    rospy.set_param(f"{NODE}/robots", [description])
    command = ["rosrun", "collision_monitor", "monitor",
               *(f"_{name}:={value}" for name, value in parameters.items())]
    try:
        with running([command, *others], package_path(folder)):
            yield
    finally:
        rospy.delete_param("robot_description")
        rospy.delete_param(NODE)


def process_id(deadline):
    """The process id of the node, once it is up; waits that many seconds."""
    end = time.monotonic() + deadline
    while True:
        try:
            return xmlrpc.client.ServerProxy(Master("/figures").lookupNode(NODE)).getPid("/")[2]
        except (MasterError, ConnectionError):  # not known yet, or the previous node, which has ended
            if time.monotonic() > end:
                raise
            time.sleep(0.1)
