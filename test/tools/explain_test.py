#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program `explain` as its users run it. COLLISION_MONITOR_EXPLAIN names it; ctest sets that.

urdf/two_boxes.urdf gives the distance by hand: 0.1 m + slide, between two boxes.
"""
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("COLLISION_MONITOR_EXPLAIN")


def explain(*arguments):
    environment = dict(os.environ, ROS_MASTER_URI="http://127.0.0.1:1")  # nobody there
    return subprocess.run([PROGRAM, ROOT / "urdf/two_boxes.urdf", *map(str, arguments), "--no-cache"],
                          capture_output=True, text=True, timeout=300, check=False, env=environment)


@unittest.skipUnless(PROGRAM, "COLLISION_MONITOR_EXPLAIN names no program")
class Explain(unittest.TestCase):
    def file(self, name, text):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = pathlib.Path(folder.name) / name
        path.write_text(text, encoding="utf-8")
        return path

    def test_pair_withoutRules(self):
        result = explain("box_b", "box_a", "--joint", "slide=0.2")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("box_a and box_b are checked: no rule says otherwise", result.stdout)
        self.assertRegex(result.stdout, r"distance  (0\.3|0\.30000\d*|0\.29999\d*) m, exact; between ")
        self.assertRegex(result.stdout, r"warning_distance +0\.05 m\n")
        self.assertIn("verdict   OK: more than warning_distance, 0.05 m", result.stdout)
        self.assertEqual(result.stderr, "")

    def test_verdict_followsLimits(self):
        result = explain("box_b", "box_a", "--limit", "warning_distance=0.15", "--limit", "hysteresis=0.1")
        self.assertIn("verdict   WARNING: at most warning_distance, 0.15 m", result.stdout)
        self.assertRegex(result.stdout, r"hysteresis +0\.1 m\n")
        result = explain("box_b", "box_a", "--joint", "slide=-0.12")
        self.assertIn("verdict   CONTACT: at most contact_distance, 0 m", result.stdout)
        result = explain("box_b", "box_a", "--limit", "warnin_distance=1", "--limit", "hysteresis")
        self.assertEqual(result.returncode, 1)
        self.assertIn("'warnin_distance=1', did you mean 'warning_distance'?", result.stderr)
        self.assertIn("'hysteresis'", result.stderr)

    def test_faultsOfAllInput_areNamedAtOnce(self):
        world = self.file("cell.yaml", "- {name: table, kind: box, size: [1, 1, -1]}\n")
        rules = self.file("rules.yaml", "- {a: box_a, b: box_b, check: maybe}\n")
        result = explain("box_a", "lamp", "--world", world, "--pair-rules", rules, "--limit", "hysteresis=nan",
                         "--joint", "nothing=1")
        self.assertEqual(result.returncode, 1)
        for text in ("check 'maybe'", "'lamp'", "box size along z -1 m", "'hysteresis=nan'; accepted: a number from 0",
                     "nothing=1", "5 problems"):
            self.assertIn(text, result.stderr)

    def test_objectsThatFormNoPair_areExplained(self):
        world = self.file("cell.yaml", "- {name: table, kind: box, size: [1, 1, 0.1]}\n"
                          "- {name: lamp, kind: sphere, radius: 0.1, frame: /map, xyz: [0, 0, 1]}\n"
                          "- {name: part, kind: sphere, radius: 0.1, frame: box_a}\n")
        result = explain("lamp", "table", "--world", world, "--world-frame", "/map")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("object lamp and object table are ignored: two objects that move together", result.stdout)
        self.assertIn("distance  0.85 m, exact; between sphere/sphere and box/box", result.stdout)
        self.assertIn("verdict   none, since they are ignored", result.stdout)
        result = explain("part", "table", "--world", world, "--world-frame", "map")
        self.assertIn("two objects of which neither is attached, and for which no rule asks", result.stdout)

    def test_meshesOfAWorld_areFoundBesideIt(self):
        world = self.file("cell.yaml", "- {name: angle, kind: mesh, file: angle.stl, xyz: [0, 0, 9]}\n")
        (world.parent / "angle.stl").write_bytes((ROOT / "test/data/angle.stl").read_bytes())
        environment = dict(os.environ, ROS_MASTER_URI="http://127.0.0.1:1")
        result = subprocess.run([PROGRAM, ROOT / "urdf/two_boxes.urdf", "box_a", "angle", "--world", "cell.yaml",
                                 "--no-cache"], capture_output=True, text=True, timeout=300, check=False,
                                env=environment, cwd=world.parent)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("OK: more than warning_distance", result.stdout)

    def test_srdfOfAnotherRobot_isWarnedOf(self):
        srdf = self.file("other.srdf", "<robot name='other'><disable_collisions link1='x' link2='y'/></robot>\n")
        result = explain("box_a", "box_b", "--srdf", srdf)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("other.srdf", result.stderr)

    def test_positionBeyondTheLimitsOfItsJoint_isTold(self):
        result = explain("box_b", "box_a", "--joint", "slide=0.6")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("joint 'slide' does not reach 0.6, but -0.2 to 0.5", result.stderr)

    def test_objectsOfAWorld_haveTheirReasonsAndDistances(self):
        world = self.file("cell.yaml", "world:\n"
                          "- {name: table, kind: box, size: [1, 1, 0.1], xyz: [0, 0, -0.2]}\n"
                          "- {name: part, kind: sphere, radius: 0.02, attach: box_b, xyz: [0, 0, 0.5]}\n")
        rules = self.file("rules.yaml", "- {a: table, b: box_a, warning_distance: 0.06}\n")
        result = explain("box_a", "table", "--world", world, "--pair-rules", rules)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        self.assertIn("box_a and object table are checked: no rule says otherwise", result.stdout)
        self.assertRegex(result.stdout, r"distance  0\.0(5|4999\d*|5000\d*) m, exact")
        self.assertIn("verdict   WARNING: at most warning_distance, 0.06 m", result.stdout)
        result = explain("box_b", "part", "--world", world)
        self.assertIn("are ignored: ", result.stdout)
        self.assertIn("verdict   none, since they are ignored", result.stdout)
        result = explain("box_b", "part", "--world", self.file("c.yaml", "- {name: t, kind: box, size: [1, 1, 1], "
                                                               "frame: map}\n"))
        self.assertEqual(result.returncode, 1)
        self.assertIn("frame 'map', which is unknown", result.stderr)

    def test_rule_isNamedWithItsPlace(self):
        rules = self.file("rules.yaml", "pair_rules:\n- {a: box_a, b: '*', check: false, hysteresis: 0.01}\n")
        result = explain("box_a", "box_b", "--pair-rules", rules)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(f"ignored: a rule for pairs ({rules} line 2, rule 1)", result.stdout)
        self.assertRegex(result.stdout, r"hysteresis +0\.01 m  \(.*line 2, rule 1\)")
        self.assertIn("distance  ", result.stdout)

    def test_lineOfAnSrdf_isNamed(self):
        srdf = self.file("robot.srdf", "<robot name='two_boxes'>\n"
                         "<disable_collisions link1='box_b' link2='box_a' reason='Never'/>\n</robot>\n")
        result = explain("box_a", "box_b", "--srdf", srdf)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(f"ignored: a line of the SRDF ({srdf} line 2, Never)", result.stdout)

    def test_faults_areNamed(self):
        result = explain("box_a", "box_c", "--joint", "slide=x", "--joint", "nothing=1")
        self.assertEqual(result.returncode, 1)
        for text in ("box_c", "slide=x", "nothing=1"):
            self.assertIn(text, result.stderr)
        self.assertEqual(explain("box_a").returncode, 2)
        self.assertEqual(explain("box_a", "box_a").returncode, 1)

    def test_rulesThatSelectNothingHere_areNamedAndOthersStillCount(self):
        rules = self.file("rules.yaml", "- {a: box_a, b: box_a, check: false}\n"
                          "- {a: table, b: {group: shelves}, check: false}\n"
                          "- {a: box_a, b: '*', hysteresis: 0.02}\n")
        result = explain("box_a", "box_b", "--pair-rules", rules)
        self.assertEqual(result.returncode, 0, result.stderr)
        for text in ("a rule that selects no pair", "'table'", "'shelves'"):
            self.assertIn(text, result.stderr)
        self.assertRegex(result.stdout, r"hysteresis +0\.02 m  \(.*line 3, rule 3\)")


if __name__ == "__main__":
    unittest.main()
