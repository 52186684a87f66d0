#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The two boxes without tf: joint states alone place the links, from two publishers."""
import math
import sys

import rospy
import rostest
from sensor_msgs.msg import JointState

from collision_monitor.msg import State
from collision_monitor.srv import GetDistances
from monitor_probe import JointSource, TwoBoxes


class JointStates(TwoBoxes):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.joints.stop()
        cls.joints = JointSource({"slide": 0.3}, rate=70.0)
        cls.turn = JointSource({"turn": 0.0}, rate=40.0)

    @classmethod
    def tearDownClass(cls):
        super().tearDownClass()
        cls.turn.stop()

    def setUp(self):
        self.turn.is_on = True
        self.turn.set(turn=0.0)
        self.joints.set(slide=0.3)
        self.probe.wait_for_distance(0.4)

    def test_distanceFollowsBothPublishers(self):
        self.joints.set(slide=0.0)
        self.probe.wait_for_distance(0.1)
        self.turn.set(turn=math.pi / 4.0)
        self.probe.wait_for_distance(0.15 - 0.05 * math.sqrt(2.0))
        self.joints.set(slide=-0.13)
        self.turn.set(turn=0.0)
        self.probe.wait_for_level(State.CONTACT)
        self.probe.wait_for_distance(-0.03)

    def test_silentPublisher_hidesWhatHangsOnItsJoint(self):
        self.turn.is_on = False
        state = self.probe.wait_for_level(State.UNKNOWN, "no state of joint 'turn' for")
        self.assertEqual(state.unknown_links, ["box_b (stale)"])
        self.assertEqual(state.speed_scale, 0.0)
        self.turn.is_on = True
        self.probe.wait_for_level(State.OK)

    def test_nanPosition_isNotFinite(self):
        self.turn.set(turn=float("nan"))
        self.probe.wait_for_level(State.UNKNOWN, "the position of joint 'turn' is missing in its "
                                                 "message, not finite")
        self.turn.set(turn=0.0)
        self.probe.wait_for_level(State.OK)

    def test_getDistances_readsJointStatesToo(self):
        answer = self.service("get_distances", GetDistances)([], [], JointState(), 0.0, False)
        self.assertTrue(answer.success, answer.message)
        self.assertAlmostEqual(answer.distances.pairs[0].distance, 0.4, places=6)
        self.assertEqual(answer.distances.pairs[0].gradient_joints, ["slide", "turn"])


if __name__ == "__main__":
    rospy.init_node("joint_states_test")
    rostest.rosrun("collision_monitor", "joint_states", JointStates, sys.argv)
