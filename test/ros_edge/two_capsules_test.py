#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Six clicks on /clicked_point make two capsules and their distance; the service clears the board.

The first lies along x from 0 to 0.4 m, 0.1 m thick. The second stands 0.5 m from its middle, along y,
0.15 m thick: 0.25 m are left, from (0.2, 0.1, 0) to (0.2, 0.35, 0).
"""
import os
import subprocess
import sys
import termios
import threading
import time
import unittest

import rospy
import rostest
from geometry_msgs.msg import PointStamped
from std_srvs.srv import Trigger
from visualization_msgs.msg import Marker, MarkerArray

DEADLINE = 20.0  # wall seconds; far more than anything takes
NODE = "/two_capsules"
FIRST_PROMPT = "capsule 1: click one end"
CLICKS = [(0.0, 0.0, 0.0), (0.0, 0.1, 0.0), (0.4, 0.0, 0.0),
          (0.2, 0.5, 0.0), (0.05, 0.5, 0.0), (0.2, 0.9, 0.0)]


class Picture:
    """What rviz shows of a node's markers."""

    def __init__(self, node):
        self.condition = threading.Condition()
        self.markers = {}
        self.subscriber = rospy.Subscriber(node + "/markers", MarkerArray, self._keep)

    def _keep(self, message):
        """Each message is the whole picture: it begins with DELETEALL, or nothing is seen."""
        if message.markers[0].action != Marker.DELETEALL:
            return
        with self.condition:
            self.markers = {(marker.ns, marker.id): marker for marker in message.markers[1:]}
            self.condition.notify_all()

    def text(self, name_space):
        marker = self.markers.get((name_space, 0))
        return marker.text if marker else None

    def wait(self, predicate, what):
        end = time.monotonic() + DEADLINE
        with self.condition:
            while not predicate():
                if time.monotonic() > end:
                    raise AssertionError("waited for %s; last prompt: %s" % (
                        what, self.text("prompt")))
                self.condition.wait(0.1)

    def wait_for_prompt(self, prompt):
        self.wait(lambda: self.text("prompt") == prompt, "prompt '%s'" % prompt)


class TwoCapsules(unittest.TestCase):

    def setUp(self):
        self.picture = self.look_at(NODE)
        rospy.wait_for_service(NODE + "/reset", timeout=DEADLINE)
        self.reset = rospy.ServiceProxy(NODE + "/reset", Trigger)
        self.assertTrue(self.reset().success)
        self.picture.wait_for_prompt(FIRST_PROMPT)
        self.clicks = rospy.Publisher("/clicked_point", PointStamped, queue_size=10)
        self.addCleanup(self.clicks.unregister)
        self.wait_for_listeners(1)

    def look_at(self, node):
        picture = Picture(node)
        self.addCleanup(picture.subscriber.unregister)
        return picture

    def wait_for_listeners(self, count):
        self.picture.wait(lambda: self.clicks.get_num_connections() == count, "the nodes to listen")

    def click(self, point, frame="world"):
        click = PointStamped()
        click.header.frame_id = frame
        click.point.x, click.point.y, click.point.z = point
        self.clicks.publish(click)

    def assert_points(self, key, expected):
        points = self.picture.markers[key].points
        self.assertEqual(len(points), len(expected))
        for point, wanted in zip(points, expected):
            for found, value in zip((point.x, point.y, point.z), wanted):
                self.assertAlmostEqual(found, value, places=9)

    def test_sixClicks_showTheDistance_andResetClearsIt(self):
        for point in CLICKS:
            self.click(point)
        self.picture.wait_for_prompt("press R in the terminal to start again")
        self.assertEqual(set(self.picture.markers), {
            ("board", 0), ("prompt", 0), ("clicks", 0), ("capsules", 0), ("capsules", 1),
            ("distance", 0), ("distance", 1), ("label", 0)})
        self.assertEqual(self.picture.text("label"), "0.250 m")
        nearest = [(0.2, 0.1, 0.0), (0.2, 0.35, 0.0)]
        self.assert_points(("distance", 0), nearest)
        self.assert_points(("distance", 1), nearest)
        self.assert_points(("clicks", 0), CLICKS)

        self.assertEqual(self.reset().message, FIRST_PROMPT)
        self.picture.wait_for_prompt(FIRST_PROMPT)
        self.assertEqual(set(self.picture.markers), {("board", 0), ("prompt", 0)})

    def test_badClicks_areRefused(self):
        self.click((float("nan"), 0.0, 0.0))
        self.picture.wait_for_prompt("refused: a click must be finite and within 1000 m\n" +
                                     FIRST_PROMPT)
        self.click(CLICKS[0], frame="elsewhere")
        self.picture.wait_for_prompt(
            "refused: the click is in frame 'elsewhere', the board in 'world'\n" + FIRST_PROMPT)
        self.click(CLICKS[0])
        self.picture.wait(lambda: ("clicks", 0) in self.picture.markers, "the first good click")
        self.assert_points(("clicks", 0), CLICKS[:1])

    def test_keysOfATerminal_clearTheBoardAndEnd(self):
        master, terminal = os.openpty()
        self.addCleanup(os.close, master)
        self.addCleanup(os.close, terminal)
        before = termios.tcgetattr(terminal)
        # In a session of its own, as roslaunch starts nodes.
        node = subprocess.Popen(["rosrun", "collision_monitor", "two_capsules", "__name:=by_keys"],
                                stdin=terminal, start_new_session=True)
        self.addCleanup(node.wait)
        self.addCleanup(node.kill)
        picture = self.look_at("/by_keys")
        picture.wait_for_prompt(FIRST_PROMPT)
        self.wait_for_listeners(2)
        self.click(CLICKS[0])
        picture.wait(lambda: ("clicks", 0) in picture.markers, "the click")
        os.write(master, b"xr")
        picture.wait_for_prompt(FIRST_PROMPT)
        self.assertEqual(set(picture.markers), {("board", 0), ("prompt", 0)})
        os.write(master, b"Q")
        self.assertEqual(node.wait(timeout=DEADLINE), 0)
        self.assertEqual(termios.tcgetattr(terminal), before)
        self.wait_for_listeners(1)

    def test_frameThatIsNone_isRefused(self):
        for frame in ("", 5):
            rospy.set_param("/no_frame/frame", frame)
            ended = subprocess.run(["rosrun", "collision_monitor", "two_capsules", "__name:=no_frame"],
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, timeout=DEADLINE, check=False)
            self.assertEqual(ended.returncode, 1)
            self.assertIn(b"parameter /no_frame/frame", ended.stdout)


if __name__ == "__main__":
    rospy.init_node("two_capsules_test")
    rostest.rosrun("collision_monitor", "two_capsules", TwoCapsules, sys.argv)
