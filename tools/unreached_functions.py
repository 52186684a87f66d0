#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lists functions of the core that no program of the package reaches, because only tests and
benchmarks call them. Reads the object files of a build: each function has its own section, whose
relocations name the functions it calls. Functions in reached_interface.txt, the library's
interface, count as reached; a name that ends in :: stands for all functions of a class. Exits 1 if
a function is not reached.
"""
import argparse
import collections
import json
import pathlib
import re
import subprocess
import sys

PROGRAMS = ("monitor", "nodelet", "fit", "fit_parts", "pairs", "pairs_parts", "two_capsules",
            "two_capsules_parts", "compare_with_fcl", "read_robot", "read_meshes", "fetch_resource")
LIBRARIES = ("core", "mesh_reading", "ros_edge")
INTERFACE = pathlib.Path(__file__).with_name("reached_interface.txt")

# Lines of `readelf --wide`: "  [12] .text.name  PROGBITS ...", a symbol, a relocation.
SECTION = re.compile(r"^\s*\[\s*(\d+)\] (\S+)\s+[A-Z_]+\s+[0-9a-f]+ ([0-9a-f]+) ")
SYMBOL = re.compile(r"^\s*\d+:\s+[0-9a-f]+\s+\S+\s+(\S+)\s+(\S+)\s+\S+\s+(\S+)\s*(\S*)")
RELOCATIONS = re.compile(r"^Relocation section '.* at offset 0x([0-9a-f]+) ")  # cuts names
RELOCATION = re.compile(r"^[0-9a-f]+\s+[0-9a-f]+\s+R_\S+\s+[0-9a-f]+\s+(\S+)")


class Graph:
    """Sections as (object file, section name), and the references between them."""

    def __init__(self):
        self.symbols_of = collections.defaultdict(list)  # names that a section refers to
        self.defined = collections.defaultdict(list)     # sections by name of a global symbol
        self.functions = {}                              # mangled name by section
        self.files = collections.defaultdict(list)       # sections by object file

    def add_file(self, file):
        text = subprocess.run(["readelf", "--wide", "--sections", "--syms", "--relocs", file],
                              capture_output=True, text=True, check=True).stdout
        names, relocated, local = {}, {}, {}
        current, referring = None, []
        for line in text.splitlines():
            if match := SECTION.match(line):
                names[match[1]] = match[2]
                if match[2].startswith(".rela"):
                    relocated[int(match[3], 16)] = match[2].replace(".rela", "", 1)
                self.files[file].append((file, match[2]))
            elif match := RELOCATIONS.match(line):
                current = relocated[int(match[1], 16)]
            elif current and (match := RELOCATION.match(line)):
                referring.append((current, match[1]))
            elif match := SYMBOL.match(line):
                self.add_symbol(file, match, names, local)
        for section, symbol in referring:
            if not section.startswith((".eh_frame", ".debug")):
                known = local.get(symbol) or ((file, symbol) if symbol in names.values() else None)
                self.symbols_of[(file, section)].append(known or symbol)

    def add_symbol(self, file, match, names, local):
        kind, binding, place, name = match.groups()
        if place not in names or not name:
            return
        section = (file, names[place])
        if binding == "LOCAL":
            local[name] = section
        else:
            self.defined[name].append(section)
        # File-local and inline functions belong to their callers; the compiler reports file-local
        # ones without any, and may leave a copy of inline ones behind.
        if kind == "FUNC" and binding == "GLOBAL" and names[place].startswith(".text"):
            self.functions.setdefault(section, name)

    def reached_from(self, roots):
        reached, waiting = set(), list(roots)
        while waiting:
            section = waiting.pop()
            if section in reached:
                continue
            reached.add(section)
            for target in self.symbols_of[section]:
                waiting.extend([target] if isinstance(target, tuple) else self.defined[target])
        return reached


def objects_of(build_dir, target):
    """Of this build: what an earlier one left in the folder is passed over."""
    commands = json.loads((build_dir / "compile_commands.json").read_text())
    outputs = [command.get("output") or re.search(r" -o (\S+)", command["command"])[1]
               for command in commands]
    return sorted({str(build_dir / output) for output in outputs
                   if f"collision_monitor_{target}.dir/" in output and output.endswith(".o")})


def demangled(names):
    text = subprocess.run(["c++filt"], input="\n".join(names), capture_output=True, text=True,
                          check=True).stdout
    return text.splitlines()


def plain(function):
    """@return the name without instruction set, clone suffix and anonymous namespace."""
    function = function.replace("(anonymous namespace)::", "")
    function = re.sub(r"N_[A-Z0-9_]+::", "", function)
    return re.sub(r"(\[abi:\w+\])|( \[clone .*\])", "", function)


def without_parameters(function):
    return function.split("(")[0]


def functions_in(interface):
    lines = interface.read_text().splitlines()
    return {line.split()[0] for line in lines if line.strip() and not line.startswith("#")}


def is_among(function, allowed):
    name = without_parameters(function)
    return name in allowed or name.rpartition("::")[0] + "::" in allowed


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__.split(":")[0])
    parser.add_argument("build_dir", nargs="?", default=pathlib.Path("build"), type=pathlib.Path,
                        help="of a build with compile_commands.json")
    parser.add_argument("--interface", default=INTERFACE, type=pathlib.Path,
                        help="file of functions that are reached, too, one a line")
    return parser.parse_args()


def main():
    arguments = read_arguments()
    build_dir = arguments.build_dir
    graph = Graph()
    for target in PROGRAMS + LIBRARIES:
        for file in objects_of(build_dir, target):
            graph.add_file(file)
    names = dict(zip(graph.functions.values(), demangled(graph.functions.values())))
    allowed = functions_in(arguments.interface)
    roots = [section for file in graph.files for section in graph.files[file]
             if section[1].startswith((".init_array", ".ctors"))]
    for target in PROGRAMS:
        for file in objects_of(build_dir, target):
            roots += graph.files[file]
    interface = {section for section, name in graph.functions.items()
                 if is_among(plain(names[name]), allowed)}
    reached = graph.reached_from(roots + list(interface))
    reached_names = {plain(names[graph.functions[s]]) for s in reached if s in graph.functions}
    unreached = collections.defaultdict(set)
    for section, name in graph.functions.items():
        function = plain(names[name])
        if section not in reached and function.startswith("collision_monitor::") \
                and function not in reached_names:
            unreached[re.sub(r".*\.dir/|\.o$", "", section[0])].add(function)
    for file, functions in sorted(unreached.items()):
        for function in sorted(functions):
            print(f"{file}: {function}")
    functions = {without_parameters(plain(name)) for name in names.values()}
    stale = allowed - functions - {name.rpartition("::")[0] + "::" for name in functions}
    for function in sorted(stale):
        print(f"{arguments.interface.name}: {function} is no function of the core")
    return 1 if unreached or stale else 0


if __name__ == "__main__":
    sys.exit(main())
