#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two boxes of urdf/two_boxes.urdf approach and part at a known speed; their distance is 0.1 m + slide."""
import math
import sys
import threading
import unittest

import rospy
import rostest
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64

from collision_monitor.msg import State
from monitor_probe import Probe

NODE = "/collision_monitor"
SPEED = 0.2  # [m/s]


class Slider:
    """Moves the slide at a speed, evenly by its stamps, until it is told otherwise."""

    def __init__(self, rate=100.0):
        self.says_velocity = True
        self.lock = threading.Lock()
        self.begin, self.start, self.speed = rospy.Time.now(), 0.3, 0.0
        self.publisher = rospy.Publisher("/joint_states", JointState, queue_size=1)
        self.end = threading.Event()
        self.thread = threading.Thread(target=self._run, args=(1.0 / rate,), daemon=True)
        self.thread.start()

    def _place(self, now):
        return self.start + self.speed * (now - self.begin).to_sec()

    def _run(self, period):
        while not self.end.wait(period) and not rospy.is_shutdown():
            with self.lock:
                now = rospy.Time.now()
                message = JointState(name=["slide", "turn"], position=[self._place(now), 0.0])
                if self.says_velocity:
                    message.velocity = [self.speed, 0.0]
                message.header.stamp = now
                self.publisher.publish(message)

    def stand_at(self, place):
        with self.lock:
            self.begin, self.start, self.speed = rospy.Time.now(), place, 0.0

    def move(self, speed):
        with self.lock:
            now = rospy.Time.now()
            self.begin, self.start, self.speed = now, self._place(now), speed

    def stop(self):
        self.end.set()
        self.thread.join()


class LookAhead(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.probe = Probe()
        cls.scale = None
        cls.subscriber = rospy.Subscriber(NODE + "/speed_scale", Float64, cls.keep_scale)
        cls.slider = Slider()

    @classmethod
    def tearDownClass(cls):
        cls.slider.stop()

    @classmethod
    def keep_scale(cls, message):
        with cls.probe.condition:
            cls.scale = message.data
            cls.probe.condition.notify_all()

    def start_at(self, place, says_velocity):
        self.slider.says_velocity = says_velocity
        self.slider.stand_at(place)
        self.probe.wait(lambda: self.probe.state is not None and self.probe.state.has_closest and
                        abs(self.probe.state.closest.distance - 0.1 - place) < 1e-6 and
                        abs(self.probe.state.closest.closing_speed) < 1e-4, "rest at %g" % place)
        with self.probe.condition:
            self.probe.warnings = []

    def check_approach_and_retreat(self, says_velocity):
        probe, slider = self.probe, self.slider
        self.start_at(0.05, says_velocity)
        probe.wait_for_level(State.OK)
        probe.wait(lambda: self.scale == 1.0, "speed_scale 1 at rest")
        slider.move(-SPEED)
        probe.wait(lambda: self.scale < 1.0, "speed_scale below 1")
        probe.wait(lambda: probe.warnings, "a warning")
        self.assertRegex(probe.warnings[0].sentence,
                         r"^box_a is \d+(\.\d)? mm from box_b, closing at 0\.20 m/s, "
                         r"contact in 0\.\d\d s$")
        warned = probe.warnings[0].pair
        self.assertAlmostEqual(warned.closing_speed, SPEED, places=2)
        self.assertAlmostEqual(warned.time_to_contact, warned.distance / warned.closing_speed, places=9)
        probe.wait(lambda: self.scale == 0.0, "speed_scale 0")
        probe.wait(lambda: probe.state.closest.distance < 0.0, "an overlap")
        self.assertEqual(probe.state.time_to_contact, 0.0)
        slider.move(0.0)
        probe.wait(lambda: abs(probe.state.closest.closing_speed) < 1e-3, "rest in contact")
        self.assertEqual(probe.state.speed_scale, 0.0)
        slider.move(SPEED)
        probe.wait(lambda: self.scale == 1.0, "speed_scale 1 while they part")
        state = probe.wait_for_level(State.WARNING, "moving apart at 0.20 m/s")
        self.assertEqual(state.speed_scale, 1.0)
        self.assertEqual(state.time_to_contact, math.inf)
        probe.wait_for_level(State.OK)
        slider.move(0.0)

    def test_velocitiesOfJoints(self):
        self.check_approach_and_retreat(says_velocity=True)

    def test_velocitiesOfPoses(self):
        self.check_approach_and_retreat(says_velocity=False)

    def test_distances_haveSpeedTimeAndGradient(self):
        self.start_at(0.05, True)
        self.slider.move(-SPEED)
        self.probe.wait(lambda: self.probe.distances and self.probe.distances.pairs and
                        self.probe.distances.pairs[0].closing_speed > 0.19 and
                        self.probe.distances.pairs[0].distance < 0.09, "closing within the horizon")
        pair = self.probe.distances.pairs[0]
        self.slider.move(0.0)
        self.assertEqual(pair.gradient_joints, ["slide", "turn"])
        self.assertAlmostEqual(pair.gradient_values[0], 1.0, places=9)
        self.assertAlmostEqual(pair.closing_speed, SPEED, places=6)
        self.assertAlmostEqual(pair.time_to_contact, pair.distance / SPEED, places=6)


if __name__ == "__main__":
    rospy.init_node("look_ahead_test")
    rostest.rosrun("collision_monitor", "look_ahead", LookAhead, sys.argv)
