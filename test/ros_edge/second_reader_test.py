#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""What urdfdom reads otherwise in a robot is told in the log of the node that watches it."""
import sys
import threading
import time
import unittest

import rospy
import rostest
from rosgraph_msgs.msg import Log
from std_srvs.srv import Trigger

from monitor_probe import DEADLINE, NODE

BY_URDFDOM = "as urdfdom reads it"
# urdfdom takes what stands first in <geometry> for the shape, and leaves out one that it does not know.
EXTENSION_FIRST = """<robot name="odd">
  <link name="base"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  <joint name="turn" type="continuous"><parent link="base"/><child link="arm"/></joint>
  <link name="arm"><collision><geometry><tool:convex/><box size="0.1 0.2 0.3"/></geometry></collision></link>
</robot>"""


class SecondReader(unittest.TestCase):
    def setUp(self):
        self.condition = threading.Condition()
        self.lines = []
        self.subscriber = rospy.Subscriber("/rosout", Log, self.keep, queue_size=100)

    def keep(self, message):
        with self.condition:
            if message.name == NODE:
                self.lines.append(message)
                self.condition.notify_all()

    def differences(self):
        return [line for line in self.lines if BY_URDFDOM in line.msg]

    def reload_until(self, predicate, what):
        """The log is heard only once its publisher has found who listens, so nobody waits for a single line."""
        rospy.wait_for_service(NODE + "/reload", timeout=DEADLINE)
        reload = rospy.ServiceProxy(NODE + "/reload", Trigger)
        end = time.monotonic() + DEADLINE
        while time.monotonic() < end:
            answer = reload()
            self.assertTrue(answer.success, answer.message)
            with self.condition:
                if self.condition.wait_for(predicate, 1.0):
                    return
        self.fail("waited for %s; heard: %s" % (what, [line.msg for line in self.lines]))

    def test_robotThatUrdfdomReadsOtherwise_isAWarningWithBothReadings(self):
        self.reload_until(lambda: self.lines, "a line of the node")
        self.assertEqual(self.differences(), [])
        rospy.set_param("/robot_description", EXTENSION_FIRST)
        self.reload_until(self.differences, "a difference")
        line = self.differences()[0]
        self.assertEqual(line.level, Log.WARN)
        self.assertIn("link 'arm': 1 collision shapes as it is read here, 0 collision shapes as urdfdom reads it",
                      line.msg)


if __name__ == "__main__":
    rospy.init_node("second_reader_test")
    rostest.rosrun("collision_monitor", "second_reader", SecondReader, sys.argv)
