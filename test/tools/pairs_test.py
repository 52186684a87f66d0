#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program `pairs` as its users run it: what it prints and writes, and what it says about bad input.

COLLISION_MONITOR_PAIRS and COLLISION_MONITOR_FIT name the programs; ctest sets them.
"""
import os
import pathlib
import re
import stat
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("COLLISION_MONITOR_PAIRS")
FIT = os.environ.get("COLLISION_MONITOR_FIT")
BALL = "<collision><geometry><sphere radius='0.1'/></geometry></collision>"
TWO_BALLS = ("<robot name='r'><link name='a'>" + BALL + "</link><link name='b'>" + BALL + "</link>"
             "<joint name='j' type='fixed'><parent link='a'/><child link='b'/><origin xyz='1 0 0'/></joint></robot>")


def run(*arguments, text=None, program=PROGRAM):
    environment = dict(os.environ, ROS_MASTER_URI="http://127.0.0.1:1")  # nobody there
    return subprocess.run([program, *map(str, arguments)], input=text, capture_output=True, text=True,
                          timeout=300, check=False, env=environment)


def pairs(robot, *arguments):
    """Ends its proofs by their number of cells, long before the time limit."""
    return run(ROOT / f"urdf/{robot}.urdf", "--package-root", ROOT, "--no-cache", "--states", 300, "--cells", 2000,
               *arguments)


def rows_of(output):
    """By pair of links: how they touch, and why. Columns are two or more spaces apart."""
    cells = [re.split(r"  +", line) for line in output.splitlines()[1:] if "  " in line]
    return {(row[0], row[1]): (row[2], row[3]) for row in cells}


def disabled_in(path):
    root = ElementTree.parse(path).getroot()
    return {(line.get("link1"), line.get("link2")): line.get("reason") for line in root.iter("disable_collisions")}


@unittest.skipUnless(PROGRAM, "COLLISION_MONITOR_PAIRS names no program")
class RobotsOfThisPackage(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.srdf = pathlib.Path(folder.name) / "robot.srdf"

    def test_table_and_srdf_say_the_same(self):
        for robot in ("arm6", "dual_arm", "humanoid"):
            with self.subTest(robot):
                result = pairs(robot, "--write-srdf", self.srdf, "--force")
                self.assertEqual(result.returncode, 0, result.stderr)
                rows = rows_of(result.stdout)
                root = ElementTree.parse(ROOT / f"urdf/{robot}.urdf").getroot()
                links = sum(1 for link in root.findall("link") if link.find("collision") is not None)
                self.assertEqual(len(rows), links * (links - 1) // 2)
                expected = {pair for pair, (touch, why) in rows.items()
                            if touch == "adjacent" or (touch in ("always", "never") and "proven" in why)}
                self.assertEqual(set(disabled_in(self.srdf)), expected)
                self.assertEqual(run(ROOT / f"urdf/{robot}.urdf", "--package-root", ROOT, "--srdf", self.srdf,
                                     "--no-cache", "--max-shapes", 1, program=FIT).returncode, 0)

    def test_samples_are_written_only_if_they_are_trusted(self):
        careful = pairs("humanoid", "--write-srdf", self.srdf)
        proven = disabled_in(self.srdf)
        left_out = int(re.search(r"left out (\d+) pairs", careful.stdout).group(1))
        self.assertGreater(left_out, 0)
        trusting = pairs("humanoid", "--write-srdf", self.srdf, "--trust-samples")
        self.assertNotIn("left out", trusting.stdout)
        self.assertIn(f"{left_out} pairs added, 0 taken out, {len(proven)} kept", trusting.stdout)
        self.assertEqual(len(disabled_in(self.srdf)), len(proven) + left_out)

    def test_same_seed_same_answer(self):
        first = pairs("arm6")
        self.assertEqual(first.stdout, pairs("arm6").stdout)
        self.assertNotEqual(first.stdout, pairs("arm6", "--seed", 2).stdout)

    def test_from_standard_input(self):
        result = run("-", "--no-cache", text=TWO_BALLS)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(rows_of(result.stdout), {("a", "b"): ("never", "proven: fixed apart")})

    def test_robot_without_pairs(self):
        for geometry in (BALL, ""):
            with self.subTest(geometry):
                text = "<robot name='r'><link name='a'>" + geometry + "</link></robot>"
                result = run("-", "--no-cache", "--states", 20, "--write-srdf", self.srdf, "--force", text=text)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual(rows_of(result.stdout), {})
                self.assertEqual(disabled_in(self.srdf), {})

    def two_turns(self, kind):
        """Links a and b about one point, with a link and two joints of this kind between them."""
        return ("<robot name='r'><link name='a'>" + BALL + "</link><link name='between'>" + BALL + "</link>"
                "<link name='b'>" + BALL + "</link>"
                f"<joint name='j' type='{kind}'><parent link='a'/><child link='between'/></joint>"
                f"<joint name='k' type='{kind}'><parent link='between'/><child link='b'/></joint></robot>")

    def test_always_is_written_only_if_it_is_proven_or_samples_are_trusted(self):
        proven = run("-", "--no-cache", "--states", 20, "--write-srdf", self.srdf, text=self.two_turns("continuous"))
        self.assertEqual(rows_of(proven.stdout)[("a", "b")], ("always", "proven"))
        self.assertEqual(disabled_in(self.srdf)[("a", "b")], "Always")
        always = self.two_turns("planar")  # no proof covers it; each slides up to 1 m
        always = always.replace("radius='0.1'", "radius='9'")
        result = run("-", "--no-cache", "--states", 20, "--write-srdf", self.srdf, "--force", text=always)
        self.assertEqual(rows_of(result.stdout)[("a", "b")], ("always", "touch in all 20 states"))
        self.assertNotIn(("a", "b"), disabled_in(self.srdf))
        run("-", "--no-cache", "--states", 20, "--write-srdf", self.srdf, "--trust-samples", text=always)
        self.assertEqual(disabled_in(self.srdf)[("a", "b")], "Always")

    def test_check_finds_what_an_srdf_should_not_disable(self):
        urdf = ("<robot name='r'><link name='a'>" + BALL + "</link><link name='m'/><link name='b'>" + BALL + "</link>"
                "<link name='far'>" + BALL + "</link><joint name='f' type='fixed'><parent link='m'/><child link='far'/>"
                "<origin xyz='9 0 0'/></joint>"
                "<joint name='j' type='prismatic'><parent link='m'/><child link='a'/><axis xyz='1 0 0'/>"
                "<limit lower='0' upper='1' velocity='1' effort='1'/></joint>"
                "<joint name='k' type='fixed'><parent link='m'/><child link='b'/><origin xyz='0.9 0 0'/></joint></robot>")
        urdf = urdf.replace("<link name='m'/>", "<link name='m'>" + BALL.replace("0.1", "0.01") + "</link>")
        line = "<disable_collisions link1='{}' link2='{}' reason='Never'/>\n"
        self.srdf.write_text("<robot name='r'>\n" + line.format("a", "b") + "</robot>", encoding="utf-8")
        wrong = run("-", "--no-cache", "--states", 50, "--check", self.srdf, text=urdf)
        self.assertEqual(wrong.returncode, 1, wrong.stderr)
        self.assertRegex(wrong.stdout, r"1 pairs are disabled although they touch:\n  'a' - 'b' "
                                       r"\(line 2, Never\) touch at j=0\.[0-9.]+\n")
        self.assertIn("  'far' - 'a' never touch\n", wrong.stdout)
        self.srdf.write_text("<robot name='r'>\n" + line.format("a", "far") + "</robot>", encoding="utf-8")
        right = run("-", "--no-cache", "--states", 50, "--check", self.srdf, text=urdf)
        self.assertEqual(right.returncode, 0, right.stdout)
        self.assertIn("the SRDF disables no pair that touches", right.stdout)

    def test_several_robots_and_yaml(self):
        folder = self.srdf.parent
        (folder / "arm.urdf").write_text(TWO_BALLS, encoding="utf-8")
        yaml = folder / "pairs.yaml"
        arguments = (folder / "arm.urdf", "--no-cache", "--prefix", "left", "--with", f"right={folder / 'arm.urdf'}",
                     "--write-yaml", yaml)
        at_one_place = run(*arguments)
        self.assertEqual(at_one_place.returncode, 0, at_one_place.stderr)
        self.assertEqual(rows_of(at_one_place.stdout)[("left/a", "right/a")],
                         ("always", "proven: fixed to each other"))
        apart = run(*arguments, "--place", "right=0,0,3", "--force")
        self.assertEqual(apart.returncode, 0, apart.stderr)
        self.assertEqual(rows_of(apart.stdout)[("left/a", "right/a")], ("never", "proven: fixed apart"))
        self.assertIn('  - ["left/a", "right/b"]  # Never\n', yaml.read_text(encoding="utf-8"))
        self.assertEqual(run(*arguments).returncode, 1)  # it is there, and --force is not given

    def test_time_limit_ends_proofs(self):
        self.assertIn("(0 proven)", run("-", "--no-cache", "--time-limit", 0, "--states", 20,
                                        text=self.two_turns("continuous")).stdout)

    def test_an_srdf_that_is_there_changes_in_its_pairs_alone(self):
        for robot in ("arm6", "dual_arm", "humanoid"):
            with self.subTest(robot):
                former = (ROOT / f"urdf/{robot}.srdf").read_bytes().replace(b"\n", b"\r\n")
                self.srdf.write_bytes(former)
                self.srdf.chmod(0o640)
                result = pairs(robot, "--write-srdf", self.srdf)
                self.assertEqual(result.returncode, 0, result.stderr)
                pair = re.compile(rb"[ \t]*<disable_collisions [^>]*/>\r\n")
                text = self.srdf.read_bytes()
                self.assertEqual(pair.sub(b"", text), pair.sub(b"", former))
                self.assertEqual(stat.S_IMODE(self.srdf.stat().st_mode), 0o640)
                self.assertGreater(text.count(b"<disable_collisions"), 0)
                again = pairs(robot, "--write-srdf", self.srdf)
                self.assertIn("nothing to change", again.stdout)
                self.assertEqual(self.srdf.read_bytes(), text)

    def test_force_makes_it_anew(self):
        self.srdf.write_text("mine", encoding="utf-8")
        result = run("-", "--no-cache", "--write-srdf", self.srdf, "--force", text=TWO_BALLS)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(disabled_in(self.srdf), {("a", "b"): "Never"})

    def test_says_how_far_it_has_come(self):
        said = pairs("arm6").stderr
        for step in ("fitting base_link (1 of", "drawing 300 states (6 of 10)", "proving 45 pairs for at most 60 s (10 of 10)"):
            self.assertIn(step, said)


@unittest.skipUnless(PROGRAM, "COLLISION_MONITOR_PAIRS names no program")
class BadInput(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def refused(self, *arguments, code=1, text=None):
        """What is said; nothing may be printed as a result or written."""
        before = {path: path.read_bytes() for path in self.folder.iterdir()}
        result = run(*arguments, text=text)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        self.assertEqual({path: path.read_bytes() for path in self.folder.iterdir()}, before)
        self.assertNotIn("because", result.stdout)
        return result.stderr if code == 1 else result.stdout + result.stderr

    def test_every_missing_file_at_once(self):
        said = self.refused("missing.urdf", "--write-srdf", self.folder / "no" / "where.srdf")
        self.assertIn("2 problems", said)
        self.assertIn("missing.urdf'", said)
        self.assertIn("where.srdf'", said)

    def test_bad_robots(self):
        for text in ("", "<robot", TWO_BALLS.replace("'0.1'", "'-1'"), "<robot name='r'/>"):
            with self.subTest(text[:40]):
                said = self.refused("-", "--no-cache", "--write-srdf", self.folder / "out.srdf", text=text)
                self.assertIn("accepted: ", said)

    def test_a_file_that_is_no_srdf_of_the_robot_stays(self):
        there = self.folder / "there"
        for content, expected in (("", "empty SRDF"), ("shapes: []\n", "malformed"), ("<robot name='r'>", "cannot be parsed"),
                                  ("<robot name='s'/>", "robot name 's'"), (TWO_BALLS, "as in a URDF")):
            with self.subTest(content[:40]):
                there.write_text(content, encoding="utf-8")
                said = self.refused("-", "--no-cache", "--write-srdf", there, text=TWO_BALLS)
                self.assertIn(expected, said)
                self.assertIn(str(there), said)
                self.assertNotIn("fitting", said)  # known before the long work

    def test_srdf_which_reads_elsewhere_writes_nothing(self):
        there = self.folder / "there.srdf"
        there.write_text("<robot name='r'><group name='arm'/></robot>", encoding="utf-8")
        said = self.refused("-", "--no-cache", "--srdf", there, text=TWO_BALLS, code=2)
        self.assertIn(f"--write-srdf {there}", said)

    def test_usage(self):
        for arguments in ((), ("a.urdf", "--unknown"), ("a.urdf", "--states", "x"), ("a.urdf", "--trust-samples")):
            self.assertTrue(self.refused(*arguments, code=2))


if __name__ == "__main__":
    unittest.main()
