#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two robots of urdf/two_boxes.urdf stand side by side, 0.24 m apart along y: their boxes a, of
0.2 m edges, are 0.04 m from each other, and everything else is farther."""
import sys
import unittest

import rospy
import rostest
from std_srvs.srv import Trigger

from collision_monitor.msg import LinkDistance, State
from collision_monitor.srv import GetDistances
from monitor_probe import JointSource, Probe

IGNORE_PAIRS = "/collision_monitor/ignore_pairs"


class TwoRobots(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.probe = Probe()
        cls.left = JointSource({"slide": 0.3, "turn": 0.0}, topic="/left/joint_states")
        cls.right = JointSource({"slide": 0.3, "turn": 0.0}, topic="/right/joint_states")

    @classmethod
    def tearDownClass(cls):
        cls.left.stop()
        cls.right.stop()

    def setUp(self):
        self.right.is_on = True
        self.probe.wait_for_level(State.WARNING)

    def test_linksOfDifferentRobots_areMeasured(self):
        state = self.probe.wait_for_distance(0.04)
        self.assertEqual((state.closest.link_a, state.closest.link_b), ("left/box_a", "right/box_a"))
        self.assertEqual(state.closest.quality, LinkDistance.EXACT)
        self.assertAlmostEqual(state.closest.normal.y, 1.0, places=6)
        self.assertEqual(state.header.frame_id, "cell")

    def test_oneRobotFallsSilent_itsMovingLinkIsUnknownAndTheOtherIsNot(self):
        self.right.is_on = False
        state = self.probe.wait_for_level(State.UNKNOWN)
        self.assertEqual(len(state.unknown_links), 1)
        self.assertIn("right/box_b", state.unknown_links[0])
        self.probe.wait_for_distance(0.04)

    def test_serviceNamesLinksWithTheirPrefix(self):
        rospy.wait_for_service("/collision_monitor/get_distances", timeout=20.0)
        get_distances = rospy.ServiceProxy("/collision_monitor/get_distances", GetDistances)
        answer = get_distances(links_a=["left/box_b"], links_b=["right/box_b"])
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(len(answer.distances.pairs), 1)
        # Edges of 0.1 m, centers 0.24 m apart.
        self.assertAlmostEqual(answer.distances.pairs[0].distance, 0.14, places=6)

    def test_pairThatIgnorePairsNames_isLeftOutWhileItDoes(self):
        rospy.wait_for_service("/collision_monitor/reload", timeout=20.0)
        reload = rospy.ServiceProxy("/collision_monitor/reload", Trigger)
        get_distances = rospy.ServiceProxy("/collision_monitor/get_distances", GetDistances)
        self.probe.wait_for_distance(0.04)
        try:
            rospy.set_param(IGNORE_PAIRS, [["left/box_a", "rigth/*"]])
            answer = reload()
            self.assertFalse(answer.success)
            self.assertIn("ignore_pairs", answer.message)
            self.assertIn("'rigth/*'", answer.message)
            self.probe.wait_for_distance(0.04)  # nothing was changed
            rospy.set_param(IGNORE_PAIRS, [["left/box_a", "right/box_?"]])
            answer = reload()
            self.assertTrue(answer.success, answer.message)
            # Left are the boxes b, beside each other, and box a of the right, farther from them.
            self.probe.wait_for_distance(0.14)
            answer = get_distances(links_a=["left/box_a"], links_b=["right/box_a"])
            self.assertFalse(answer.success)
            self.assertIn("left/box_a and right/box_a (ignored: parameter ignore_pairs)", answer.message)
        finally:
            if rospy.has_param(IGNORE_PAIRS):
                rospy.delete_param(IGNORE_PAIRS)
            reload()
        self.probe.wait_for_distance(0.04)


if __name__ == "__main__":
    rospy.init_node("two_robots_test")
    rostest.rosrun("collision_monitor", "two_robots", TwoRobots, sys.argv)
