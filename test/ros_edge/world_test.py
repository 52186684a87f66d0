#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects beside urdf/two_boxes.urdf: box b, of 0.1 m edges, has its center at x = 0.25 m + slide.
The frame `conveyor` moves, and only the test publishes it."""
import sys
import threading
import unittest

import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import Pose
from shape_msgs.msg import SolidPrimitive
from std_srvs.srv import Trigger

from collision_monitor.msg import LinkDistance, SceneChange, SceneObject, SceneObjects, State
from collision_monitor.srv import (ApplyObjects, ExplainPair, GetDistances, GetDistancesRequest,
                                   GetObjects, SetPairs, SetPairsRequest)
from monitor_probe import DEADLINE, NODE, TwoBoxes, transform


def pose(x):
    place = Pose()
    place.position.x = x
    place.orientation.w = 1.0
    return place


def cube(name, x, frame=""):
    """A cube of 0.1 m edges."""
    return SceneObject(name=name, frame_id=frame, pose=pose(x),
                       primitives=[SolidPrimitive(type=SolidPrimitive.BOX, dimensions=[0.1] * 3)])


def named(name, frame="", touch_links=()):
    return SceneObject(name=name, frame_id=frame, touch_links=list(touch_links))


class World(TwoBoxes):
    """Each test begins with the floor alone."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        rospy.wait_for_service(NODE + "/get_objects", timeout=DEADLINE)
        cls.floor = rospy.ServiceProxy(NODE + "/get_objects", GetObjects)().objects.objects

    def apply(self, *changes):
        return self.service("apply_objects", ApplyObjects)(changes)

    def change(self, kind, *objects, **fields):
        answer = self.apply(SceneChange(kind=kind, objects=list(objects), **fields))
        self.assertTrue(answer.success, answer.message)

    def names(self):
        return [each.name for each in self.service("get_objects", GetObjects)().objects.objects]

    def setUp(self):
        self.joints.set(slide=0.3)
        self.change(SceneChange.REPLACE_ALL, *self.floor)
        self.probe.wait_for_distance(0.4)

    def closest(self):
        return {self.probe.state.closest.link_a, self.probe.state.closest.link_b}

    def test_theFloorOfTheParameters_isWatchedAndListed(self):
        self.assertEqual([(each.name, each.frame_id) for each in self.floor], [("floor", "rail")])
        self.assertEqual(self.floor[0].planes[0].coef, (0.0, 0.0, 1.0, 0.0))
        self.assertEqual(self.names(), ["floor"])
        request = GetDistancesRequest(links_a=["box_a"], links_b=["floor"])
        pair = self.service("get_distances", GetDistances)(request).distances.pairs[0]
        self.assertAlmostEqual(pair.distance, 1.9, places=6)
        self.assertEqual(pair.quality, LinkDistance.EXACT)

    def test_anObject_isWatchedMovedAndRemoved(self):
        self.change(SceneChange.ADD, cube("table", 0.75))
        self.probe.wait_for_distance(0.1)
        self.assertEqual(self.closest(), {"box_b", "table"})
        self.change(SceneChange.MOVE, SceneObject(name="table", pose=pose(0.67)))
        self.probe.wait_for_level(State.WARNING, "table")
        self.change(SceneChange.MOVE, SceneObject(name="table", pose=pose(0.62)))
        self.probe.wait_for_level(State.CONTACT, "table")
        self.change(SceneChange.REMOVE, named("table"))
        self.probe.wait_for_level(State.OK)
        self.assertEqual(self.names(), ["floor"])

    def test_anAttachedObject_movesWithItsLinkAndStaysWhereItIsDetached(self):
        self.change(SceneChange.ADD, cube("part", 0.63))
        self.probe.wait_for_level(State.CONTACT, "part")
        self.change(SceneChange.ATTACH, named("part", "box_b"), where_it_stands=True)
        self.probe.wait_for_level(State.OK)
        part = self.service("get_objects", GetObjects)().objects.objects[1]
        self.assertTrue(part.attached)
        self.assertAlmostEqual(part.pose.position.x, 0.08, places=6)
        self.change(SceneChange.ADD, cube("post", 0.52))
        self.joints.set(slide=0.05)  # box b at 0.3, the part at 0.38, 0.04 m before the post
        self.probe.wait_for_distance(0.04)
        self.assertEqual(self.closest(), {"part", "post"})
        self.change(SceneChange.DETACH, named("part"))
        self.joints.set(slide=0.3)
        self.probe.wait(lambda: "box_b" in self.closest() or "post" in self.closest(), "box b at the post")
        part = self.service("get_objects", GetObjects)().objects.objects[1]
        self.assertEqual((part.attached, part.frame_id), (False, "rail"))
        self.assertAlmostEqual(part.pose.position.x, 0.38, places=6)

    def test_touchLinks_mayBeTouched(self):
        held = cube("part", -0.15, "box_b")  # between the boxes, which are 0.4 m apart
        held.attached = True
        self.change(SceneChange.ADD, held)
        self.joints.set(slide=0.0)  # the part is at 0.1, within box a
        self.probe.wait_for_level(State.CONTACT, "part")
        self.change(SceneChange.ATTACH, named("part", "box_b", ["box_a"]), where_it_stands=True)
        self.probe.wait_for_distance(0.1)
        self.probe.wait_for_level(State.OK)

    def test_changesWithAFault_changeNothingAndNameAll(self):
        answer = self.apply(SceneChange(kind=SceneChange.ADD, objects=[cube("table", 0.75)]),
                            SceneChange(kind=SceneChange.ADD, objects=[cube("floor", 1.0), cube("x", 1.0, "nowhere")]),
                            SceneChange(kind=SceneChange.ATTACH, objects=[named("table", "box_c")]))
        self.assertFalse(answer.success)
        for text in ("nothing was changed", "object 'floor': this name twice", "frame 'nowhere', which is unknown",
                     "link 'box_c', which is unknown, did you mean 'box_a'?"):
            self.assertIn(text, answer.message)
        self.assertEqual(self.names(), ["floor"])

    def test_anObjectOfAMovingFrame_followsItAndIsUnknownWithoutIt(self):
        sender = tf2_ros.TransformBroadcaster()
        place = {"x": 0.75, "is_on": True}
        ends = threading.Event()

        def send():
            while not ends.wait(0.01):
                if place["is_on"]:
                    sender.sendTransform(transform("rail", "conveyor", rospy.Time.now(), place["x"]))
        thread = threading.Thread(target=send, daemon=True)
        thread.start()
        try:
            self.change(SceneChange.ADD, cube("crate", 0.0, "conveyor"))
            self.probe.wait_for_distance(0.1)
            place["x"] = 0.72
            self.probe.wait_for_distance(0.07)
            place["is_on"] = False
            self.probe.wait_for_level(State.UNKNOWN, "crate")
            place["is_on"] = True
            self.probe.wait_for_distance(0.07)
        finally:
            ends.set()
            thread.join()

    def test_questionsAboutPairsThatAreNeverChecked_areAnswered(self):
        # The object has the name of the frame that carries it.
        transforms = tf2_ros.StaticTransformBroadcaster()
        transforms.sendTransform(transform("rail", "trolley", rospy.Time.now(), 0.9))
        self.change(SceneChange.ADD, cube("trolley", 0.0, "trolley"), cube("crate", 1.2))
        answer = self.service("explain_pair", ExplainPair)(link_a="trolley", link_b="crate")
        self.assertTrue(answer.success, answer.message)
        self.assertFalse(answer.checked)
        self.assertIn("neither is attached", answer.message)
        answer = self.service("get_distances", GetDistances)(
            GetDistancesRequest(links_a=["trolley"], include_ignored=True))
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(len(answer.reasons), len(answer.distances.pairs))

    def test_twoObjectsThatARuleAsksFor_areWatched(self):
        transforms = tf2_ros.StaticTransformBroadcaster()
        transforms.sendTransform(transform("rail", "cart", rospy.Time.now(), 5.0))
        self.change(SceneChange.ADD, cube("box", 0.0, "cart"), cube("shelf", 5.3))
        rules = self.service("set_pairs", SetPairs)
        try:
            answer = rules(SetPairsRequest(rules="- {a: box, b: shelf, check: true}"))
            self.assertTrue(answer.success, answer.message)
            answer = self.service("explain_pair", ExplainPair)(link_a="box", link_b="shelf")
            self.assertTrue(answer.checked, answer.message)
            self.assertAlmostEqual(answer.now.distance, 0.2, places=6)
            answer = self.apply(SceneChange(kind=SceneChange.REMOVE, objects=[cube("shelf", 0.0)]))
            self.assertIn("rule 1 selects no pair any more", answer.message)
        finally:
            rules(SetPairsRequest(rules="[]"))

    def test_aNameThatCouldWriteTheLog_isRefused(self):
        answer = self.apply(SceneChange(kind=SceneChange.ADD, objects=[cube("a\nFATAL", 1.0)]))
        self.assertFalse(answer.success)
        self.assertIn("control characters", answer.message)
        self.assertEqual(self.names(), ["floor"])

    def test_objectsOutlastAReload_andAreListedInALatchedTopic(self):
        self.change(SceneChange.ADD, cube("table", 0.75))
        answer = self.service("reload", Trigger)()
        self.assertTrue(answer.success, answer.message)
        self.assertIn("2 objects", answer.message)
        self.probe.wait_for_distance(0.1)
        self.assertEqual(self.listed(), ["floor", "table"])
        self.change(SceneChange.CLEAR)
        self.assertEqual(self.listed(), [], "the topic has them before the service answers")
        self.assertEqual(self.names(), [])

    def listed(self):
        """The names in the topic `objects`."""
        message = rospy.wait_for_message(NODE + "/objects", SceneObjects, timeout=DEADLINE)
        return [each.name for each in message.objects]


if __name__ == "__main__":
    rospy.init_node("world_test")
    rostest.rosrun("collision_monitor", "world", World, sys.argv)
