#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sources that contradict each other, and floods of what nobody asked for."""
import re
import sys
import threading
import unittest
from xmlrpc.client import ServerProxy

import rosgraph
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64
from tf2_msgs.msg import TFMessage

from collision_monitor.msg import State
from monitor_probe import NODE, Probe, transform


class Poses:
    """Publishes where the boxes are, with the wall's time."""

    def __init__(self):
        self.tf = rospy.Publisher("/tf", TFMessage, queue_size=10)
        self.end = threading.Event()
        threading.Thread(target=self.run, daemon=True).start()

    def run(self):
        while not self.end.wait(0.02) and not rospy.is_shutdown():
            now = rospy.Time.now()
            self.tf.publish([transform("rail", "box_a", now, 0.0),
                             transform("rail", "carriage", now, 0.55),
                             transform("carriage", "box_b", now, 0.0)])


def shift():
    """A second publisher of the carriage: the same stamps, elsewhere as far as it is told."""
    rospy.init_node("shifter")
    tf = rospy.Publisher("/tf", TFMessage, queue_size=10)
    offset = [0.0]

    def hear(message):
        if message._connection_header["callerid"] != rospy.get_name() and offset[0] != 0.0:
            tf.publish([transform("rail", "carriage", t.header.stamp,
                                  t.transform.translation.x + offset[0])
                        for t in message.transforms if t.child_frame_id == "carriage"])

    subscribers = [
        rospy.Subscriber("/tf", TFMessage, hear),
        rospy.Subscriber("/shift", Float64, lambda told: offset.__setitem__(0, told.data))]
    rospy.spin()
    return subscribers


class SourcesTest(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.probe = Probe()
        cls.poses = Poses()
        cls.shift = rospy.Publisher("/shift", Float64, queue_size=1, latch=True)

    @classmethod
    def tearDownClass(cls):
        cls.poses.end.set()

    def setUp(self):
        self.probe.wait_for_level(State.OK)

    def test_twoPublishersOfOneFrame_isUnknownAndBothAreNamed(self):
        self.shift.publish(0.1)
        state = self.probe.wait_for_level(State.UNKNOWN, "different transforms to 'carriage'")
        self.assertIn("'/shifter'", state.sentence)
        self.assertIn("'%s'" % rospy.get_name(), state.sentence)
        self.assertIn("box_b (contradicted)", state.unknown_links)
        self.shift.publish(0.0)
        self.probe.wait_for_level(State.OK)

    def test_floodOfFramesAndJoints_stateGoesOnAndMemoryDoesNotGrow(self):
        pid = self.pid_of_monitor()
        before = self.resident(pid)
        joints = rospy.Publisher("/joint_states", JointState, queue_size=10)
        names = ["flood_%d" % i for i in range(1000000)]
        message = JointState(name=names, position=[0.0] * len(names))
        self.probe.wait(lambda: joints.get_num_connections() > 0, "the monitor to listen")
        for _ in range(3):
            message.header.stamp = rospy.Time.now()
            joints.publish(message)
            now = rospy.Time.now()
            self.poses.tf.publish([transform("elsewhere", "frame_%d" % i, now, 1.0)
                                   for i in range(9000)])
        heard = "inputs refused as too long or too many"
        self.wait_for_diagnostics(lambda value: int(value) >= 3, heard)
        count = self.probe.state_count
        self.probe.wait(lambda: self.probe.state_count > count + 10, "states go on")
        self.assertEqual(self.probe.state.level, State.OK)
        # A message that is being read takes as much as it is long, for a moment.
        self.assertLess(self.resident(pid) - before, 300e6)

    @staticmethod
    def pid_of_monitor():
        api = rosgraph.Master("/sources_test").lookupNode(NODE)
        return ServerProxy(api).getPid("/sources_test")[2]

    @staticmethod
    def resident(pid):
        with open("/proc/%d/status" % pid) as status:
            return 1024 * int(re.search(r"VmRSS:\s*(\d+)", status.read()).group(1))

    def wait_for_diagnostics(self, holds, key):
        seen = {}

        def hear(message):
            with self.probe.condition:
                seen.update((value.key, value.value) for status in message.status
                            for value in status.values)
                self.probe.condition.notify_all()

        subscriber = rospy.Subscriber("/diagnostics", DiagnosticArray, hear)
        self.probe.wait(lambda: key in seen and holds(seen[key]), "diagnostics: " + key)
        subscriber.unregister()


if __name__ == "__main__":
    if "--shift" in sys.argv:
        shift()
    else:
        rospy.init_node("sources_test")
        rostest.rosrun("collision_monitor", "sources", SourcesTest, sys.argv)
