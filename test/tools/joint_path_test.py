# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Joint paths: what lies between the way-points, and what is said about a bad file.

Run with: python3 -m unittest discover -s test/tools -p '*_test.py'
"""
import math
import os
import pathlib
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import joint_path  # noqa: E402


def make_path(points, interpolation="cubic"):
    """A path of one joint through (time, position)."""
    lines = [f"joints: [a]\ninterpolation: {interpolation}\nway_points:"]
    lines += [f"  - {{time: {time}, positions: [{position}]}}" for time, position in points]
    return joint_path.parse_path("\n".join(lines), "p.yaml")


def position_at(path, time):
    return joint_path.sample(path, time)[0][0]


class Interpolation(unittest.TestCase):
    def test_way_points_are_met_exactly(self):
        points = [(0.0, 0.1), (1.0, 0.7), (1.5, -0.4), (4.0, 2.0)]
        for interpolation in ("cubic", "cosine"):
            path = make_path(points, interpolation)
            for time, position in points:
                self.assertAlmostEqual(position_at(path, time), position, delta=1e-15)

    def test_two_points_of_a_cubic_give_the_smoothstep(self):
        path = make_path([(0.0, 0.0), (2.0, 1.0)])
        self.assertAlmostEqual(position_at(path, 0.5), 3 / 16 - 2 / 64)  # u = 1/4: 3 u^2 - 2 u^3
        self.assertAlmostEqual(position_at(path, 1.0), 0.5)

    def test_cosine_at_a_quarter(self):
        path = make_path([(0.0, 1.0), (4.0, 3.0)], "cosine")
        self.assertAlmostEqual(position_at(path, 1.0), 1 + 2 * (1 - math.sqrt(0.5)) / 2)

    def test_cubic_passes_on_a_straight_line_without_stopping(self):
        path = make_path([(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0)])
        values, rates = joint_path.sample(path, 1.5)
        self.assertAlmostEqual(values[0], 1.5)
        self.assertAlmostEqual(rates[0], 1.0)

    def test_cubic_stays_between_neighbours(self):
        points = [(0.0, 0.0), (1.0, 0.01), (1.2, 5.0), (2.0, 5.1), (3.0, -2.0)]
        path = make_path(points)
        for (start, low), (end, high) in zip(points, points[1:]):
            for k in range(101):
                value = position_at(path, start + (end - start) * k / 100)
                self.assertGreaterEqual(value, min(low, high) - 1e-12)
                self.assertLessEqual(value, max(low, high) + 1e-12)

    def test_rates_are_the_derivative(self):
        for interpolation in ("cubic", "cosine"):
            path = make_path([(0.0, 0.0), (1.0, 0.5), (1.7, 2.0), (3.0, 1.0)], interpolation)
            for time in (0.3, 0.8, 1.2, 1.69, 2.5):
                step = 1e-6
                slope = (position_at(path, time + step) - position_at(path, time - step)) / (2 * step)
                self.assertAlmostEqual(joint_path.sample(path, time)[1][0], slope, delta=1e-6)

    def test_outside_the_times_the_ends_are_held(self):
        path = make_path([(1.0, 0.2), (2.0, 0.8)])
        self.assertEqual(joint_path.sample(path, -5.0), ([0.2], [0.0]))
        self.assertAlmostEqual(position_at(path, 99.0), 0.8)

    def test_one_way_point_is_a_pose(self):
        self.assertEqual(joint_path.sample(make_path([(0.0, 0.3)]), 1.0), ([0.3], [0.0]))

    def test_quarter_turn_about_z(self):
        expected = (0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5))
        for found, wanted in zip(joint_path.quaternion_from_rpy(0, 0, math.pi / 2), expected):
            self.assertAlmostEqual(found, wanted)

    def test_rpy_turns_about_x_first(self):
        # Rz(90 deg) Rx(90 deg) takes z to -y and then to x: quaternion (0.5, 0.5, 0.5, 0.5).
        for found in joint_path.quaternion_from_rpy(math.pi / 2, 0, math.pi / 2):
            self.assertAlmostEqual(found, 0.5)


class BadFiles(unittest.TestCase):
    def problems_of(self, text):
        with self.assertRaises(joint_path.PathError) as caught:
            joint_path.parse_path(text, "p.yaml")
        return caught.exception.problems

    def test_each_problem_names_way_point_value_and_what_is_accepted(self):
        cases = {
            "joints: [a]\nway_points: [{time: 0, positions: [1, 2]}]":
                "p.yaml, way-point 1, positions: found 2 values; accepted: one number for each joint",
            "joints: [a]\nway_points: [{time: 0, positions: [up]}]":
                "p.yaml, way-point 1, positions, value 1: found 'up'; accepted: a finite number",
            "joints: [a]\nway_points: [{time: 0, positions: [.nan]}]":
                "p.yaml, way-point 1, positions, value 1: found nan; accepted: a finite number",
            "joints: [a]\nway_points: [{time: -1, positions: [0]}]":
                "p.yaml, way-point 1, time: found -1; accepted: seconds, 0 or more",
            "joints: [a]\nway_points: [{time: 1, positions: [0]}, {time: 1, positions: [0]}]":
                "p.yaml, way-point 2, time: found 1; accepted: more than 1, the time before",
            "joints: [a, a]\nway_points: [{time: 0, positions: [0, 0]}]":
                "p.yaml, joints: found 'a' twice; accepted: each name once",
            "joints: [a]\ninterpolation: linear\nway_points: [{time: 0, positions: [0]}]":
                "p.yaml, interpolation: found 'linear'; accepted: cubic, cosine",
            "joints: [a]\nway_points: []":
                "p.yaml, way_points: found []; accepted: a list of one or more",
            "joints: [a]\nway_points: [{time: 0, positons: [0], positions: [0]}]":
                "p.yaml, way-point 1: found key 'positons'; accepted: time, positions, frames",
            "joints: [a]\nfloating: {b: w}\nway_points: [{time: 0, positions: [0]}]":
                "p.yaml, way-point 1, frames: found []; accepted: one entry for each of ['b']",
            "joints: [a]\nfloating: {b: w}\nway_points: [{time: 0, positions: [0], frames: {b: [0, 0]}}]":
                "p.yaml, way-point 1, frames, b: found 2 values; accepted: x, y, z [m], roll, pitch, yaw [rad]",
            "[1, 2]": "p.yaml: found list; accepted: joints and way_points",
        }
        for text, expected in cases.items():
            with self.subTest(text):
                self.assertEqual(self.problems_of(text), [expected])

    def test_what_is_no_regular_file_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            pipe = os.path.join(folder, "pipe.yaml")
            os.mkfifo(pipe)
            for path, kind in ((pipe, "a pipe (FIFO)"), (folder, "a folder"), ("/dev/zero", "a device")):
                with self.assertRaises(joint_path.PathError) as raised:
                    joint_path.read_regular_file(path)
                self.assertEqual(raised.exception.problems, [f"'{path}' is {kind}, not a regular file"])
            file = pathlib.Path(folder, "path.yaml")
            file.write_bytes(b"joints: []")
            self.assertEqual(joint_path.read_regular_file(file), b"joints: []")

    def test_broken_yaml_is_named(self):
        for text in ("joints: [a", b"joints: [\xff]"):
            self.assertTrue(self.problems_of(text)[0].startswith("p.yaml: not YAML: "))

    def test_number_that_no_float_holds_is_refused(self):
        text = "joints: [a]\nway_points: [{time: 0, positions: [-1" + 400 * "0" + "]}]"
        self.assertIn("accepted: a finite number", self.problems_of(text)[0])

    def test_all_problems_come_at_once(self):
        text = ("joints: [a]\ninterpolation: x\nway_points:\n"
                "  - {time: 0, positions: []}\n  - {time: .inf, positions: [true]}")
        self.assertEqual(len(self.problems_of(text)), 4)

    def test_a_loop_must_close(self):
        with self.assertRaises(joint_path.PathError):
            joint_path.check_loop(make_path([(0, 0.0), (1, 1.0)]), "p.yaml")
        with self.assertRaises(joint_path.PathError):
            joint_path.check_loop(make_path([(0, 0.0)]), "p.yaml")
        joint_path.check_loop(make_path([(0, 0.0), (1, 1.0), (2, 0.0)]), "p.yaml")


class PathsOfThisPackage(unittest.TestCase):
    """Every path fits the robot of its name: the robot's joints, within their limits in place and speed."""

    def test_joints_and_limits(self):
        files = sorted((ROOT / "config/paths").glob("*.yaml"))
        self.assertTrue(files)
        for file in files:
            path = joint_path.parse_path(file.read_text(encoding="utf-8"), file.name)
            urdf = (ROOT / f"urdf/{file.stem}.urdf").read_text(encoding="utf-8")
            joint_path.check_robot(path, file.name, urdf, f"{file.stem}.urdf")
            robot = ElementTree.fromstring(urdf)
            limits = {joint.get("name"): joint.find("limit").attrib for joint in robot.findall("joint")
                      if joint.find("limit") is not None and joint.find("mimic") is None}
            for step in range(int(path.duration * 50) + 1):
                for joint, value, rate in zip(path.joints, *joint_path.sample(path, step / 50)):
                    place = f"{file.name}, {joint} at {step / 50} s"
                    self.assertGreaterEqual(value, float(limits[joint]["lower"]) - 1e-9, place)
                    self.assertLessEqual(value, float(limits[joint]["upper"]) + 1e-9, place)
                    self.assertLessEqual(abs(rate), float(limits[joint]["velocity"]), place)

    def test_path_of_another_robot_is_refused_with_each_joint(self):
        robot = """<robot name='r'><joint name='turn' type='continuous'/><joint name='slide' type='prismatic'/>
            <joint name='follow' type='revolute'><mimic joint='turn'/></joint><joint name='bolt' type='fixed'/></robot>"""
        path = joint_path.parse_path("joints: [turn, follow]\nway_points: [{time: 0, positions: [0, 0]}]", "p.yaml")
        with self.assertRaises(joint_path.PathError) as caught:
            joint_path.check_robot(path, "p.yaml", robot, "r.urdf")
        self.assertEqual(caught.exception.problems, [
            "p.yaml, joints: found 'follow', which r.urdf does not move; accepted: turn, slide",
            "p.yaml, joints: 'slide' of r.urdf is missing"])
        with self.assertRaises(joint_path.PathError) as caught:
            joint_path.check_robot(path, "p.yaml", "<robot><link></robot>", "r.urdf")
        self.assertTrue(caught.exception.problems[0].startswith("r.urdf: not XML: "))


if __name__ == "__main__":
    unittest.main()
