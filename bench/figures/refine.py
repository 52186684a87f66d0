# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every shared robot at random poses: contacts by the geometries themselves against FCL's, and the
share of false alarms among the contacts of enclosing shapes, without and with refinement."""
import argparse
import re
import subprocess

from figure import Figures, package_path, shared_robots

RESULT = re.compile(r"wrong (\d+) \((\d+) missed\), contacts (\d+); of (\d+) contacts of enclosing "
                    r"shapes (\S+) % false, refined (\S+) %; left by the budget (\S+) a pose")


def compare(folder, urdf, srdf, poses):
    command = ["rosrun", "collision_monitor", "compare_with_fcl", str(urdf), "--exact",
               "--poses", str(poses)]
    if srdf:
        command += ["--srdf", str(srdf)]
    return subprocess.run(command, env=package_path(folder), capture_output=True, text=True,
                          check=False)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--poses", type=int, default=10000)
    parser.add_argument("--robot", help="only robots whose name holds this")
    arguments = parser.parse_args()
    figures = Figures()
    for label, folder, urdf, srdf, missing in shared_robots():
        if missing or (arguments.robot and arguments.robot not in label):
            continue
        run = compare(folder, urdf, srdf, arguments.poses)
        result = RESULT.search(run.stdout)
        if not result:
            first = (run.stderr or run.stdout).strip().splitlines() or ["no output"]
            figures.add(label, "failed", "-", f"loads ({first[0]})", False)
            continue
        wrong, missed, contacts, _, of_shapes, refined, left = result.groups()
        figures.add(f"{label}: wrong verdicts", wrong, f"{contacts} contacts",
                    f"0 ({missed} missed)", wrong == "0")
        figures.add(f"{label}: false alarms", f"{refined} %", f"{of_shapes} % shapes",
                    f"fewer than the shapes' or none ({left} pairs left a pose)",
                    float(refined) < float(of_shapes) or float(of_shapes) == 0.0)
    figures.finish()


if __name__ == "__main__":
    main()
