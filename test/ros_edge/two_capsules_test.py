#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Six clicks on /clicked_point make two capsules and their distance; the service clears the board.

The first lies along x from 0 to 0.4 m, 0.1 m thick. The second stands 0.5 m from its middle, along y,
0.15 m thick: 0.25 m are left, from (0.2, 0.1, 0) to (0.2, 0.35, 0).
"""
import sys
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
CLICKS = [(0.0, 0.0, 0.0), (0.0, 0.1, 0.0), (0.4, 0.0, 0.0),
          (0.2, 0.5, 0.0), (0.05, 0.5, 0.0), (0.2, 0.9, 0.0)]


class TwoCapsules(unittest.TestCase):

    def setUp(self):
        self.condition = threading.Condition()
        self.markers = {}
        rospy.wait_for_service(NODE + "/reset", timeout=DEADLINE)
        self.reset = rospy.ServiceProxy(NODE + "/reset", Trigger)
        self.assertTrue(self.reset().success)
        subscriber = rospy.Subscriber(NODE + "/markers", MarkerArray, self.keep)
        self.addCleanup(subscriber.unregister)
        self.clicks = rospy.Publisher("/clicked_point", PointStamped, queue_size=10)
        self.wait_for_prompt("capsule 1: click one end")
        self.wait(lambda: self.clicks.get_num_connections() > 0, "the node to listen")

    def keep(self, message):
        """What rviz has after this message: each begins with DELETEALL."""
        self.assertEqual(message.markers[0].action, Marker.DELETEALL)
        with self.condition:
            self.markers = {(marker.ns, marker.id): marker for marker in message.markers[1:]}
            self.condition.notify_all()

    def wait(self, predicate, what):
        end = time.monotonic() + DEADLINE
        with self.condition:
            while not predicate():
                self.assertLess(time.monotonic(), end, "waited for %s; last prompt: %s" % (
                    what, self.text("prompt")))
                self.condition.wait(0.1)

    def text(self, name_space):
        marker = self.markers.get((name_space, 0))
        return marker.text if marker else None

    def wait_for_prompt(self, prompt):
        self.wait(lambda: self.text("prompt") == prompt, "prompt '%s'" % prompt)

    def click(self, point, frame="world"):
        click = PointStamped()
        click.header.frame_id = frame
        click.point.x, click.point.y, click.point.z = point
        self.clicks.publish(click)

    def assert_points(self, marker, expected):
        self.assertEqual(len(marker.points), len(expected))
        for point, wanted in zip(marker.points, expected):
            for found, value in zip((point.x, point.y, point.z), wanted):
                self.assertAlmostEqual(found, value, places=9)

    def test_sixClicks_showTheDistance_andResetClearsIt(self):
        for point in CLICKS:
            self.click(point)
        self.wait_for_prompt("press R in the terminal to start again")
        self.assertEqual(set(self.markers), {
            ("board", 0), ("prompt", 0), ("clicks", 0), ("capsules", 0), ("capsules", 1),
            ("distance", 0), ("distance", 1), ("label", 0)})
        self.assertEqual(self.text("label"), "0.250 m")
        nearest = [(0.2, 0.1, 0.0), (0.2, 0.35, 0.0)]
        self.assert_points(self.markers["distance", 0], nearest)
        self.assert_points(self.markers["distance", 1], nearest)
        self.assert_points(self.markers["clicks", 0], CLICKS)

        self.assertEqual(self.reset().message, "capsule 1: click one end")
        self.wait_for_prompt("capsule 1: click one end")
        self.assertEqual(set(self.markers), {("board", 0), ("prompt", 0)})

    def test_badClicks_areRefused(self):
        self.click((float("nan"), 0.0, 0.0))
        self.wait_for_prompt("refused: a click must be finite and within 1000 m\n"
                             "capsule 1: click one end")
        self.click(CLICKS[0], frame="elsewhere")
        self.wait_for_prompt("refused: the click is in frame 'elsewhere', the board in 'world'\n"
                             "capsule 1: click one end")
        self.click(CLICKS[0])
        self.wait(lambda: ("clicks", 0) in self.markers, "the first good click")
        self.assert_points(self.markers["clicks", 0], CLICKS[:1])


if __name__ == "__main__":
    rospy.init_node("two_capsules_test")
    rostest.rosrun("collision_monitor", "two_capsules", TwoCapsules, sys.argv)
