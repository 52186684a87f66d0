#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two robots of urdf/two_boxes.urdf. Nobody says where the right one stands, until the test does: 0.24 m
beside the left one along y, so that their boxes a, of 0.2 m edges, are 0.04 m from each other."""
import sys
import unittest

import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import TransformStamped
from trajectory_msgs.msg import JointTrajectoryPoint

from collision_monitor.msg import LinkApproach, LinkDistance, State
from collision_monitor.srv import (CheckStates, CheckStatesRequest, CheckTrajectory, CheckTrajectoryRequest,
                                   GetDistances, GetDistancesRequest)
from monitor_probe import NODE, DEADLINE, JointSource, Probe

FLOATS = "the part of robot 'right' from link 'right/rail' on floats: no transform from 'cell' to 'right/rail' yet"


class Floating(unittest.TestCase):
    """Tests run in order of their names: the right robot stands somewhere only in the last one."""

    @classmethod
    def setUpClass(cls):
        cls.probe = Probe()
        cls.left = JointSource({"slide": 0.3, "turn": 0.0}, topic="/left/joint_states")
        cls.right = JointSource({"slide": -0.08, "turn": 0.0}, topic="/right/joint_states")

    @classmethod
    def tearDownClass(cls):
        cls.left.stop()
        cls.right.stop()

    def setUp(self):
        """Joint states of both robots have come: what is unknown is not their own doing."""
        self.probe.wait(lambda: self.probe.state is not None and
                        not any("/box_b" in name and "left" in name for name in self.probe.state.unknown_links) and
                        self.probe.state.has_closest, "both robots' own pairs")

    def ask(self, name, kind, request):
        rospy.wait_for_service(NODE + "/" + name, timeout=DEADLINE)
        answer = rospy.ServiceProxy(NODE + "/" + name, kind)(request)
        self.assertTrue(answer.success, answer.message)
        return answer

    def test_1_ownPairsOfTheRobotThatFloats_areJudged(self):
        state = self.probe.wait_for_distance(0.02)
        self.assertEqual((state.closest.link_a, state.closest.link_b), ("right/box_a", "right/box_b"))
        self.assertEqual((state.closest.frame_id, state.header.frame_id), ("right/rail", "cell"))
        state = self.probe.wait_for_level(State.UNKNOWN, "own pair")
        self.assertEqual(state.sentence.split(";")[0], FLOATS)
        self.assertEqual(set(state.unknown_links),
                         {"right/rail (missing)", "right/box_a (missing)", "right/box_b (missing)"})
        self.assertEqual(state.speed_scale, 0.0)
        self.right.set(slide=-0.13)
        state = self.probe.wait_for_level(State.CONTACT, "right/box_a overlaps right/box_b by 30 mm")
        self.probe.wait(lambda: self.probe.contacts.contacts and
                        self.probe.contacts.contacts[0].frame_id == "right/rail", "the contact's frame")
        self.right.set(slide=-0.08)
        self.probe.wait_for_level(State.UNKNOWN, FLOATS)

    def test_2_services_judgeOwnPairsToo(self):
        self.probe.wait_for_distance(0.02)
        answer = self.ask("get_distances", GetDistances, GetDistancesRequest())
        nearest = answer.distances.pairs[0]
        self.assertEqual((nearest.link_a, nearest.frame_id), ("right/box_a", "right/rail"))
        self.assertAlmostEqual(nearest.distance, 0.02, places=6)
        self.assertEqual(sum(pair.quality == LinkDistance.UNKNOWN for pair in answer.distances.pairs),
                         answer.distances.pairs_unknown)
        self.assertIn(FLOATS, answer.message)
        request = CheckStatesRequest(joint_names=["right/slide"], positions=[0.1, -0.13])
        answer = self.ask("check_states", CheckStates, request)
        self.assertEqual(list(answer.levels), [State.UNKNOWN, State.CONTACT])
        self.assertIn(FLOATS, answer.message)
        request = CheckTrajectoryRequest()
        request.trajectory.joint_names = ["right/slide"]
        request.trajectory.points = [
            JointTrajectoryPoint(positions=[0.1]),
            JointTrajectoryPoint(positions=[-0.1], time_from_start=rospy.Duration(2.0))]
        answer = self.ask("check_trajectory", CheckTrajectory, request)
        self.assertEqual(answer.level, State.CONTACT)
        self.assertAlmostEqual(answer.contact_time, 2.0, places=4)
        self.assertEqual(answer.pairs[0].state, LinkApproach.CONTACT)
        self.assertEqual(answer.pairs[0].nearest.frame_id, "right/rail")
        self.assertIn(FLOATS, answer.message)

    def test_3_robotIsPlaced_allPairsAreKnown(self):
        stand = TransformStamped(child_frame_id="right/rail")
        stand.header.frame_id = "cell"
        stand.header.stamp = rospy.Time.now()
        stand.transform.translation.y = 0.24
        stand.transform.rotation.w = 1.0
        broadcaster = tf2_ros.StaticTransformBroadcaster()
        broadcaster.sendTransform(stand)
        self.right.set(slide=0.3)
        state = self.probe.wait_for_distance(0.04)
        self.assertEqual((state.closest.link_a, state.closest.link_b), ("left/box_a", "right/box_a"))
        self.assertEqual(state.closest.frame_id, "cell")
        state = self.probe.wait_for_level(State.WARNING)
        self.assertEqual(state.unknown_links, [])
        self.assertEqual(state.pairs_unknown, 0)


if __name__ == "__main__":
    rospy.init_node("floating_test")
    rostest.rosrun("collision_monitor", "floating", Floating, sys.argv)
