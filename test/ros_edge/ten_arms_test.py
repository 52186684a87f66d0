#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ten arms of launch/ten_arms.launch, each with a tf prefix of its own. Prints the cycle time."""
import statistics
import sys
import unittest

import rospy
import rostest

from collision_monitor.msg import State
from monitor_probe import Probe

ARMS = ["arm_%d" % i for i in range(10)]


class TenArms(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.probe = Probe()

    def test_allAreWatched(self):
        self.probe.wait(lambda: self.probe.state is not None and len(self.probe.state.robots) == 10 and
                        all(robot.level != State.UNKNOWN for robot in self.probe.state.robots), "ten known arms")
        state = self.probe.state
        self.assertEqual([robot.name for robot in state.robots], ARMS)
        self.assertEqual(state.unknown_links, [])
        self.assertEqual(state.level, max(robot.level for robot in state.robots))
        for robot in state.robots:
            self.assertGreaterEqual(robot.speed_scale, state.speed_scale)

    def test_cyclesOfAWholePath(self):
        times = []
        begin = rospy.get_time()
        while rospy.get_time() < begin + 12.0:
            seen = self.probe.state_count
            self.probe.wait(lambda: self.probe.state_count > seen, "another state")
            times.append(self.probe.state.cycle_time)
        times.sort()
        print("ten arms, %d pairs of shapes, %d cycles: median %.0f us, 99 of 100 %.0f us, worst %.0f us" % (
            self.probe.state.pairs_checked, len(times), 1e6 * statistics.median(times),
            1e6 * times[int(0.99 * len(times))], 1e6 * times[-1]))
        self.assertEqual(self.probe.state.unknown_links, [])
        self.assertGreater(self.probe.state.pairs_checked, 1000)


if __name__ == "__main__":
    rospy.init_node("ten_arms_test")
    rostest.rosrun("collision_monitor", "ten_arms", TenArms, sys.argv)
