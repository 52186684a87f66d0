# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every shared robot at random poses: our distances and verdicts against FCL's on the same
enclosing shapes. The slow exact reference decides where they differ."""
import re

from figure import Figures, compare_with_fcl, first_line, robot_arguments

RESULT = re.compile(r"poses (\d+), verdicts (\d+), wrong (\d+), worst against FCL (\S+) m, "
                    r"worst depth (\S+) m, decided for us (\d+), decided against us (\d+): (\w+)")
GOAL = "within 1e-6 m, no wrong verdict"


def main():
    poses, robots = robot_arguments(__doc__, 1000)
    figures = Figures()
    for robot in robots:
        label, missing = robot[0], robot[4]
        run = compare_with_fcl(robot, ["--poses", str(poses)])
        if missing:
            named = sum(mesh.rsplit("/", 1)[-1] in run.stderr for mesh in missing)
            figures.add(label, f"{named} named", f"{len(missing)} missing", "every missing mesh named",
                        named == len(missing) and run.returncode == 1)
            continue
        if run.returncode == 1 and "nothing to compare" in run.stderr:
            figures.add(label, "no pair", "-", "a robot without pairs that are checked says so", True)
            continue
        result = RESULT.search(run.stdout)
        if not result:
            figures.add(label, "failed", "-", f"loads ({first_line(run)})", False)
            continue
        wrong, against_fcl, depth, for_us, against_us = result.group(3, 4, 5, 6, 7)
        worst = max(float(against_fcl), float(depth))
        figures.add(label, f"{worst:.1e} m", f"FCL off {for_us}x",
                    f"{GOAL} ({wrong} wrong, {against_us} against us)",
                    result.group(8) == "agrees" and worst <= 1e-6)
    figures.finish()


if __name__ == "__main__":
    main()
