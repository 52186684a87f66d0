# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program `fit` as its users run it: what it prints and writes, and what it says about bad input.

COLLISION_MONITOR_FIT names the program; ctest sets it.
"""
import os
import pathlib
import re
import stat
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("COLLISION_MONITOR_FIT")
HAS_ROS = bool(os.environ.get("COLLISION_MONITOR_MONITOR"))
ROBOTS = ("arm6", "dual_arm", "humanoid", "three_capsules", "two_boxes")
LITTLE_ROBOT = ('<robot name="r"><link name="a"><collision><geometry><mesh filename="{}"/></geometry>'
                '</collision></link></robot>')


def run(*arguments, text=None):
    environment = dict(os.environ, ROS_MASTER_URI="http://127.0.0.1:1")  # nobody there
    return subprocess.run([PROGRAM, *map(str, arguments)], input=text, capture_output=True, text=True,
                          timeout=300, check=False, env=environment)


def fit(robot, *arguments):
    """One robot of this package, fitted anew."""
    return run(ROOT / f"urdf/{robot}.urdf", "--package-root", ROOT, *arguments)


def rows_of(output):
    """The lines of the table as lists of cells: columns are two or more spaces apart."""
    lines = output.splitlines()
    return [re.split(r"  +", line) for line in lines[2:] if "   " in line]


def links_with_collisions(robot):
    root = ElementTree.parse(ROOT / f"urdf/{robot}.urdf").getroot()
    return [link.get("name") for link in root.findall("link") if link.find("collision") is not None]


@unittest.skipUnless(PROGRAM, "COLLISION_MONITOR_FIT names no program")
class RobotsOfThisPackage(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_table_has_every_link_proven(self):
        for robot in ROBOTS:
            with self.subTest(robot):
                result = fit(robot, "--no-cache")
                self.assertEqual(result.returncode, 0, result.stderr)
                rows = rows_of(result.stdout)
                self.assertEqual(list(dict.fromkeys(row[0] for row in rows)), links_with_collisions(robot))
                self.assertTrue(all("proven" in row[-1] and "NOT" not in row[-1] for row in rows), result.stdout)
                self.assertIn("all proven to enclose", result.stdout)
                self.assertIn("fitting " + links_with_collisions(robot)[0] + " (", result.stderr)

    def test_rules_given_back_are_proven(self):
        rules = self.folder / "rules.yaml"
        for robot in ROBOTS:
            with self.subTest(robot):
                first = fit(robot, "--no-cache", "--max-shapes", 3, "--target-overshoot", 0.002, "--yaml", rules,
                            "--force")
                self.assertEqual(first.returncode, 0, first.stderr)
                written = yaml.safe_load(rules.read_text(encoding="utf-8"))
                self.assertEqual([rule["link"] for rule in written["shapes"]], links_with_collisions(robot))
                second = fit(robot, "--rules", rules)
                self.assertEqual(second.returncode, 0, second.stderr)
                self.assertIn("all proven to enclose", second.stdout)
                self.assertTrue(all("given" in row for row in rows_of(second.stdout)), second.stdout)

    def test_urdf_given_back_is_proven_and_has_its_looks(self):
        new = self.folder / "new.urdf"
        for robot in ROBOTS:
            with self.subTest(robot):
                first = fit(robot, "--no-cache", "--urdf", new, "--force")
                self.assertEqual(first.returncode, 0, first.stderr)
                second = run(new, "--no-cache")
                self.assertEqual(second.returncode, 0, second.stderr)
                self.assertIn("all proven to enclose", second.stdout)
                root = ElementTree.parse(new).getroot()
                for name in links_with_collisions(robot):
                    link = root.find(f"link[@name='{name}']")
                    self.assertEqual(len(link.findall("collision")), len(link.findall("visual")))
                    self.assertIsNone(link.find("collision/geometry/mesh"))

    def test_page_is_well_formed_and_shows_every_link(self):
        page = self.folder / "page.html"
        self.assertEqual(fit("arm6", "--no-cache", "--html", page).returncode, 0)
        root = ElementTree.parse(page).getroot()
        self.assertEqual([section.find("h2").text for section in root.iter("section")],
                         links_with_collisions("arm6"))
        pictures = list(root.iter("img"))
        self.assertEqual(len(pictures), len(links_with_collisions("arm6")))
        self.assertTrue(all(picture.get("src").startswith("data:image/png;base64,iVBOR") for picture in pictures))

    def test_spheres(self):
        spheres, srdf = self.folder / "s.yaml", self.folder / "s.srdf"
        result = fit("arm6", "--no-cache", "--spheres-yaml", spheres, "--spheres-srdf", srdf, "--sphere-level", 1,
                     "--leaves", 8, "--link", "*_finger")
        self.assertEqual(result.returncode, 0, result.stderr)
        written = yaml.safe_load(spheres.read_text(encoding="utf-8"))
        self.assertEqual([link["link"] for link in written["links"]], ["left_finger", "right_finger"])
        self.assertEqual(len(written["links"][0]["levels"][-1]["spheres"]), 8)
        root = ElementTree.parse(srdf).getroot()
        self.assertEqual(root.get("name"), "arm6")
        self.assertEqual([len(link) for link in root.findall("link_sphere_approximation")], [2, 2])

    def test_from_standard_input_with_a_mesh_beside_it(self):
        text = LITTLE_ROBOT.format(ROOT / "urdf/meshes/finger.stl")
        result = run("-", "--no-cache", text=text)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(rows_of(result.stdout)[0][:3], ["a", "collision_0", "12"])
        beside = self.folder / "robot.urdf"
        beside.write_text(LITTLE_ROBOT.format("finger.stl"), encoding="utf-8")
        (self.folder / "finger.stl").write_bytes((ROOT / "urdf/meshes/finger.stl").read_bytes())
        self.assertEqual(run(beside, "--no-cache").returncode, 0)

    def test_kinds_are_obeyed(self):
        result = fit("humanoid", "--no-cache", "--kinds", "box")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(all(re.fullmatch(r"\d+ box", row[3]) for row in rows_of(result.stdout)), result.stdout)

    def test_cache_serves_the_second_run(self):
        cache = self.folder / "cache"
        self.assertIn("fitted", fit("arm6", "--cache", cache, "--link", "left_finger").stdout)
        again = fit("arm6", "--cache", cache, "--link", "left_finger").stdout
        self.assertIn("cached", again)
        self.assertNotIn("fitted", again)


@unittest.skipUnless(PROGRAM, "COLLISION_MONITOR_FIT names no program")
class BadInput(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def refused(self, *arguments, code=1, text=None):
        """What is said; nothing may be printed as a result or written."""
        before = sorted(self.folder.iterdir())
        result = run(*arguments, text=text)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        self.assertEqual(sorted(self.folder.iterdir()), before)
        self.assertNotIn("proven", result.stdout)
        return result.stderr if code == 1 else result.stdout + result.stderr

    def test_every_missing_file_at_once(self):
        said = self.refused("missing.urdf", "--srdf", "missing.srdf", "--rules", "missing.yaml",
                            "--yaml", self.folder / "no" / "where.yaml", "--html", self.folder)
        self.assertIn("5 problems", said)
        for name in ("missing.urdf", "missing.srdf", "missing.yaml", "where.yaml", str(self.folder)):
            self.assertIn(f"{name}'", said)

    def test_bad_robots(self):
        cut = self.folder / "cut.stl"
        cut.write_bytes(b"\0" * 80 + b"\x05\0\0\0" + b"\0" * 50)
        cases = {
            "": "standard input",
            "<robot": "standard input",
            LITTLE_ROBOT.format("missing.stl"): "missing.stl",
            LITTLE_ROBOT.format("package://no_such_package/a.stl"): "no_such_package",
            LITTLE_ROBOT.format(cut): "cut.stl",
            '<robot name="r"><link name="a"><collision><geometry><box size="1 -2 3"/></geometry></collision>'
            "</link></robot>": "'1 -2 3'",
        }
        for text, expected in cases.items():
            with self.subTest(text[:40]):
                said = self.refused("-", "--no-cache", "--yaml", self.folder / "out.yaml", text=text)
                self.assertIn(expected, said)
                self.assertIn("accepted: ", said)

    def test_missing_file_of_a_package_below_a_root_is_named(self):
        (self.folder / "my_package").mkdir()
        said = self.refused("-", "--no-cache", "--package-root", self.folder,
                            text=LITTLE_ROBOT.format("package://my_package/meshes/a.stl"))
        self.assertIn(f"'{self.folder}/my_package/meshes/a.stl' cannot be read: No such file", said)

    def test_bad_rules_name_the_line(self):
        rules = self.folder / "rules.yaml"
        rules.write_text("shapes:\n  - link: base_link\n    max_shapes: 0\n  - link: nobody\n    padding: 1\n",
                         encoding="utf-8")
        said = self.refused(ROOT / "urdf/arm6.urdf", "--package-root", ROOT, "--rules", rules, "--no-cache",
                            "--html", self.folder / "page.html")
        self.assertIn("2 problems", said)
        self.assertIn("line 3", said)
        self.assertIn("nobody", said)

    def test_no_such_link_or_parameter(self):
        said = self.refused(ROOT / "urdf/two_boxes.urdf", "--link", "nobody", "--no-cache")
        self.assertIn("no link fits 'nobody'", said)
        # Without ROS there is no such option.
        said = self.refused("--param", "/robot_description", code=1 if HAS_ROS else 2)
        self.assertIn("/robot_description" if HAS_ROS else "--param", said)

    def test_usage(self):
        for arguments in ((), ("a.urdf", "--unknown"), ("a.urdf", "--max-shapes", "x")):
            self.assertTrue(self.refused(*arguments, code=2))

    def test_a_file_that_is_there_stays_without_force(self):
        for option in ("--yaml", "--urdf", "--html", "--spheres-yaml", "--spheres-srdf"):
            with self.subTest(option):
                kept = self.folder / "kept"
                kept.write_text("mine", encoding="utf-8")
                said = self.refused(ROOT / "urdf/two_boxes.urdf", "--no-cache", option, kept)
                self.assertIn(f"option {option}: '{kept}' cannot be written: it is there already", said)
                self.assertEqual(kept.read_text(encoding="utf-8"), "mine")
                self.assertNotIn("fitting", said)  # known before the long work
                result = run(ROOT / "urdf/two_boxes.urdf", "--no-cache", option, kept, "--force")
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertNotEqual(kept.read_text(encoding="utf-8"), "mine")

    def test_a_file_that_may_not_be_changed_stays(self):
        if os.geteuid() == 0:
            self.skipTest("root may change every file")
        kept = self.folder / "kept.yaml"
        kept.write_text("mine", encoding="utf-8")
        kept.chmod(stat.S_IRUSR)
        self.assertIn("kept.yaml", self.refused(ROOT / "urdf/two_boxes.urdf", "--no-cache", "--force", "--yaml", kept))
        self.assertEqual(kept.read_text(encoding="utf-8"), "mine")


if __name__ == "__main__":
    unittest.main()
