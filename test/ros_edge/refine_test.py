#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two angles hooked into each other, 0.02 m apart: in contact for enclosing shapes and hulls, clear
for their meshes."""
import sys
import unittest

import rospy
import rostest
from std_srvs.srv import Trigger

from collision_monitor.msg import Distances, LinkDistance, State
from collision_monitor.srv import GetDistances
from monitor_probe import Probe

NODE = "/collision_monitor"


class Refine(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.probe = Probe()

    def reload_with(self, geometry):
        rospy.wait_for_service(NODE + "/reload", timeout=20.0)
        rospy.set_param(NODE + "/refine_geometry", geometry)
        return rospy.ServiceProxy(NODE + "/reload", Trigger)()

    def tearDown(self):
        self.assertTrue(self.reload_with("mesh").success)

    def test_mesh_isClearByTheExactDistance(self):
        state = self.probe.wait_for_level(State.OK)
        self.assertEqual(state.closest.quality, LinkDistance.EXACT)
        self.assertLess(state.closest.distance, 0.02 + 1e-6)
        self.assertGreater(state.closest.distance, 0.02 - 1e-4, "short by distance_tolerance at most")
        self.assertEqual(state.closest.shape_a, "bars")
        self.assertEqual((state.pairs_refined, state.pairs_left), (1, 0))
        self.assertEqual(state.sentence, "clear; left/angle is 20 mm from right/angle")

    def test_withoutRefinement_shapesAreInContact(self):
        self.assertTrue(self.reload_with("none").success)
        state = self.probe.wait_for_level(State.CONTACT)
        self.assertEqual(state.closest.quality, LinkDistance.LOWER_BOUND)
        self.assertEqual((state.pairs_refined, state.pairs_left), (0, 0))

    def test_hull_isInContact(self):
        self.assertTrue(self.reload_with("hull").success)
        state = self.probe.wait_for_level(State.CONTACT)
        self.assertEqual(state.closest.quality, LinkDistance.LOWER_BOUND)

    def test_getDistances_answersForTheMeshes(self):
        self.probe.wait_for_level(State.OK)
        answer = rospy.ServiceProxy(NODE + "/get_distances", GetDistances)(
            links_a=["left/angle"], links_b=["right/angle"])
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.distances.pairs[0].quality, LinkDistance.EXACT)
        self.assertAlmostEqual(answer.distances.pairs[0].distance, 0.02, places=6)
        self.assertEqual(answer.distances.tolerance, 0.0)

    def test_tolerance_isToldAndNoneMakesDistancesExact(self):
        distances = rospy.wait_for_message(NODE + "/distances", Distances, timeout=20.0)
        self.assertEqual(distances.tolerance, 1e-4)
        rospy.set_param(NODE + "/distance_tolerance", 0.0)
        try:
            self.assertTrue(self.reload_with("mesh").success)
            self.probe.wait_for_distance(0.02)
        finally:
            rospy.delete_param(NODE + "/distance_tolerance")

    def test_unknownGeometry_isRefusedAndChangesNothing(self):
        answer = self.reload_with("exact")
        self.assertFalse(answer.success)
        self.assertIn("mesh hull none", answer.message)
        self.assertEqual(self.probe.wait_for_level(State.OK).level, State.OK)


if __name__ == "__main__":
    rospy.init_node("refine_test")
    rostest.rosrun("collision_monitor", "refine", Refine, sys.argv)
