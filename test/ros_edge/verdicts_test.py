#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two boxes meet and part; urdf/two_boxes.urdf gives the distances by hand: 0.1 m + slide."""
import math
import sys

import rospy
import rostest
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64
from std_srvs.srv import SetBool, Trigger

from collision_monitor.msg import LinkDistance, State, PairWarning
from collision_monitor.srv import CheckStates, CheckTrajectory, GetDistances
from diagnostic_msgs.msg import DiagnosticArray
from monitor_probe import NODE, Probe, TwoBoxes
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint
from visualization_msgs.msg import Marker, MarkerArray


class Verdicts(TwoBoxes):

    def setUp(self):
        self.joints.is_on = True
        self.joints.set(slide=0.3, turn=0.0)
        self.probe.wait_for_distance(0.4)
        with self.probe.condition:
            self.probe.warnings = []

    def test_path_clearWarningContactClear(self):
        state = self.probe.wait_for_level(State.OK)
        self.assertTrue(state.enabled)
        self.joints.set(slide=-0.07)
        state = self.probe.wait_for_level(State.WARNING)
        state = self.probe.wait_for_distance(0.03)
        self.assertEqual(state.closest.quality, LinkDistance.EXACT)
        # Nothing closes any more once the boxes rest.
        self.probe.wait(lambda: self.probe.state.sentence == "box_a is 30 mm from box_b", "rest at 30 mm")
        self.joints.set(slide=-0.13)
        state = self.probe.wait_for_level(State.CONTACT)
        state = self.probe.wait_for_distance(-0.03)
        self.assertEqual((state.closest.link_a, state.closest.link_b), ("box_a", "box_b"))
        self.assertAlmostEqual(state.closest.normal.x, 1.0, places=6)
        self.probe.wait(lambda: self.probe.state.sentence == "box_a overlaps box_b by 30 mm", "rest in contact")
        self.probe.wait(lambda: self.probe.contacts and self.probe.contacts.contacts and
                        abs(self.probe.contacts.contacts[0].depth - 0.03) < 1e-6, "the contact")
        contact = self.probe.contacts.contacts[0]
        self.assertEqual((len(self.probe.contacts.contacts), contact.island), (1, 1))
        self.assertAlmostEqual(contact.points[0].x, 0.085, places=6)
        self.probe.wait(lambda: self.probe.is_valid.data is False, "state_is_valid false")
        self.joints.set(slide=0.3)
        self.probe.wait_for_level(State.OK)
        self.probe.wait(lambda: self.probe.is_valid.data is True, "state_is_valid true")
        self.probe.wait(lambda: self.probe.warnings and
                        self.probe.warnings[-1].after == PairWarning.CLEAR, "the last warning")
        verdicts = [warning.after for warning in self.probe.warnings]
        # robot_state_publisher may show the jump of the joint at once or not; the order holds.
        self.assertEqual(verdicts, [PairWarning.WARNING, PairWarning.CONTACT,
                                    PairWarning.CLEAR])
        self.assertEqual(self.probe.warnings[0].before, PairWarning.CLEAR)

    def test_distances_holdTheClosestPairWithDataStamp(self):
        self.joints.set(slide=0.0)
        self.probe.wait_for_distance(0.1)
        self.probe.wait(lambda: self.probe.distances and self.probe.distances.pairs and
                        abs(self.probe.distances.pairs[0].distance - 0.1) < 1e-6, "0.1 m")
        distances = self.probe.distances
        self.assertEqual((distances.closest, distances.pairs_checked), (0, 1))
        self.assertEqual(distances.header.frame_id, "rail")
        self.assertFalse(distances.truncated)
        self.assertLess((rospy.Time.now() - distances.header.stamp).to_sec(), 20.0)

    def test_silentJoints_unknownThenBack(self):
        self.joints.is_on = False
        state = self.probe.wait_for_level(State.UNKNOWN, "link box_b is unknown: no transform")
        self.assertEqual(state.unknown_links, ["box_b (stale)"])
        self.probe.wait(lambda: self.probe.is_valid.data is False, "state_is_valid false")
        # Nobody listened when the scale fell.
        self.assertEqual(rospy.wait_for_message(NODE + "/speed_scale", Float64, 20.0).data, 0.0)
        self.joints.is_on = True
        self.probe.wait_for_level(State.OK)

    def test_lateSubscriber_getsTheLatchedState(self):
        late = Probe()
        late.wait(lambda: late.state is not None and late.is_valid is not None, "the latched state")

    def test_getDistances_now(self):
        answer = self.service("get_distances", GetDistances)([], [], JointState(), 0.0, False)
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(len(answer.distances.pairs), 1)
        self.assertAlmostEqual(answer.distances.pairs[0].distance, 0.4, places=6)

    def test_getDistances_forGivenJoints_leavesTheMonitorAlone(self):
        joints = JointState(name=["slide", "turn"], position=[0.0, math.pi / 4.0])
        answer = self.service("get_distances", GetDistances)(["box_b"], ["box_a"], joints, 0.0, False)
        self.assertTrue(answer.success, answer.message)
        self.assertAlmostEqual(answer.distances.pairs[0].distance,
                               0.15 - 0.05 * math.sqrt(2.0), places=9)
        self.assertEqual(answer.distances.pairs[0].link_a, "box_a")
        self.assertAlmostEqual(self.probe.state.closest.distance, 0.4, places=6)

    def test_getDistances_refusesWhatItDoesNotKnow(self):
        call = self.service("get_distances", GetDistances)
        answer = call(["box_aa"], [], JointState(name=["slid"], position=[0.0]), 0.0, False)
        self.assertFalse(answer.success)
        self.assertIn("did you mean 'box_a'", answer.message)
        self.assertIn("did you mean 'slide'", answer.message)
        answer = call([], [], JointState(name=["slide"], position=[float("nan")]), 0.0, False)
        self.assertFalse(answer.success)
        answer = call([], [], JointState(name=["slide"], position=[]), 0.0, False)
        self.assertFalse(answer.success)

    def test_getDistances_namesPairsThatAreIgnored(self):
        answer = self.service("get_distances", GetDistances)(["rail"], ["box_a"], JointState(), 0.0, False)
        self.assertFalse(answer.success)
        self.assertIn("rail and box_a (", answer.message)

    def test_checkStates_judgesEveryState_andLeavesTheMonitorAlone(self):
        answer = self.service("check_states", CheckStates)(
            ["slide"], [0.3, -0.07, -0.13, float("nan")], False, False)
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(list(answer.levels),
                         [State.OK, State.WARNING, State.CONTACT, State.UNKNOWN])
        for found, expected in zip(answer.distances, [0.4, 0.03, -0.03]):
            self.assertAlmostEqual(found, expected, places=9)
        self.assertEqual((answer.links_a[2], answer.links_b[2]), ("box_a", "box_b"))
        self.assertEqual(self.probe.state.level, State.OK)

    def test_checkTrajectory_beginsWhereTheBoxesAre(self):
        point = JointTrajectoryPoint(positions=[-1.0], time_from_start=rospy.Duration(2.0))
        answer = self.service("check_trajectory", CheckTrajectory)(
            JointTrajectory(joint_names=["slide"], points=[point]), 0.0, 0.0)
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.level, State.CONTACT)
        # They touch at -0.1, 0.4 m of 1.3 m from here.
        self.assertAlmostEqual(answer.contact_time, 2.0 * 0.4 / 1.3, places=4)

    def test_setEnabled_warningWhileOff_andOnAgainByItself(self):
        answer = self.service("set_enabled", SetBool)(False)
        self.assertTrue(answer.success)
        self.assertIn("in 0.75 s", answer.message)
        state = self.probe.wait_for_level(State.WARNING, "switched off")
        self.assertFalse(state.enabled)
        self.probe.wait(lambda: self.probe.is_valid.data is False, "state_is_valid false")
        state = self.probe.wait_for_level(State.OK)  # disable_timeout is 0.75 s here
        self.assertTrue(state.enabled)

    def wait_for_warning(self, after, sentence):
        self.probe.wait(lambda: self.probe.warnings and self.probe.warnings[-1].after == after and
                        sentence in self.probe.warnings[-1].sentence, "warning '%s'" % sentence)

    def test_contactThatEndsWhileSwitchedOff_isTakenBack(self):
        self.joints.set(slide=-0.13)
        self.wait_for_warning(PairWarning.CONTACT, "box_a overlaps box_b")
        self.assertTrue(self.service("set_enabled", SetBool)(False).success)
        self.joints.set(slide=0.3)
        self.wait_for_warning(PairWarning.CLEAR, "clear")  # disable_timeout is 0.75 s here
        self.assertEqual(self.probe.warnings[-1].before, PairWarning.CONTACT)

    def test_contactThatIsCheckedNoMore_isTakenBackAndToldAnew(self):
        reload_setup = self.service("reload", Trigger)
        self.joints.set(slide=-0.13)
        self.wait_for_warning(PairWarning.CONTACT, "box_a overlaps box_b")
        rospy.set_param(NODE + "/ignore_pairs", [["box_a", "box_b"]])
        self.assertTrue(reload_setup().success)
        self.wait_for_warning(PairWarning.CLEAR, "box_a and box_b are not checked any more")
        rospy.delete_param(NODE + "/ignore_pairs")
        self.assertTrue(reload_setup().success)
        self.wait_for_warning(PairWarning.CONTACT, "box_a overlaps box_b")
        told = len(self.probe.warnings)
        self.assertTrue(reload_setup().success)
        self.joints.set(slide=0.3)
        self.wait_for_warning(PairWarning.CLEAR, "clear")
        self.assertNotIn(PairWarning.CONTACT, [w.after for w in self.probe.warnings[told:]])

    def test_reload_takesNewLimits_andKeepsTheOldSetUpOnFailure(self):
        reload_setup = self.service("reload", Trigger)
        rospy.set_param(NODE + "/limits/warning_distance", 0.5)
        rospy.set_param(NODE + "/limits/report_distance", 0.5)
        answer = reload_setup()
        self.assertTrue(answer.success, answer.message)
        self.probe.wait_for_level(State.WARNING)
        rospy.set_param(NODE + "/limits/warning_distance", 0.05)
        rospy.set_param(NODE + "/rat", 3)
        answer = reload_setup()
        self.assertFalse(answer.success)
        self.assertIn("/collision_monitor/rat", answer.message)
        self.probe.wait_for_level(State.WARNING)
        rospy.delete_param(NODE + "/rat")
        self.assertTrue(reload_setup().success)
        self.probe.wait_for_level(State.OK)

    def test_markers_appearAndAreDeleted(self):
        seen = []
        with_lock = self.probe.condition

        def keep(message):
            with with_lock:
                seen.extend(message.markers)
                with_lock.notify_all()
        subscriber = rospy.Subscriber(NODE + "/markers", MarkerArray, keep)
        self.joints.set(slide=-0.13)

        def has(name_space, action):
            return lambda: any(m.ns == name_space and m.action == action for m in seen)
        for name_space in ("shapes", "contacts", "distances", "labels"):
            self.probe.wait(has(name_space, Marker.ADD), name_space)
        self.joints.set(slide=0.3)
        self.probe.wait(has("contacts", Marker.DELETE), "deleted contacts")
        subscriber.unregister()

    def test_diagnostics_nameTheVerdict(self):
        entries = {}

        def keep(message):
            with self.probe.condition:
                entries.update({status.name: status for status in message.status})
                self.probe.condition.notify_all()
        subscriber = rospy.Subscriber("/diagnostics", DiagnosticArray, keep)
        for entry in ("verdict", "cycle", "budget", "step", "setup"):
            self.probe.wait(lambda name="collision_monitor: " + entry: name in entries, entry)
        values = {value.key: value.value for value in entries["collision_monitor: cycle"].values}
        self.assertGreater(float(values["frequency [Hz]"]), 0.0)
        # A metre in a step of the joint states: the boxes are 0.3 m thick together.
        self.joints.set(slide=1.3)
        self.probe.wait(lambda: "from pose to pose" in entries["collision_monitor: step"].message or
                        "came too late" in entries["collision_monitor: step"].message, "the step over the cap")
        self.assertGreater(self.probe.state.steps_over_cap, 0)
        subscriber.unregister()


if __name__ == "__main__":
    rospy.init_node("verdicts_test")
    rostest.rosrun("collision_monitor", "verdicts", Verdicts, sys.argv)
