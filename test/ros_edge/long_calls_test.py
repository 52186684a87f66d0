#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Service calls that take seconds, several at once, hold up no other service."""
import random
import sys
import threading
import time
import unittest

import rospy
import rostest

from collision_monitor.msg import State
from collision_monitor.srv import CheckStates, GetDistances
from monitor_probe import DEADLINE, JointSource, NODE, Probe

JOINTS = [name + "_joint" for name in (
    "shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3")]


class LongCallsTest(unittest.TestCase):

    def test_statesOfManyCallers_otherServicesAnswerMeanwhile(self):
        joints = JointSource(dict.fromkeys(JOINTS + ["left_finger_joint"], 0.0))
        self.addCleanup(joints.stop)
        probe = Probe()
        probe.wait(lambda: probe.state is not None and probe.state.level != State.UNKNOWN,
                   "every link to be known")
        rospy.wait_for_service(NODE + "/check_states", timeout=DEADLINE)
        generator = random.Random(5)
        positions = [generator.uniform(-1.5, 1.5) for _ in range(60000 * len(JOINTS))]
        answers = []

        def check():
            answer = rospy.ServiceProxy(NODE + "/check_states", CheckStates)(
                JOINTS, positions, False, False)
            answers.append((time.monotonic(), answer))

        callers = [threading.Thread(target=check) for _ in range(3)]
        for caller in callers:
            caller.start()
        ask = rospy.ServiceProxy(NODE + "/get_distances", GetDistances)
        times = []
        while any(caller.is_alive() for caller in callers):
            ask(max_distance=0.01)
            times.append(time.monotonic())
        for _, answer in answers:
            self.assertTrue(answer.success, answer.message)
            self.assertIn("contact, 0 unknown", answer.message)
        self.assertEqual(len(answers), len(callers))
        # When they shared threads, the first of these calls waited for the first of those.
        first = min(done for done, _ in answers)
        self.assertGreater(sum(done < first for done in times), 2)


if __name__ == "__main__":
    rospy.init_node("long_calls_test")
    rostest.rosrun("collision_monitor", "long_calls", LongCallsTest, sys.argv)
