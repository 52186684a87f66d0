#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package is configured without ROS, and without packages that only some programs and tests need: they
are named, and what needs them is left out.

COLLISION_MONITOR_CMAKE is the program, COLLISION_MONITOR_HAS_ROS 1 or 0; ctest sets them.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CMAKE = os.environ.get("COLLISION_MONITOR_CMAKE", "cmake")
needs_ros = unittest.skipUnless(os.environ.get("COLLISION_MONITOR_HAS_ROS") == "1", "built without ROS")
# ROS's CMake files call python3: it must be the one that has their modules.
ENVIRONMENT = dict(os.environ, PATH=os.path.dirname(sys.executable) + ":" + os.environ["PATH"])
OPTIONAL = ("GTest", "rapidcheck", "nlohmann_json", "fcl", "rostest", "CLI11", "EXPAT", "PNG", "pybind11",
            "Doxygen")
TESTS_OF_ALL = ["layers", "names", "unreached_functions", "tools", "configure", "install",
                "example_distances", "example_check_path", "example_two_shapes"]


class Configure(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def configure(self, hidden, *options):
        return subprocess.run(
            [CMAKE, "-S", ROOT, "-B", self.folder, f"-DPYTHON_EXECUTABLE={sys.executable}", *options,
             *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON" for package in hidden)],
            capture_output=True, text=True, timeout=300, check=False, env=ENVIRONMENT)

    def names_of_tests_without(self, hidden, *options):
        """Names of the tests that are left."""
        result = self.configure(hidden, *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        before, _, left_out = result.stdout.partition("-- Left out, for want of what is in brackets")
        self.assertEqual(bool(left_out), bool(hidden), result.stdout)
        for package in OPTIONAL:
            named = re.search(rf"\(.*\b{package}\b.*\)", left_out) is not None
            self.assertEqual(named, package in hidden, left_out)
        listed = subprocess.run(["ctest", "-N"], cwd=self.folder, capture_output=True, text=True, check=True)
        return re.findall(r"Test +#\d+: (\w+)", listed.stdout)

    @needs_ros
    def test_without_rapidcheck_all_else_is_there(self):
        left = self.names_of_tests_without(["rapidcheck"])
        self.assertIn("tools", left)
        self.assertIn("ros_edge_verdicts", left)
        self.assertNotIn("unit_model", left)

    @needs_ros
    def test_without_fcl_png_or_expat_what_needs_them_is_left_out(self):
        left = self.names_of_tests_without(["fcl", "PNG", "EXPAT"])
        self.assertIn("unit_model", left)
        for name in ("oracle", "unit_fit_tool", "unit_pairs_tool"):
            self.assertNotIn(name, left)

    @needs_ros
    def test_without_any(self):
        # Without CLI11 nobody asks for the others of the programs.
        hidden = set(OPTIONAL) - {"EXPAT", "PNG"}
        self.assertEqual(self.names_of_tests_without(hidden), TESTS_OF_ALL)

    def test_without_ros(self):
        left = self.names_of_tests_without([], "-DCOLLISION_MONITOR_ROS=OFF", "-DCOLLISION_MONITOR_TESTS=ON")
        self.assertIn("unit_pairs_tool", left)
        self.assertIn("oracle", left)
        self.assertFalse([name for name in left if "ros_edge" in name or "two_capsules" in name])

    def test_where_catkin_is_not_found_ros_is_left_out(self):
        result = self.configure(["catkin"])
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("-- Building the core without ROS", result.stdout)
        self.assertIn("--   node, nodelet and messages (catkin)", result.stdout)

    def test_ros_that_is_asked_for_is_not_left_out(self):
        for value, named in (("ON", "catkin"), ("yes", "accepted: ON, OFF, AUTO")):
            result = self.configure(["catkin"], f"-DCOLLISION_MONITOR_ROS={value}")
            self.assertNotEqual(result.returncode, 0)
            self.assertIn(named, result.stderr)

    @needs_ros
    def test_benchmarks_that_are_asked_for_are_not_left_out(self):
        result = self.configure(["rapidcheck"], "-DCOLLISION_MONITOR_BENCH=ON")
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("COLLISION_MONITOR_BENCH needs", result.stderr)


if __name__ == "__main__":
    unittest.main()
