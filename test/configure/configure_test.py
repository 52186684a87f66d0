#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package is configured without packages that only tests need: they are named, their tests left out.

COLLISION_MONITOR_CMAKE is the program; ctest sets it.
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
# ROS's CMake files call python3: it must be the one that has their modules.
ENVIRONMENT = dict(os.environ, PATH=os.path.dirname(sys.executable) + ":" + os.environ["PATH"])
OF_TESTS = ("GTest", "rapidcheck", "nlohmann_json", "fcl", "rostest")


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

    def names_of_tests_without(self, hidden):
        """Names of the tests that are left."""
        result = self.configure(hidden)
        self.assertEqual(result.returncode, 0, result.stderr)
        lines = [line for line in result.stdout.splitlines() if "Tests are left out" in line]
        self.assertEqual(len(lines), 1, result.stdout)
        for package in OF_TESTS:
            self.assertEqual(package in lines[0], package in hidden, lines[0])
        if "pybind11" in hidden:
            self.assertIn("The Python module is left out", result.stdout)
        listed = subprocess.run(["ctest", "-N"], cwd=self.folder, capture_output=True, text=True, check=True)
        return re.findall(r"Test +#\d+: (\w+)", listed.stdout)

    def test_without_rapidcheck_all_else_is_there(self):
        left = self.names_of_tests_without(["rapidcheck"])
        self.assertIn("tools", left)
        self.assertIn("ros_edge_verdicts", left)
        self.assertNotIn("unit_model", left)

    def test_without_fcl_the_oracle_is_left_out(self):
        left = self.names_of_tests_without(["fcl"])
        self.assertIn("unit_model", left)
        self.assertNotIn("oracle", left)

    def test_without_any(self):
        self.assertEqual(self.names_of_tests_without((*OF_TESTS, "pybind11")),
                         ["layers", "names", "unreached_functions", "tools", "configure"])

    def test_benchmarks_that_are_asked_for_are_not_left_out(self):
        result = self.configure(["rapidcheck"], "-DCOLLISION_MONITOR_BENCH=ON")
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("COLLISION_MONITOR_BENCH needs", result.stderr)


if __name__ == "__main__":
    unittest.main()
