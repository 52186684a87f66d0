#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Simulated time that has not started, stands still and jumps back."""
import math
import sys
import threading
import unittest

import rospy
import rostest
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage

from collision_monitor.msg import State
from collision_monitor.srv import GetDistances
from monitor_probe import Probe, transform


class Simulation:
    """Publishes /clock, and the moving transforms of two_boxes with its stamp, over and over."""

    def __init__(self):
        self.clock = rospy.Publisher("/clock", Clock, queue_size=1)
        self.tf = rospy.Publisher("/tf", TFMessage, queue_size=1)
        self.tf_static = rospy.Publisher("/tf_static", TFMessage, queue_size=1, latch=True)
        self.tf_static.publish([transform("rail", "box_a", rospy.Time(), 0.0)])
        self.now = 0.0
        self.step = 0.02
        self.ahead = 0.0  # [s] how far the stamps of poses are ahead of the clock
        self.runs_ahead = False
        self.has_clock = False
        self.has_poses = False
        self.end = threading.Event()
        self.thread = threading.Thread(target=self.run, daemon=True)
        self.thread.start()

    def run(self):
        while not self.end.wait(0.02):
            stamp = rospy.Time.from_sec(self.now)
            if self.has_clock:
                self.clock.publish(stamp)
            self.ahead += 1e-3 if self.runs_ahead else 0.0
            stamp = rospy.Time.from_sec(self.now + self.ahead)
            if self.has_poses:
                self.tf.publish([transform("rail", "carriage", stamp, 0.55),
                                 transform("carriage", "box_b", stamp, 0.0)])
            self.now += self.step


class ClockTest(unittest.TestCase):

    def test_clockStarts_standsStill_jumpsBack(self):
        probe = Probe()
        probe.wait_for_level(State.UNKNOWN, "no time on /clock yet")
        simulation = Simulation()
        simulation.now = 100.0
        simulation.has_clock = True
        probe.wait_for_level(State.UNKNOWN, "no transform from 'rail' to 'carriage' yet")
        simulation.has_poses = True
        probe.wait_for_level(State.OK)

        # Time stands still: the heart beats on, and data of that time stay fresh.
        simulation.step = 0.0
        count = probe.state_count
        probe.wait(lambda: probe.state_count >= count + 5, "five heartbeats")
        self.assertEqual(probe.state.level, State.OK)
        self.goes_on_without_clock(probe, simulation)
        self.dies(probe, simulation)

        # A recording starts over.
        simulation.has_poses = False
        simulation.step = 0.02
        simulation.now = 10.0
        probe.wait_for_level(State.UNKNOWN)
        self.assertLess(probe.state.published_at.to_sec(), 50.0)
        simulation.has_poses = True
        probe.wait_for_level(State.OK)
        probe.wait(lambda: probe.state.header.stamp.to_sec() < 50.0, "data of the new time")
        simulation.end.set()

    def goes_on_without_clock(self, probe, simulation):
        """The clock repeats its time, as when it is paused, but poses of later times come."""
        simulation.runs_ahead = True
        probe.wait_for_level(State.UNKNOWN, "but transforms or joint states of later times come")
        probe.wait(lambda: not probe.is_valid.data, "state_is_valid false")
        simulation.runs_ahead = False
        simulation.now += simulation.ahead
        simulation.ahead = 0.0
        simulation.step = 0.02
        probe.wait_for_level(State.OK)

    def dies(self, probe, simulation):
        """The clock falls silent while poses go on, as after `rosbag play --clock`."""
        simulation.has_clock = False
        state = probe.wait_for_level(State.UNKNOWN, "nothing comes on /clock")
        self.assertIn("(stale)", state.unknown_links[0])
        self.assertEqual(state.speed_scale, 0.0)
        wall = state.published_at_wall
        probe.wait(lambda: (probe.state.published_at_wall - wall).to_sec() > 1.0,
                   "life on wall time")
        self.assertEqual(probe.state.published_at, state.published_at)
        ask = rospy.ServiceProxy("/collision_monitor/get_distances", GetDistances)
        self.assertTrue(all(math.isnan(pair.distance) for pair in ask().distances.pairs))
        simulation.has_clock = True
        probe.wait_for_level(State.OK)


if __name__ == "__main__":
    # The node under test lives in simulated time, this program in wall time.
    rospy.init_node("clock_test", disable_rostime=True)
    rostest.rosrun("collision_monitor", "clock", ClockTest, sys.argv)
