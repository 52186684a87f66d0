# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every shared robot at random poses: contacts of the geometries against FCL's, and the share of
false alarms among the contacts of enclosing shapes, without and with refinement."""
import re

from figure import Figures, compare_with_fcl, first_line, robot_arguments

RESULT = re.compile(r"poses (\d+), verdicts (\d+), wrong (\d+) \((\d+) missed\), contacts (\d+); "
                    r"of (\d+) contacts of enclosing shapes (\S+) % false, refined (\S+) %; "
                    r"left by the budget (\S+) a pose, without one wrong (\d+)")


def main():
    poses, robots = robot_arguments(__doc__, 10000)
    figures = Figures()
    total = wrong_total = 0
    for robot in robots:
        label, missing = robot[0], robot[4]
        if missing:
            continue
        run = compare_with_fcl(robot, ["--exact", "--poses", str(poses)])
        if run.returncode == 1 and "nothing to compare" in run.stderr:
            continue  # the `robots` group names it
        result = RESULT.search(run.stdout)
        if not result:
            figures.add(label, "failed", "-", f"loads ({first_line(run)})", False)
            continue
        _, verdicts, wrong, missed, contacts, _, of_shapes, refined, left, complete = result.groups()
        total += int(verdicts)
        wrong_total += int(wrong)
        figures.add(f"{label}: wrong verdicts", wrong, f"{contacts} contacts",
                    f"0 ({missed} missed)", wrong == "0")
        figures.add(f"{label}: false alarms", f"{refined} %", f"{of_shapes} % shapes",
                    f"fewer than the shapes' or none ({left} pairs left a pose)",
                    float(refined) < float(of_shapes) or float(of_shapes) == 0.0)
        figures.add(f"{label}: wrong without a budget", complete, f"{contacts} contacts", "0",
                    complete == "0")
    figures.add("all: wrong verdicts", wrong_total, f"{total} verdicts", "0", wrong_total == 0)
    figures.finish()


if __name__ == "__main__":
    main()
