# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""What no program reaches is named: asked of a few sources that are compiled here."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMPILER = os.environ.get("CXX", "c++")

CORE = """namespace collision_monitor {
namespace { int local(int x) { return 3 * x; } }
int called(int x) { return local(x) + 1; }
int calledByCalled(int x);
int through(int x) { return calledByCalled(x); }
int inTable(int x) { return x - 1; }
extern int (*const kTable[])(int);
int (*const kTable[])(int) = {inTable};
int forgotten(int x) { return x + 7; }
int calledByForgotten(int x) { return x + 8; }
int (*volatile kept)(int);
int forgottenToo(int x) { kept = calledByForgotten; return x; }
struct Face { int asked(int x); int told(int x); };
int Face::asked(int x) { return x + 9; }
int Face::told(int x) { return x + 10; }
}
"""
MORE = "namespace collision_monitor { int calledByCalled(int x) { return x + 2; } }\n"
PROGRAM = """namespace collision_monitor {
int called(int x);
int through(int x);
extern int (*const kTable[])(int);
}
int main(int count, char**) {
  return collision_monitor::called(count) + collision_monitor::through(count) +
         collision_monitor::kTable[0](count);
}
"""


class Build:
    """A folder as CMake leaves it: objects by target, and compile_commands.json."""

    def __init__(self, folder, sources):
        self.folder = pathlib.Path(folder)
        commands = []
        for (target, name), text in sources.items():
            output = pathlib.Path("CMakeFiles") / f"collision_monitor_{target}.dir" / f"{name}.o"
            (self.folder / output).parent.mkdir(parents=True, exist_ok=True)
            source = self.folder / name
            source.write_text(text, encoding="utf-8")
            command = [COMPILER, "-O1", "-ffunction-sections", "-fdata-sections", "-o", str(output), "-c", str(source)]
            subprocess.run(command, cwd=self.folder, check=True)
            commands.append({"directory": folder, "command": " ".join(command), "file": str(source)})
        (self.folder / "compile_commands.json").write_text(json.dumps(commands), encoding="utf-8")

    def check(self, interface):
        file = self.folder / "interface.txt"
        file.write_text(interface, encoding="utf-8")
        command = [sys.executable, str(ROOT / "tools" / "unreached_functions.py"), str(self.folder),
                   "--interface", str(file)]
        return subprocess.run(command, capture_output=True, text=True, check=False)


class UnreachedFunctions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.build = Build(cls.folder.name, {("core", "core.cpp"): CORE, ("core", "more.cpp"): MORE,
                                            ("monitor", "main.cpp"): PROGRAM})

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_whatNoProgramCalls_isNamedWithItsFile(self):
        result = self.build.check("")
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertEqual(result.stdout.splitlines(),
                         ["core.cpp: collision_monitor::Face::asked(int)",
                          "core.cpp: collision_monitor::Face::told(int)",
                          "core.cpp: collision_monitor::calledByForgotten(int)",
                          "core.cpp: collision_monitor::forgotten(int)",
                          "core.cpp: collision_monitor::forgottenToo(int)"])

    def test_interface_isReachedWithWhatItCalls(self):
        result = self.build.check("# the library's\ncollision_monitor::forgotten  why\n"
                                  "collision_monitor::forgottenToo\n"
                                  "collision_monitor::Face::  all of a class\n")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertEqual(result.stdout, "")

    def test_interfaceThatIsNoFunction_isNamed(self):
        result = self.build.check("collision_monitor::forgotten\ncollision_monitor::forgottenToo\n"
                                  "collision_monitor::Face::\ncollision_monitor::Gone::\n"
                                  "collision_monitor::removed\n")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stdout,
                         "interface.txt: collision_monitor::Gone:: is no function of the core\n"
                         "interface.txt: collision_monitor::removed is no function of the core\n")


if __name__ == "__main__":
    unittest.main()
