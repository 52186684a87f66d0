#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rules for shapes are read anew by `reload`, bad ones change nothing, fits are kept in a folder.
urdf/two_boxes.urdf gives the distances by hand: 0.1 m + slide, between two boxes."""
import pathlib
import sys
import tempfile

import rospy
import rostest
from std_srvs.srv import Trigger

from monitor_probe import NODE, TwoBoxes


class ShapeRules(TwoBoxes):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.reload = self.service("reload", Trigger)
        self.addCleanup(rospy.set_param, NODE + "/fit_cache", "none")
        self.addCleanup(rospy.set_param, NODE + "/shape_rules", "")

    def reload_with(self, rules):
        path = self.folder / "rules.yaml"
        path.write_text(rules, encoding="utf-8")
        rospy.set_param(NODE + "/shape_rules", str(path))
        return self.reload()

    def test_padding_isReadAnewWithEachReload(self):
        self.assertTrue(self.reload_with("shapes: [{link: box_a, padding: 0.05}]").success)
        self.probe.wait_for_distance(0.35)
        self.assertTrue(self.reload_with("shapes: [{links: 'box_*', padding: 0.04}]").success)
        self.probe.wait_for_distance(0.32)

    def test_givenShape_isNamedInTheState(self):
        answer = self.reload_with(
            "shapes: [{link: box_a, unproven: true, shapes: [{kind: sphere, radius: 0.01}]}]")
        self.assertTrue(answer.success, answer.message)
        self.probe.wait(lambda: self.probe.state.closest.shape_a == "unproven/sphere",
                        "the given shape")

    def test_badRules_areAllNamed_andChangeNothing(self):
        self.assertTrue(self.reload_with("shapes: [{link: box_a, padding: 0.05}]").success)
        answer = self.reload_with("shapes:\n"
                                  "  - {link: box_c, padding: 0.1}\n"
                                  "  - {link: box_a, padding: -0.1}\n")
        self.assertFalse(answer.success)
        for text in ("rules.yaml line 2", "'box_c'", "rules.yaml line 3", "'-0.1'"):
            self.assertIn(text, answer.message)
        self.probe.wait_for_distance(0.35)

    def test_missingFile_isNamed(self):
        rospy.set_param(NODE + "/shape_rules", "/nowhere/rules.yaml")
        answer = self.reload()
        self.assertFalse(answer.success)
        self.assertIn("/nowhere/rules.yaml", answer.message)

    def test_fits_areKeptInTheFolder(self):
        fits = self.folder / "fits"
        rospy.set_param(NODE + "/fit_cache", str(fits))
        rules = "shapes: [{links: '*', kinds: [sphere]}]"
        self.assertTrue(self.reload_with(rules).success)
        kept = {path: path.stat().st_mtime_ns for path in fits.iterdir()}
        self.assertTrue(kept)
        self.assertTrue(self.reload_with(rules).success)
        self.assertEqual(kept, {path: path.stat().st_mtime_ns for path in fits.iterdir()})


if __name__ == "__main__":
    rospy.init_node("shape_rules_test")
    rostest.rosrun("collision_monitor", "shape_rules", ShapeRules, sys.argv)
