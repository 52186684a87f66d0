#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The URDF of the right robot comes after the monitor has started, first a broken one; later its joint
states end. The left robot is watched all the while. The robots stand as in two_robots_test.py. The
tests are one story, in the order of their names."""
import sys
import threading
import unittest

import rospy
import rostest
from shape_msgs.msg import SolidPrimitive
from std_msgs.msg import Bool, Float64
from std_srvs.srv import Trigger

from collision_monitor.msg import SceneChange, SceneObject, SceneObjects, State
from collision_monitor.srv import (ApplyObjects, GetDistances, GetDistancesRequest, SetLimits, SetPairs,
                                   SetPairsRequest)
from monitor_probe import JointSource, Probe

URDF = "/right/description"


class Latest:
    """The newest value of a topic."""

    def __init__(self, topic, kind):
        self.value = None
        self.subscriber = rospy.Subscriber(topic, kind, self._keep)

    def _keep(self, message):
        self.value = message


class LateRobots(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.probe = Probe()
        cls.left = JointSource({"slide": 0.3, "turn": 0.0}, topic="/left/joint_states")
        cls.right = JointSource({"slide": 0.3, "turn": 0.0}, topic="/right/joint_states")
        cls.scales = {name: Latest("/collision_monitor/robots/%s/speed_scale" % name, Float64)
                      for name in ("left", "right")}
        cls.valid = {name: Latest("/collision_monitor/robots/%s/state_is_valid" % name, Bool)
                     for name in ("left", "right")}
        cls.objects = Latest("/collision_monitor/objects", SceneObjects)

    @classmethod
    def tearDownClass(cls):
        cls.left.stop()
        cls.right.stop()

    def wait_for_robots(self, predicate, what):
        """@return the state in which predicate(left, right) holds."""
        def holds():
            state = self.probe.state
            return state is not None and len(state.robots) == 2 and predicate(*state.robots)
        self.probe.wait(holds, what)
        return self.probe.state

    def object_names(self):
        return [] if self.objects.value is None else [one.name for one in self.objects.value.objects]

    def test_1_monitorStartsWithTheRobotThatIsThere(self):
        state = self.probe.wait_for_level(State.UNKNOWN, "robot 'right' is missing: no URDF in parameter " + URDF)
        self.assertIn("robot right (no description)", state.unknown_links)
        self.assertEqual(state.speed_scale, 0.0)
        self.assertEqual([robot.name for robot in state.robots], ["left", "right"])
        self.assertEqual([bool(robot.has_description) for robot in state.robots], [True, False])
        # The shelf may touch a link that is not there yet: 0.24 - 0.1 - 0.05 from this one.
        state = self.probe.wait_for_distance(0.09)
        self.assertEqual((state.closest.link_a, state.closest.link_b), ("left/box_a", "shelf"))
        self.probe.wait(lambda: self.object_names() == ["shelf", "wall"], "objects that stand by themselves")

    def test_2_whatIsMissing_stopsTheOthers(self):
        state = self.wait_for_robots(lambda left, right: left.sentence != "" and left.age > 0.0, "poses of the left")
        self.assertEqual([robot.level for robot in state.robots], [State.UNKNOWN, State.UNKNOWN])
        self.assertEqual([robot.speed_scale for robot in state.robots], [0.0, 0.0])
        self.assertIn("'right' is missing", state.robots[0].sentence)

    def test_2b_objectsMayTouchLinksOfAMissingRobot(self):
        apply_objects = rospy.ServiceProxy("/collision_monitor/apply_objects", ApplyObjects)
        sphere = SolidPrimitive(type=SolidPrimitive.SPHERE, dimensions=[0.01])
        pad = SceneObject(name="pad", primitives=[sphere], touch_links=["right/box_b", "left/box_z"])
        pad.pose.position.z = 7.0
        pad.pose.orientation.w = 1.0
        answer = apply_objects([SceneChange(kind=SceneChange.ADD, objects=[pad])])
        self.assertIn("touch link 'left/box_z', which is unknown", answer.message)
        pad.touch_links.pop()
        answer = apply_objects([SceneChange(kind=SceneChange.ADD, objects=[pad])])
        self.assertTrue(answer.success, answer.message)
        answer = apply_objects([SceneChange(kind=SceneChange.REMOVE, objects=[SceneObject(name="pad")])])
        self.assertTrue(answer.success, answer.message)

    def test_3_brokenDescription_changesNothing(self):
        rospy.set_param(URDF, "<robot name='right'><link/></robot>")
        cycles = self.probe.state.cycles
        self.probe.wait(lambda: self.probe.state.cycles > cycles + 200, "two more seconds of cycles")
        state = self.wait_for_robots(lambda left, right: "cannot be taken in" in right.sentence, "the fault")
        self.assertFalse(state.robots[1].has_description)
        self.assertIn("cannot be taken in", state.robots[0].sentence)
        self.probe.wait_for_distance(0.09)
        answer = rospy.ServiceProxy("/collision_monitor/set_limits", SetLimits)(["hysteresis"], [0.003])
        self.assertTrue(answer.success, answer.message)

    def test_4_robotThatComes_isWatchedFromThenOn(self):
        rospy.set_param(URDF, rospy.get_param("/robot_description").replace("two_boxes", "other_boxes"))
        state = self.probe.wait_for_level(State.WARNING)
        self.probe.wait_for_distance(0.04)
        self.assertEqual((self.probe.state.closest.link_a, self.probe.state.closest.link_b),
                         ("left/box_a", "right/box_a"))
        self.assertEqual(state.header.frame_id, "cell")
        self.assertEqual(state.unknown_links, [])
        self.assertEqual(state.pairs_ignored, 1)
        self.probe.wait(lambda: self.object_names() == ["shelf", "tool", "wall"], "the object attached to it")
        state = self.wait_for_robots(lambda left, right: left.speed_scale == 1.0 and right.speed_scale == 1.0,
                                     "free robots")
        self.assertEqual([robot.level for robot in state.robots], [State.WARNING, State.WARNING])
        self.assertAlmostEqual(state.robots[0].distance, 0.04, places=6)
        for name in ("left", "right"):
            self.probe.wait(lambda: self.scales[name].value is not None and self.scales[name].value.data == 1.0,
                            "speed scale of " + name)
            self.assertTrue(self.valid[name].value.data)

    def test_5_robotThatGoesAndMustNotBeAbsent_stopsTheOthers(self):
        self.right.is_on = False
        state = self.wait_for_robots(lambda left, right: right.level == State.UNKNOWN, "unknown right robot")
        self.assertEqual(state.level, State.UNKNOWN)
        self.assertEqual(state.robots[0].level, State.UNKNOWN)
        self.assertIn("right/box_b", state.robots[0].sentence)
        self.assertEqual([robot.speed_scale for robot in state.robots], [0.0, 0.0])
        self.probe.wait(lambda: not self.valid["left"].value.data, "state_is_valid of the left")

    def test_6_byDefault_robotThatIsAbsentDoesNotStopTheOthers(self):
        robots = rospy.get_param("/collision_monitor/robots")
        del robots[1]["may_be_absent"]
        rospy.set_param("/collision_monitor/robots", robots)
        rospy.wait_for_service("/collision_monitor/reload", timeout=20.0)
        answer = rospy.ServiceProxy("/collision_monitor/reload", Trigger)()
        self.assertTrue(answer.success, answer.message)
        state = self.wait_for_robots(
            lambda left, right: left.level == State.WARNING and left.speed_scale == 1.0, "free left robot")
        self.assertEqual(state.level, State.UNKNOWN)
        self.assertEqual(state.speed_scale, 0.0)
        self.assertEqual(state.robots[1].level, State.UNKNOWN)
        self.assertEqual(state.robots[1].speed_scale, 0.0)
        self.probe.wait(lambda: self.scales["left"].value.data == 1.0 and self.scales["right"].value.data == 0.0,
                        "scales of both")

    def test_7_itComesBack(self):
        self.right.is_on = True
        state = self.wait_for_robots(lambda left, right: right.level == State.WARNING and right.speed_scale == 1.0,
                                     "free right robot")
        self.assertEqual(state.level, State.WARNING)

    def test_8_robotWhoseDescriptionIsGone_isMissingAfterAReload(self):
        rospy.delete_param(URDF)
        answer = rospy.ServiceProxy("/collision_monitor/reload", Trigger)()
        self.assertTrue(answer.success, answer.message)
        state = self.wait_for_robots(lambda left, right: not right.has_description and left.speed_scale == 1.0,
                                     "missing right robot")
        self.assertEqual(state.level, State.UNKNOWN)
        self.assertEqual(state.robots[0].level, State.OK)
        self.probe.wait(lambda: self.object_names() == ["shelf", "wall"], "the object attached to it to be gone")
        self.assertEqual(self.objects.value.waiting, ["tool"])
        another = SceneObject(name="tool", primitives=[SolidPrimitive(SolidPrimitive.SPHERE, [0.01])])
        another.pose.orientation.w = 1.0
        answer = rospy.ServiceProxy("/collision_monitor/apply_objects", ApplyObjects)(
            [SceneChange(kind=SceneChange.ADD, objects=[another])])
        self.assertIn("'tool': the name of an object that waits for a robot", answer.message)

    def test_8b_reloadThatWaits_keepsNoMuteFromEndingAndNoServiceWaiting(self):
        """The right robot is missing, and a reload waits for it."""
        self.left.set(slide=-0.15)
        self.wait_for_robots(lambda left, right: left.level == State.CONTACT, "contact of the left robot")
        answer = rospy.ServiceProxy("/collision_monitor/set_pairs", SetPairs)(
            rules="- {a: left/box_a, b: left/box_b, check: false}", action=SetPairsRequest.APPEND, duration=3.0)
        self.assertTrue(answer.success, answer.message)
        self.wait_for_robots(lambda left, right: left.level == State.OK, "the mute")
        rospy.set_param("/collision_monitor/wait_for_description", 10.0)
        self.addCleanup(rospy.set_param, "/collision_monitor/wait_for_description", 0.2)
        reload = threading.Thread(target=rospy.ServiceProxy("/collision_monitor/reload", Trigger))
        reload.start()
        self.addCleanup(reload.join)
        set_limits = rospy.ServiceProxy("/collision_monitor/set_limits", SetLimits)
        self.probe.wait(lambda: not set_limits(["hysteresis"], [0.004]).success, "a refused change")
        self.assertIn("another change is running", set_limits(["hysteresis"], [0.004]).message)
        answer = rospy.ServiceProxy("/collision_monitor/get_distances", GetDistances)(GetDistancesRequest())
        self.assertTrue(answer.success, answer.message)
        state = self.wait_for_robots(lambda left, right: left.level == State.CONTACT, "the end of the mute")
        self.assertEqual(state.pairs_muted, 0)
        self.assertTrue(reload.is_alive(), "the mute ended only with the reload")
        self.left.set(slide=0.3)

    def test_9_robotThatLeavesTheList_isStopped(self):
        self.probe.wait(lambda: self.scales["left"].value.data == 1.0, "free left robot")
        robots = rospy.get_param("/collision_monitor/robots")
        robots[0]["name"] = "another"
        rospy.set_param("/collision_monitor/robots", robots)
        answer = rospy.ServiceProxy("/collision_monitor/reload", Trigger)()
        self.assertTrue(answer.success, answer.message)
        self.probe.wait(lambda: self.scales["left"].value.data == 0.0 and not self.valid["left"].value.data,
                        "0 and false for the robot that is not listed any more")
        late = Latest("/collision_monitor/robots/left/speed_scale", Float64)
        self.probe.wait(lambda: late.value is not None and late.value.data == 0.0, "0 for late listeners")


if __name__ == "__main__":
    rospy.init_node("late_robots_test")
    rostest.rosrun("collision_monitor", "late_robots", LateRobots, sys.argv)
