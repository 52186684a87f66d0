#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rules for pairs and limits, changed while the monitor runs. urdf/two_boxes.urdf gives the distances by hand:
0.1 m + slide, between two boxes."""
import pathlib
import sys
import tempfile
import time

import rospy
import rostest
from std_srvs.srv import Trigger

from collision_monitor.msg import LinkDistance, State
from collision_monitor.srv import ExplainPair, GetDistances, SetLimits, SetPairs, SetPairsRequest
from monitor_probe import NODE, TwoBoxes

REPLACE, APPEND = SetPairsRequest.REPLACE, SetPairsRequest.APPEND


class PairRules(TwoBoxes):

    def setUp(self):
        self.set_pairs = self.service("set_pairs", SetPairs)
        self.set_limits = self.service("set_limits", SetLimits)
        self.explain_pair = self.service("explain_pair", ExplainPair)
        self.reload = self.service("reload", Trigger)
        self.addCleanup(self.back_to_the_start)

    def back_to_the_start(self):
        if rospy.has_param(NODE + "/pair_rules"):
            rospy.delete_param(NODE + "/pair_rules")
        self.joints.set(slide=0.3)
        self.assertTrue(self.reload().success)
        self.probe.wait_for_distance(0.4)
        self.probe.wait_for_level(State.OK)

    def change(self, rules, action=REPLACE, duration=0.0):
        answer = self.set_pairs(rules=rules, action=action, duration=duration)
        self.assertTrue(answer.success, answer.message)
        return answer

    def test_rules_giveAPairItsOwnLimits(self):
        self.change("- {a: box_a, b: box_b, warning_distance: 0.5, report_distance: 0.6}")
        self.probe.wait_for_level(State.WARNING)
        self.change("- {a: box_b, b: 'box_?', warning_distance: 0.1}", APPEND)
        self.probe.wait_for_level(State.OK)
        self.change("[]")
        self.joints.set(slide=-0.08)
        self.probe.wait_for_level(State.WARNING)

    def test_ruleThatSelectsNothing_isAWarning(self):
        answer = self.change("- {a: box_a, b: box_c, check: false}")
        self.assertIn("'box_c', which matches none", answer.message)
        self.assertIn("set_pairs request", answer.message)

    def test_badRules_areAllNamed_andChangeNothing(self):
        self.change("- {a: box_a, b: box_b, warning_distance: 0.5, report_distance: 0.6}")
        self.probe.wait_for_level(State.WARNING)
        answer = self.set_pairs(rules="- {a: box_a, b: box_b, check: perhaps}\n"
                                      "- {a: box_a, warning_distance: x}\n",
                                action=REPLACE, duration=0.0)
        self.assertFalse(answer.success)
        for text in ("line 1, rule 1", "'perhaps'", "line 2, rule 2", "without 'b'", "'x'"):
            self.assertIn(text, answer.message)
        answer = self.set_pairs(rules="- {a: box_a, b: box_b, contact_distance: 0.1}", action=APPEND, duration=-1.0)
        self.assertFalse(answer.success)
        self.assertIn("duration", answer.message)
        answer = self.set_pairs(rules="- {a: box_a, b: box_b, warning_distance: 0.7}", action=APPEND, duration=0.0)
        self.assertFalse(answer.success)
        self.assertIn("report_distance", answer.message)
        self.probe.wait_for_level(State.WARNING)

    def test_mute_isTold_andEndsByItself(self):
        self.joints.set(slide=-0.08)
        self.probe.wait_for_level(State.WARNING)
        began = time.monotonic()
        answer = self.change("- {a: box_a, b: '*', check: false}", APPEND, 3.0)
        self.assertEqual(answer.pairs_muted, 1)
        state = self.probe.wait(lambda: self.probe.state.pairs_muted == 1, "a muted pair") or self.probe.state
        self.assertGreater(state.muted_for, 0.0)
        self.assertLessEqual(state.muted_for, 3.0)
        self.assertIn("1 pair of links is muted for another", state.sentence)
        answer = self.explain_pair(link_a="box_a", link_b="box_b")
        self.assertFalse(answer.checked)
        self.assertIn("muted", answer.reason)
        self.assertAlmostEqual(answer.now.distance, 0.02, places=6)
        self.probe.wait(lambda: self.probe.state.pairs_muted == 0, "the end of the mute")
        self.assertGreater(time.monotonic() - began, 2.5)
        self.probe.wait_for_level(State.WARNING)

    def test_mute_endsEarlyByAnEmptyList(self):
        self.change("- {a: box_a, b: box_b, check: false}", APPEND, 600.0)
        self.probe.wait(lambda: self.probe.state.pairs_muted == 1, "a muted pair")
        self.change("[]", REPLACE, 1.0)
        self.probe.wait(lambda: self.probe.state.pairs_muted == 0, "the end of the mute")
        self.probe.wait_for_distance(0.4)

    def test_limits_changeAtOnce_orNotAtAll(self):
        answer = self.set_limits(names=["warning_distance", "report_distance"], values=[0.5, 0.6])
        self.assertTrue(answer.success, answer.message)
        self.probe.wait_for_level(State.WARNING)
        answer = self.set_limits(names=["warning_distnace", "hysteresis", "contact_time"],
                                 values=[0.1, -1.0, float("nan")])
        self.assertFalse(answer.success)
        for text in ("did you mean 'warning_distance'", "hysteresis", "contact_time"):
            self.assertIn(text, answer.message)
        answer = self.set_limits(names=["contact_distance", "warning_distance"], values=[0.2, 0.1])
        self.assertFalse(answer.success)
        self.assertIn("warning_distance", answer.message)
        self.probe.wait_for_level(State.WARNING)

    def test_parameter_isAListOrAFile_andRulesThatSelectNothingAreErrors(self):
        rospy.set_param(NODE + "/pair_rules", [{"a": "box_a", "b": "box_b", "warning_distance": 0.5,
                                                "report_distance": 0.6}])
        answer = self.reload()
        self.assertTrue(answer.success, answer.message)
        self.probe.wait_for_level(State.WARNING)
        explained = self.explain_pair(link_a="box_a", link_b="box_b")
        self.assertIn("parameter %s/pair_rules line 1, rule 1" % NODE, explained.limit_places)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "rules.yaml"
            path.write_text("pair_rules:\n- {a: box_a, b: box_c, check: false}\n", encoding="utf-8")
            rospy.set_param(NODE + "/pair_rules", str(path))
            answer = self.reload()
        self.assertFalse(answer.success)
        self.assertIn("rules.yaml line 2, rule 1: link 'box_c', which matches none", answer.message)
        self.probe.wait_for_level(State.WARNING)

    def test_explanation_saysWhyAndHowNear(self):
        self.joints.set(slide=-0.08)
        self.probe.wait_for_distance(0.02)
        self.joints.set(slide=0.3)
        self.probe.wait_for_distance(0.4)
        answer = self.explain_pair(link_a="box_b", link_b="box_a")
        self.assertTrue(answer.success, answer.message)
        self.assertTrue(answer.checked)
        self.assertIn("checked: no rule says otherwise", answer.reason)
        self.assertAlmostEqual(answer.now.distance, 0.4, places=6)
        self.assertEqual(answer.level, State.OK)
        self.assertIn("warning_distance", answer.level_reason)
        self.assertAlmostEqual(answer.nearest, 0.02, places=6)
        positions = dict(zip(answer.nearest_joints, answer.nearest_positions))
        self.assertAlmostEqual(positions["slide"], -0.08, places=6)
        self.assertEqual(dict(zip(answer.limit_names, answer.limit_values))["warning_distance"], 0.05)

    def test_explanation_refusesWhatIsNoPair(self):
        for links in (("box_a", "box_c"), ("box_a", "box_a")):
            answer = self.explain_pair(link_a=links[0], link_b=links[1])
            self.assertFalse(answer.success)
            self.assertNotEqual(answer.message, "")

    def test_ignoredPairs_areMeasuredWhenAskedFor(self):
        self.change("- {a: box_a, b: box_b, check: false}")
        get_distances = self.service("get_distances", GetDistances)
        self.assertFalse(get_distances(links_a=["box_a"], links_b=["box_b"]).success)
        answer = get_distances(links_a=["box_a"], links_b=["box_b"], include_ignored=True)
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(len(answer.distances.pairs), 1)
        self.assertAlmostEqual(answer.distances.pairs[0].distance, 0.4, places=6)
        self.assertEqual(answer.distances.pairs[0].quality, LinkDistance.EXACT)
        self.assertRegex(answer.reasons[0], r"ignored: a rule for pairs \(set_pairs request \d+ line 1, rule 1\)")


if __name__ == "__main__":
    rospy.init_node("pair_rules_test")
    rostest.rosrun("collision_monitor", "pair_rules", PairRules, sys.argv)
