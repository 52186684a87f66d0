#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""monitor.launch on a server that is not empty, and rviz in the robot's frame."""
import contextlib
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

import rospy
import rostest

from monitor_probe import DEADLINE, Probe

INCLUDE = """<launch>
  <rosparam ns="{name}">ignore_pairs: [[{link_a}, {link_b}]]</rosparam>
  <include file="$(find collision_monitor)/launch/monitor.launch"><arg name="name" value="{name}"/></include>
</launch>"""


@contextlib.contextmanager
def launched(*arguments, path=None):
    """roslaunch while the test goes on; `path`: a folder to look for programs in first."""
    environment = dict(os.environ)
    if path is not None:
        environment["PATH"] = str(path) + os.pathsep + environment["PATH"]
    process = subprocess.Popen(["roslaunch", *map(str, arguments)], env=environment, stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
    try:
        yield process
    finally:
        process.terminate()
        print(process.communicate(timeout=60)[0])


def wait_for_file(path):
    end = time.monotonic() + DEADLINE
    while not path.exists():
        if time.monotonic() > end:
            raise AssertionError(f"waited for {path}")
        rospy.rostime.wallsleep(0.05)
    return path.read_text(encoding="utf-8")


class Launch(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def check_nothing_is_left(self, name, *arguments):
        rospy.set_param("/" + name + "/ignore_pairs", [["*", "*"]])
        rospy.set_param("/" + name + "/misspelt", 1)  # with it the node does not start
        with launched("collision_monitor", "monitor.launch", "name:=" + name, *arguments):
            probe = Probe("/" + name)
            probe.wait(lambda: probe.state is not None, "a state")
            self.assertEqual(probe.state.pairs_ignored, 0)
            self.assertGreater(probe.state.pairs_checked, 0)
            self.assertFalse(rospy.has_param("/" + name + "/misspelt"))

    def test_parametersOfEarlierLaunches_areGone(self):
        self.check_nothing_is_left("node_of_yesterday")

    def test_parametersOfEarlierLaunches_areGoneForANodeletToo(self):
        self.check_nothing_is_left("nodelet_of_yesterday", "manager:=/manager")

    def test_parametersOfTheSameLaunch_count(self):
        file = self.folder / "own.launch"
        file.write_text(INCLUDE.format(name="own", link_a="head", link_b="torso"), encoding="utf-8")
        with launched(file):
            probe = Probe("/own")
            probe.wait(lambda: probe.state is not None, "a state")
            self.assertEqual(probe.state.pairs_ignored, 1)

    def test_rviz_startsWithTheWorldFrame(self):
        heard = self.folder / "heard"
        rviz = self.folder / "rviz"
        rviz.write_text(f'#!/bin/sh\necho "$@" >"{heard}.part"\nmv "{heard}.part" "{heard}"\n', encoding="utf-8")
        rviz.chmod(0o755)
        for frame, arguments in (("pelvis_root", ()), ("map", ("world_frame:=map",))):
            heard.unlink(missing_ok=True)
            with launched("collision_monitor", "monitor.launch", "name:=shown", "rviz:=true",
                          "robot_description:=/other_root", *arguments, path=self.folder):
                said = wait_for_file(heard)
            self.assertIn("monitor.rviz -f " + frame + " ", said)
            self.assertIn("/collision_monitor/markers:=shown/markers", said)
            self.assertIn("__name:=shown_rviz", said)


if __name__ == "__main__":
    rospy.init_node("launch_test")
    sphere = "<collision><geometry><sphere radius='0.1'/></geometry></collision>"
    rospy.set_param("/other_root", "<robot name='r'><link name='pelvis_root'>" + sphere + "</link></robot>")
    rostest.rosrun("collision_monitor", "launch", Launch, sys.argv)
