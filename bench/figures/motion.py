# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""What happens between poses: thin plates that cross at 5 m/s between two cycles at 50 Hz, and a
trajectory of 7 joints and 100 way-points checked for all of its way beside samples of it checked
with FCL, so dense that these see what is 1 mm deep."""
import argparse
import statistics
import subprocess

from figure import Figures, shared_data

PROGRAM = ("rosrun", "collision_monitor", "collision_monitor_motion_bench")
RUNS = 3


def numbers(*arguments):
    command = ["taskset", "-c", "1", *PROGRAM, *map(str, arguments)]
    output = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return {name: float(value) for name, value in map(str.split, output.splitlines())}


def crossings(figures, count, subdivided):
    found = numbers("crossings", count, subdivided)
    figures.add("crossings at 5 m/s, 50 Hz: caught", f"{found['caught']:.0f}", f"{count}", "all",
                found["caught"] == count)
    figures.add("  distance at the time told", f"{found['farthest_m']:.1e} m",
                f"{found['distances_each']:.1f} looks", "1e-6 m", found["farthest_m"] <= 1e-6)
    figures.add("  later than 10,000 steps show", f"{found['late_s']:.1e} s",
                f"{found['subdivided']:.0f} pairs", "1e-6 s", found["late_s"] <= 1e-6)


def trajectory(figures, robot):
    """FCL sees in samples what is deeper than half of the motion between two of them. For the
    guarantee of ours, 1e-6 m, it needs a thousand times the samples that it needs for 1 mm; their
    time is reckoned from that of these."""
    runs = [numbers("trajectory", robot) for _ in range(RUNS)]
    first = runs[0]

    def median(name):
        return statistics.median(run[name] for run in runs)

    figures.add(f"{robot}: {first['joints']:.0f} joints, {first['waypoints']:.0f} way-points",
                f"{median('ours_ms'):.1f} ms", f"{first['pairs']:.0f} pairs",
                "20 ms with nearest approaches", median("ours_ms") <= 20.0
                and first["undecided"] == 0)
    fcl = median("fcl_ms")
    finer = first["fcl_resolution_m"] / first["tolerance_m"]
    ratio = fcl * finer / median("ours_ms")
    figures.add("  FCL, samples for the same guarantee", f"{ratio:.0f} x", f"{fcl * finer:.0f} ms",
                f"20 x ({first['fcl_samples'] * finer:.0f} samples, extrapolated)", ratio >= 20.0)
    ratio = fcl / median("ours_contacts_ms")
    figures.add("  FCL, samples for 1 mm; ours contacts only", f"{ratio:.1f} x", f"{fcl:.0f} ms",
                f"faster, proven ({median('ours_contacts_ms'):.1f} ms)", ratio > 1.0)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--crossings", type=int, default=100000)
    parser.add_argument("--subdivided", type=int, default=1000, help="crossings held to 10,000 steps")
    parser.add_argument("--robot", default="panda_moveit", help="of the shared data")
    arguments = parser.parse_args()
    shared_data()
    figures = Figures()
    crossings(figures, arguments.crossings, arguments.subdivided)
    trajectory(figures, arguments.robot)
    figures.finish()


if __name__ == "__main__":
    main()
