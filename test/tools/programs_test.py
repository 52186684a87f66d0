# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""What all programs have in common: --help, exit codes, and that nothing compared is no agreement.

COLLISION_MONITOR_FIT, _PAIRS, _MONITOR, _TWO_CAPSULES and _COMPARE name the programs; ctest sets those
that are built.
"""
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
NODES = ("MONITOR", "TWO_CAPSULES")
PROGRAMS = {name: os.environ.get("COLLISION_MONITOR_" + name) for name in ("FIT", "PAIRS", "COMPARE", *NODES)}
ONE_LINK = """<robot name="r"><link name="a"><collision><geometry><sphere radius="0.1"/></geometry></collision>
</link></robot>"""


def run(*command, text=None):
    """Of a robot that is not there, nobody answers: who asked would wait."""
    environment = dict(os.environ, ROS_MASTER_URI="http://127.0.0.1:1")
    return subprocess.run(list(map(str, command)), input=text, capture_output=True, text=True, timeout=120,
                          check=False, env=environment)


@unittest.skipUnless(PROGRAMS["FIT"], "COLLISION_MONITOR_FIT names no program")
class EveryProgram(unittest.TestCase):
    def setUp(self):
        self.programs = {name: path for name, path in PROGRAMS.items() if path}

    def test_help_is_usage_and_0(self):
        for name, program in self.programs.items():
            for word in ("--help", "-h"):
                with self.subTest(name, word=word):
                    result = run(program, word)
                    self.assertEqual(result.returncode, 0, result.stderr)
                    self.assertIn("Usage:", result.stdout)
                    self.assertIn("Exit code", result.stdout)

    def test_what_is_unknown_is_2(self):
        for name, program in self.programs.items():
            for arguments in (("--frobnicate",), ("a", "--frobnicate"), ("__name:=x", "--frobnicate")):
                with self.subTest(name, arguments=arguments):
                    result = run(program, *arguments)
                    self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
                    self.assertRegex(result.stderr, "frobnicate|unknown argument 'a'")

    def test_a_robot_that_is_not_there_is_1(self):
        for name, program in self.programs.items():
            if name not in NODES:
                with self.subTest(name):
                    result = run(program, "missing.urdf")
                    self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
                    self.assertIn("'missing.urdf'", result.stderr)

    @unittest.skipUnless(PROGRAMS["MONITOR"], "COLLISION_MONITOR_MONITOR names no program")
    def test_bad_name_of_a_node_is_2(self):
        for name in NODES:
            with self.subTest(name):
                result = run(self.programs[name], "__name:=bad name")
                self.assertEqual(result.returncode, 2, result.stderr)
                self.assertIn("[bad name]", result.stderr)
                self.assertNotIn("terminate called", result.stderr)

    def test_bad_options_of_scripts_are_2(self):
        for command in (("demo", "--frobnicate"), ("figures", "--frobnicate"), ("test", "--frobnicate"),
                        ("test", "-R", "x", "--frobnicate"), ("test", "-R"), ("test", "unit_model")):
            with self.subTest(command):
                result = run("bash", ROOT / "scripts" / command[0], *command[1:])
                self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
                self.assertNotIn("building", result.stdout)


@unittest.skipUnless(PROGRAMS["COMPARE"], "COLLISION_MONITOR_COMPARE names no program")
class CompareWithFcl(unittest.TestCase):
    def test_nothing_compared_is_no_agreement(self):
        result = run(PROGRAMS["COMPARE"], ROOT / "urdf/two_boxes.urdf", "--poses", 0)
        self.assertEqual(result.returncode, 2)
        self.assertNotIn("agrees", result.stdout)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        urdf = pathlib.Path(folder.name, "one_link.urdf")
        urdf.write_text(ONE_LINK)
        for options in ((), ("--exact",)):
            result = run(PROGRAMS["COMPARE"], urdf, "--poses", 3, *options)
            self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
            self.assertIn("nothing to compare", result.stderr)
            self.assertNotIn("agrees", result.stdout)

    def test_what_is_compared_agrees(self):
        result = run(PROGRAMS["COMPARE"], ROOT / "urdf/two_boxes.urdf", "--poses", 5)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("poses 5,", result.stdout)


if __name__ == "__main__":
    unittest.main()
