# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every shared robot at random poses: our distances and verdicts against FCL's on the same
enclosing shapes, decided by the slow exact reference where they differ."""
import argparse
import re
import subprocess

from figure import Figures, package_path, shared_robots

RESULT = re.compile(r"poses (\d+), verdicts (\d+), wrong (\d+), worst against FCL (\S+) m, "
                    r"worst depth (\S+) m, decided for us (\d+), decided against us (\d+): (\w+)")
GOAL = "within 1e-6 m, no wrong verdict"


def compare(folder, urdf, srdf, poses):
    command = ["rosrun", "collision_monitor", "compare_with_fcl", str(urdf), "--poses", str(poses)]
    if srdf:
        command += ["--srdf", str(srdf)]
    return subprocess.run(command, env=package_path(folder), capture_output=True, text=True,
                          check=False)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--poses", type=int, default=1000)
    parser.add_argument("--robot", help="only robots whose name holds this")
    arguments = parser.parse_args()
    figures = Figures()
    for label, folder, urdf, srdf, missing in shared_robots():
        if arguments.robot and arguments.robot not in label:
            continue
        run = compare(folder, urdf, srdf, arguments.poses)
        if missing:
            named = sum(mesh.rsplit("/", 1)[-1] in run.stderr for mesh in missing)
            figures.add(label, f"{named} named", f"{len(missing)} missing", "every missing mesh named",
                        named == len(missing) and run.returncode == 2)
            continue
        result = RESULT.search(run.stdout)
        if not result:
            first = (run.stderr or run.stdout).strip().splitlines() or ["no output"]
            figures.add(label, "failed", "-", f"loads ({first[0]})", False)
            continue
        wrong, against_fcl, depth, for_us, against_us = result.group(3, 4, 5, 6, 7)
        worst = max(float(against_fcl), float(depth))
        figures.add(label, f"{worst:.1e} m", f"FCL off {for_us}x",
                    f"{GOAL} ({wrong} wrong, {against_us} against us)",
                    result.group(8) == "agrees" and worst <= 1e-6)
    figures.finish()


if __name__ == "__main__":
    main()
