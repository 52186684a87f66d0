# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Motion between poses. Thin plates cross at 5 m/s between two cycles at 50 Hz, each compared with
a subdivision of its cycle into 10,000 steps. A whole trajectory of 7 joints and 100 way-points is
checked beside FCL."""
import argparse
import statistics
import subprocess

from figure import Figures, shared_data, stay_on_one_core

PROGRAM = ("rosrun", "collision_monitor", "collision_monitor_motion_bench")
RUNS = 3


def numbers(*arguments):
    command = [*PROGRAM, *map(str, arguments)]
    output = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return {name: float(value) for name, value in map(str.split, output.splitlines())}


def crossings(figures, arguments):
    """Measures only steps of the subdivision that an earlier step does not settle, because nothing
    moves faster than its greatest speed. Some crossings are measured at every step, to check
    this."""
    found = numbers("crossings", arguments.crossings, arguments.passes, arguments.looked_through)

    def add(name, ours, reference, goal, is_met):
        figures.add(name, f"{found[ours]:.0f}", f"{found[reference]:.0f}", goal, is_met)

    add("crossings at 5 m/s, 50 Hz: caught", "crossing_told", "crossing_count", "all",
        found["crossing_told"] == found["crossing_count"])
    add("  shown by 10,000 steps, and not told in time", "crossing_missed", "crossing_shown",
        "0, to 1e-6 s", found["crossing_missed"] == 0)
    figures.add("  distance at the time told, at most", f"{found['crossing_farthest_m']:.1e} m",
                f"{found['crossing_looks']:.1f} looks", "1e-6 m", found["crossing_unfounded"] == 0)
    add("passes of a small plate: contacts told", "passing_told", "passing_shown",
        "none missed, to 1e-6 s", found["passing_missed"] == 0)
    figures.add("  distance at the time told, at most", f"{found['passing_farthest_m']:.1e} m",
                f"{found['passing_count']:.0f} passes", "1e-6 m", found["passing_unfounded"] == 0)
    add("subdivisions as looking at every step shows", "agreeing", "looked_through", "all",
        found["agreeing"] == found["looked_through"])


def trajectory(figures, robot, part):
    """FCL at samples finds contacts deeper than half of the motion between two samples. As many
    samples as our guarantee of 1e-6 m needs are taken between every PARTth way-point and the next;
    the time of all is that times their number. With distances FCL can skip what is far, by our
    bounds of the motion. FCL offers no such use; it is shown as a reference."""
    runs = [numbers("trajectory", robot, part) for _ in range(RUNS)]
    first = runs[0]

    def median(name):
        return statistics.median(run[name] for run in runs)

    ours, contacts_only = median("ours_ms"), median("ours_contacts_ms")
    figures.add(f"{robot}: {first['joints']:.0f} joints, {first['waypoints']:.0f} way-points",
                f"{ours:.1f} ms", f"{first['pairs']:.0f} pairs", "20 ms with nearest approaches",
                ours <= 20.0 and first["undecided"] == 0)
    fcl = median("fcl_taken_ms") * first["fcl_samples"] / first["fcl_taken"]
    figures.add("  FCL, samples for the same guarantee", f"{fcl / ours:.0f} x", f"{fcl:.0f} ms",
                f"20 x ({first['fcl_taken']:.0f} of {first['fcl_samples']:.0f} samples taken)",
                fcl / ours >= 20.0)
    fcl = median("fcl_distances_ms")
    figures.add("  FCL's distances with our bounds; ours contacts only", f"{fcl / contacts_only:.0f} x",
                f"{fcl:.0f} ms", f"faster ({contacts_only:.1f} ms)",
                fcl > contacts_only and first["fcl_contacts"] == first["contacts"])
    fcl = median("fcl_coarse_taken_ms")
    figures.add("  FCL, samples for 1 mm; ours contacts only", f"{fcl / contacts_only:.1f} x",
                f"{fcl:.0f} ms", f"faster ({contacts_only:.1f} ms)", fcl > contacts_only)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--crossings", type=int, default=100000)
    parser.add_argument("--passes", type=int, default=100000, help="that cross a small plate or pass it")
    parser.add_argument("--looked-through", type=int, default=100, help="step by step")
    parser.add_argument("--robot", default="panda_moveit", help="of the shared data")
    parser.add_argument("--part", type=int, default=10, help="of the way-points, for FCL")
    arguments = parser.parse_args()
    shared_data()
    stay_on_one_core()
    figures = Figures()
    crossings(figures, arguments)
    trajectory(figures, arguments.robot, arguments.part)
    figures.finish()


if __name__ == "__main__":
    main()
