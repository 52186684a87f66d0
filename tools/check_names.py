#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Finds types and inline functions that share a qualified name: two such definitions in one program
are undefined behaviour, and the linker says nothing. Prints one line for each and exits 1 if there
is one. What is local to a file, in an anonymous namespace, may share names.
"""
import argparse
import collections
import pathlib
import re
import sys

SKIPPED = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|^[ \t]*#[^\n]*',
                     re.DOTALL | re.MULTILINE)
TYPE = re.compile(r"\b(?:struct|class|enum class|enum|union)\s+(?:alignas\([^)]*\)\s+)?(\w+(?:::\w+)*)[^;=()]*$")
INLINE = re.compile(r"^\s*(?:HWY_INLINE|inline|constexpr)\b(.*\))[^)]*$", re.DOTALL)


def scopes(text):
    """Yields what stands before each brace that opens, with the names of the namespaces around it
    (None for an anonymous one), where nothing but namespaces is around it."""
    names, start = [], 0
    for match in re.finditer(r"[{};]", text):
        before = text[start:match.start()]
        start = match.end()
        if match[0] == "{":
            namespace = re.search(r"\bnamespace\s*([\w:]*)\s*$", before)
            if namespace and all(kind == "namespace" for kind, _ in names):
                names.append(("namespace", namespace[1] or None))
            else:
                if all(kind == "namespace" for kind, _ in names):
                    yield [name for _, name in names], before
                names.append(("other", None))
        elif match[0] == "}" and names:
            names.pop()


def definitions(path):
    text = SKIPPED.sub(" ", path.read_text(encoding="utf-8"))
    for namespaces, before in scopes(text):
        if None in namespaces or "template" in before:
            continue
        where = "::".join(namespaces)
        if match := TYPE.search(before):
            yield f"{where}::{match[1]}"
        elif match := INLINE.search(before):
            yield f"{where}::{' '.join(match[1].split())}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split(":")[0])
    parser.add_argument("root", nargs="?", default=pathlib.Path(__file__).resolve().parent.parent,
                        type=pathlib.Path, help="the package's folder")
    root = parser.parse_args().root.resolve()
    places = collections.defaultdict(set)
    for folder in ("include", "src"):
        for suffix in ("*.h", "*.cpp"):
            for path in (root / folder).rglob(suffix):
                for name in definitions(path):
                    places[name].add(str(path.relative_to(root)))
    if not places:
        sys.exit(f"no names under {root}")
    shared = {name: files for name, files in sorted(places.items()) if len(files) > 1}
    for name, files in shared.items():
        print(f"{name}: {', '.join(sorted(files))}")
    print(f"{len(places)} names, {len(shared)} shared")
    return 1 if shared else 0


if __name__ == "__main__":
    sys.exit(main())
