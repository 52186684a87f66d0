# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the rostests share: the newest messages of the monitor, waiting for a condition with a
deadline, and a source of joint states."""
import threading
import time
import unittest

import rospy
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import JointState
from std_msgs.msg import Bool

from collision_monitor.msg import Contacts, Distances, State, PairWarning

NODE = "/collision_monitor"
DEADLINE = 20.0  # wall seconds; far more than anything takes, so a failure is a failure


def transform(parent, child, stamp, x):
    """A translation along x."""
    message = TransformStamped()
    message.header.frame_id = parent
    message.header.stamp = stamp
    message.child_frame_id = child
    message.transform.translation.x = x
    message.transform.rotation.w = 1.0
    return message


class Probe:
    """Keeps the newest message of each topic and every warning."""

    def __init__(self, name=NODE):
        self.condition = threading.Condition()
        self.state = None
        self.state_count = 0
        self.contacts = None
        self.distances = None
        self.is_valid = None
        self.warnings = []
        self.subscribers = [
            rospy.Subscriber(name + "/state", State, self._keep_state),
            rospy.Subscriber(name + "/contacts", Contacts, self._keep("contacts")),
            rospy.Subscriber(name + "/distances", Distances, self._keep("distances")),
            rospy.Subscriber(name + "/state_is_valid", Bool, self._keep("is_valid")),
            rospy.Subscriber(name + "/warnings", PairWarning, self._keep_warning)]

    def _keep_state(self, message):
        with self.condition:
            self.state = message
            self.state_count += 1
            self.condition.notify_all()

    def _keep_warning(self, message):
        with self.condition:
            self.warnings.append(message)
            self.condition.notify_all()

    def _keep(self, name):
        def keep(message):
            with self.condition:
                setattr(self, name, message)
                self.condition.notify_all()
        return keep

    def wait(self, predicate, what):
        """Waits until predicate() holds; fails naming what was waited for and what was seen."""
        end = time.monotonic() + DEADLINE
        with self.condition:
            while not predicate():
                left = end - time.monotonic()
                if left <= 0.0:
                    seen = "no state at all" if self.state is None else (
                        "level %d: %s" % (self.state.level, self.state.sentence))
                    raise AssertionError("waited for %s; last state: %s" % (what, seen))
                self.condition.wait(min(left, 0.5))

    def wait_for_level(self, level, sentence=""):
        self.wait(lambda: self.state is not None and self.state.level == level and
                  sentence in self.state.sentence, "level %d '%s'" % (level, sentence))
        return self.state

    def wait_for_distance(self, distance, tolerance=1e-6):
        self.wait(lambda: self.state is not None and self.state.has_closest and
                  abs(self.state.closest.distance - distance) <= tolerance,
                  "closest distance %g" % distance)
        return self.state


class JointSource:
    """Publishes the same joint positions over and over, until told others."""

    def __init__(self, positions, rate=50.0, topic="/joint_states"):
        self.positions = dict(positions)
        self.is_on = True
        self.publisher = rospy.Publisher(topic, JointState, queue_size=1)
        self.end = threading.Event()
        self.thread = threading.Thread(target=self._run, args=(1.0 / rate,), daemon=True)
        self.thread.start()

    def _run(self, period):
        while not self.end.wait(period) and not rospy.is_shutdown():
            if self.is_on:
                positions = dict(self.positions)
                message = JointState(name=list(positions), position=list(positions.values()))
                message.header.stamp = rospy.Time.now()
                self.publisher.publish(message)

    def set(self, **positions):
        self.positions = dict(self.positions, **positions)

    def stop(self):
        self.end.set()
        self.thread.join()


class TwoBoxes(unittest.TestCase):
    """A monitor of urdf/two_boxes.urdf, whose joints are 0.3 m and 0 rad when tests begin."""

    @classmethod
    def setUpClass(cls):
        cls.probe = Probe()
        cls.joints = JointSource({"slide": 0.3, "turn": 0.0})

    @classmethod
    def tearDownClass(cls):
        cls.joints.stop()

    def service(self, name, kind):
        rospy.wait_for_service(NODE + "/" + name, timeout=DEADLINE)
        return rospy.ServiceProxy(NODE + "/" + name, kind)
