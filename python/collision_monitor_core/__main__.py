# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the nearest pairs of links of a robot at joint values.

    python3 -m collision_monitor_core robot.urdf --joints shoulder=0.5 elbow=-1.2

Exit code: 0; 1 if the robot or the joint values cannot be used; 2 for a fault of the command line.
"""
import argparse
import math
import sys
from typing import Dict, List, Optional

from . import ArgumentError, PairDistance, Quality, Robot, SetupError, Verdict, load


def joint_value(text: str) -> "tuple[str, float]":
    """"shoulder=0.5" in two parts."""
    name, equals, number = text.rpartition("=")
    try:
        if not name or not equals:
            raise ValueError
        return name, float(number)
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is not NAME=NUMBER, as in elbow=-1.2") from None


def positive(text: str) -> int:
    """A count."""
    if not text.isdecimal() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"'{text}' is no whole number from 1")
    return int(text)


def length(text: str) -> float:
    """Metres."""
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if math.isnan(number):
        raise argparse.ArgumentTypeError(f"'{text}' is no number of metres")
    return number


def arguments(given: Optional[List[str]]) -> argparse.Namespace:
    """The command line."""
    parser = argparse.ArgumentParser(
        prog="python3 -m collision_monitor_core",
        description="Prints the nearest pairs of links of a robot at joint values.")
    parser.add_argument("urdf", help="the robot's URDF")
    parser.add_argument("--srdf", help="pairs that its disable_collisions names are left out")
    parser.add_argument("--packages", nargs="+", default=[], metavar="FOLDER",
                        help="where package://NAME/ is looked up")
    parser.add_argument("--pair-rules", metavar="FILE", help="YAML, as config/pair_rules.yaml")
    parser.add_argument("--world", metavar="FILE",
                        help="objects: YAML, as config/cells/table.yaml, or a .scene of MoveIt")
    parser.add_argument("--joints", nargs="+", default=[], type=joint_value, metavar="NAME=NUMBER",
                        help="[rad] or [m]; other joints are at 0, or at the limit nearest to it")
    parser.add_argument("--within", type=length, default=math.inf, metavar="METRES",
                        help="leave out pairs that are farther apart")
    parser.add_argument("--count", type=positive, default=10, help="most pairs to print (10)")
    return parser.parse_args(given)


def joint_values(pairs: List["tuple[str, float]"]) -> Dict[str, float]:
    """As a dict; a joint that stands twice is a fault."""
    values = dict(pairs)
    twice = sorted({name for name in values if sum(name == one for one, _ in pairs) > 1})
    if twice:
        raise ArgumentError([f"joint '{name}' stands twice; give it once" for name in twice])
    return values


def row(pair: PairDistance) -> "tuple[str, ...]":
    """What the table says of a pair."""
    if pair.quality == Quality.unknown:
        return (*pair.links, "-", "unknown", "unknown")
    return (*pair.links, f"{pair.distance:.4f}", pair.quality.name, pair.verdict.name)


def print_table(robot: Robot, values: Dict[str, float], within: float, count: int) -> None:
    """The nearest pairs, and the worst verdict of all."""
    found = robot.distances(values, within)
    rows: "List[tuple[str, ...]]" = [("link A", "link B", "metres", "quality", "verdict")]
    rows += [row(pair) for pair in found.sorted()[:count]]
    widths = [max(map(len, column)) for column in zip(*rows)]
    print(robot)
    for cells in rows:
        print("  ".join(cell.rjust(width) if i == 2 else cell.ljust(width)
                        for i, (cell, width) in enumerate(zip(cells, widths))).rstrip())
    if len(found) > count:
        print(f"... and {len(found) - count} more")
    elif len(found) < len(robot.pairs):
        print(f"{len(robot.pairs) - len(found)} pairs are farther apart than {within:g} m")
    print(f"verdict: {Verdict(robot.verdict(values)).name}")


def main(given: Optional[List[str]] = None) -> int:
    """Runs the program."""
    options = arguments(given)
    try:
        robot = load(options.urdf, options.srdf, packages=options.packages,
                     pair_rules=options.pair_rules, world=options.world)
        for warning in robot.warnings:
            print(f"warning: {warning}", file=sys.stderr)
        print_table(robot, joint_values(options.joints), options.within, options.count)
    except (ArgumentError, SetupError) as fault:
        print(f"error: {fault}", file=sys.stderr)
        return 1
    except BrokenPipeError:
        sys.stderr.close()  # the reader of our output has enough
    return 0


if __name__ == "__main__":
    sys.exit(main())
