# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""No two definitions of the package share a qualified name, and the check notices when two do."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def check(root):
    command = [sys.executable, str(ROOT / "tools" / "check_names.py"), str(root)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def check_files(*texts):
    """Of src/0.cpp, src/1.cpp and so on."""
    with tempfile.TemporaryDirectory() as folder:
        sources = pathlib.Path(folder) / "src"
        sources.mkdir()
        for number, text in enumerate(texts):
            (sources / f"{number}.cpp").write_text(text, encoding="utf-8")
        return check(folder)


def within(namespace, text):
    return f"namespace {namespace} {{\n{text}\n}}  // namespace\n"


class Names(unittest.TestCase):
    def expect_shared(self, name, *texts):
        result = check_files(*texts)
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertIn(f"{name}: src/0.cpp, src/1.cpp\n", result.stdout)

    def expect_none(self, *texts):
        result = check_files(*texts)
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_package_sharesNoNames(self):
        result = check(ROOT)
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_typesOfOneName_areNamedWithTheirFiles(self):
        self.expect_shared("a::Core", within("a", "struct Core { int x; };"), within("a", "class Core {};"))
        self.expect_shared("a::Core", within("a", "enum class Core { x };"),
                           within("a", "struct alignas(64) Core : Base {};"))

    def test_inlineFunctionsOfOneSignature_areNamed(self):
        one = within("a", "inline int twice(int x) { return 2 * x; }")
        self.expect_shared("a::int twice(int x)", one, one)
        self.expect_none(one, within("a", "inline double twice(double x) { return 2 * x; }"))

    def test_otherNamespaces_areOtherNames(self):
        self.expect_none(within("a", "struct Core {};"), within("b", "struct Core {};"))
        self.expect_shared("a::b::Core", within("a::b", "struct Core {};"),
                           within("a", within("b", "struct Core {};")))

    def test_whatIsLocalToAFile_mayShareItsName(self):
        local = within("a", within("", "struct Core {};\ninline void run() {}"))
        self.expect_none(local, local, within("a", "struct Other {};"))

    def test_declarationsMembersAndComments_areNoDefinitions(self):
        whole = within("a", "struct Core { struct Part {}; };")
        self.expect_none(whole, within("a", "struct Core;\nstruct Other { struct Part {}; };"))
        self.expect_none(whole, within("a", '// struct Core {};\n/* struct Core {}; */\nstruct Other {};\n'
                                            'const char* const kText = "struct Core {";'))

    def test_folderWithoutSources_isAFault(self):
        self.assertNotEqual(check_files().returncode, 0)


if __name__ == "__main__":
    unittest.main()
