# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package keeps to its layers, and the check notices when one is broken."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def check(root):
    command = [sys.executable, str(ROOT / "tools" / "check_layers.py"), str(root)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def check_one_file(place, text):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / place
        path.parent.mkdir(parents=True)
        path.write_text(text, encoding="utf-8")
        return check(folder)


class Layers(unittest.TestCase):
    def test_package_keeps_to_its_layers(self):
        result = check(ROOT)
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_include_against_the_arrow_is_named(self):
        result = check_one_file("src/geometry/pose.cpp",
                                '#include "collision_monitor/model/robot_model.h"\n')
        self.assertEqual(result.returncode, 1)
        self.assertIn("src/geometry/pose.cpp: geometry may not include model", result.stdout)

    def test_include_against_the_arrow_between_folders_is_named(self):
        result = check_one_file("src/narrow_phase/gjk/gjk.cpp",
                                '#include "narrow_phase/mesh/mesh_search.h"\n')
        self.assertEqual(result.returncode, 1)
        self.assertIn("src/narrow_phase/gjk/gjk.cpp: gjk may not include mesh", result.stdout)

    def test_folder_without_a_place_is_named(self):
        result = check_one_file("src/narrow_phase/attic/gjk.cpp", "#include <cmath>\n")
        self.assertEqual(result.returncode, 1)
        self.assertIn("no folder 'attic'", result.stdout)

    def test_ros_in_the_core_is_named(self):
        result = check_one_file("include/collision_monitor/pipeline/setup.h", "#include <ros/ros.h>\n")
        self.assertEqual(result.returncode, 1)
        self.assertIn("pipeline may not include ros/ros.h", result.stdout)

    def test_message_header_in_the_core_is_named(self):
        result = check_one_file("src/pipeline/cycle.cpp", "#include <collision_monitor/State.h>\n")
        self.assertEqual(result.returncode, 1)

    def test_header_of_the_library_in_a_room_below_is_named(self):
        result = check_one_file("src/pipeline/cycle.cpp",
                                '#include "collision_monitor/robot_monitor.h"\n')
        self.assertEqual(result.returncode, 1)
        self.assertIn("pipeline may not include library", result.stdout)

    def test_ros_in_a_header_of_the_library_is_named(self):
        result = check_one_file("include/collision_monitor/robot_monitor.h", "#include <ros/ros.h>\n")
        self.assertEqual(result.returncode, 1)
        self.assertIn("library may not include ros/ros.h", result.stdout)

    def test_fcl_in_the_library_is_named(self):
        result = check_one_file("src/narrow_phase/distance.cpp", "#include <fcl/fcl.h>\n")
        self.assertEqual(result.returncode, 1)


if __name__ == "__main__":
    unittest.main()
