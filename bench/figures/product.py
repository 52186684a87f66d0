# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Services and cycles of every robot of the shared data and of urdf/, in the default set-up of a
monitor: check_states beside FCL at the same states, whole cycles, check_trajectory, starts and
memory. Prints one table, the slowest robot first, then the figures.

FCL tests every pair of collision elements, which are placed before; our times include placing the
links. FCL uses `collide` where boxes meet. For the nearest pair it uses `distance`, told the least
distance so far; it skips pairs whose boxes are farther apart, and stops at a contact. The column
`every` is its distance of every pair without such help. Coal, if the benchmarks are built with it, is
asked the same in the same way. Times are processor time of one core; for
starts the smaller one of that and the clock."""
import argparse
import os
import statistics
import subprocess
import sys

from figure import Figures, first_line, shared_data, shared_robots, stay_on_one_core

PROGRAM = ("rosrun", "collision_monitor", "collision_monitor_product_bench")
PARTS = ("start", "states", "cycle", "trajectory")

CONTACT_GOAL, NEAREST_GOAL = 10.0, 20.0  # times as fast as FCL
FEW_PAIRS = 20  # of elements: the goals above apply only to robots with more
CYCLE_GOAL = 100.0  # [us] at 1 kHz, median
CYCLE_GOALS = {"panda_moveit": 8.0, "atlas": 40.0, "ur5_robotiq": 40.0}
MOST_TRIANGLES = 400000  # the goals hold for robots with at most this many
WORST_GOAL = 1100.0  # [us]
COAL_ERROR = 1e-5  # [m] by which distances of Coal may differ from ours, which are exact here
ALARM_GOAL = 1e-4  # share of the cycles
ARM = "panda_moveit"
PATH_GOALS = {"nearest": 2.0, "contacts_only": 0.5}  # [ms] for the arm
TIMES_ARM = {"stretch": 20.0, "tiago_pro": 20.0}  # upper limits, in multiples of the arm's time
START_GOALS = {"without_cache": 1.0, "from_cache": 0.15}  # [s]
STARTED = ("stretch", "tiago_pro")
MEMORY_GOALS = {"stretch": 100.0}  # [MB]

# Of the table: title, width, part, number or a function that computes it, format.
COLUMNS = (
    ("triangles", 9, None, "triangles", ".0f"),
    ("pairs", 6, None, "element_pairs", ".0f"),
    ("1 kHz", 8, "cycle", "cycle_1000Hz_median", ".1f"),
    ("told", 8, "cycle", "cycle_1000Hz_told_median", ".1f"),
    ("99.9 %", 7, "cycle", "cycle_1000Hz_p999", ".0f"),
    ("worst", 7, "cycle", "cycle_1000Hz_worst", ".0f"),
    ("other", 6, "cycle", "cycle_1000Hz_differing", ".0f"),
    ("learn", 8, "cycle", "cycle_1000Hz_learning", ".0f"),
    ("50 Hz", 8, "cycle", "cycle_50Hz_median", ".1f"),
    ("told", 8, "cycle", "cycle_50Hz_told_median", ".1f"),
    ("worst", 7, "cycle", "cycle_50Hz_worst", ".0f"),
    ("other", 6, "cycle", "cycle_50Hz_differing", ".0f"),
    ("contact", 9, "states", "states_contact", ".1f"),
    ("FCL", 8, "states", "states_fcl_collide", ".1f"),
    ("Coal", 8, "states", "states_coal_collide", ".1f"),
    ("nearest", 9, "states", "states_nearest", ".1f"),
    ("FCL", 9, "states", "states_fcl_least", ".1f"),
    ("Coal", 9, "states", "states_coal_least", ".1f"),
    ("every", 9, "states", "states_fcl_every_distance", ".0f"),
    ("Coal", 9, "states", "states_coal_every_distance", ".0f"),
    ("wrong", 6, "states", lambda found: sum(wrong_states(found)), ".0f"),
    ("path", 9, "trajectory", "trajectory_nearest", ".2f"),
    ("alone", 8, "trajectory", "trajectory_contacts_only", ".2f"),
    ("start", 7, "start", lambda found: start_time(found, "without_cache"), ".2f"),
    ("kept", 7, "start", lambda found: start_time(found, "from_cache"), ".3f"),
    ("MB", 6, "start", "memory_grown", ".0f"),
)
LEGEND = """\
1 kHz, 50 Hz: a cycle [us], nobody listens to distances; told: somebody does; other: cycles of which a contact or the level is another without a budget
learn: what is measured before the first cycle [us]
contact, nearest: check_states [us a state], beside FCL and, if built with it, Coal; wrong: states with a wrong verdict
path: check_trajectory [ms], alone: contacts alone; start, kept: without and with kept fits [s]
"""
SLOWNESS = ("cycle_1000Hz_median", "states_contact", "trajectory_nearest", "start_without_cache")


def label_of(name):
    """The robot's label in the program's list: its folder, or its file if the folder is ours."""
    folder, file = name.split("/")
    return file.removesuffix(".urdf") if folder == "urdf" else folder


def robot_names(only):
    listed = subprocess.run([*PROGRAM, "--list"], capture_output=True, text=True, check=True)
    names = {label_of(name): name for name in listed.stdout.split()}
    unknown = set(only) - set(names)
    if unknown:
        sys.exit(f"--only: no robot '{min(unknown)}'; there are: {', '.join(names)}")
    missing = {robot[1].name for robot in shared_robots() if robot[4]}
    for label in missing & set(only or names):
        print(f"({label} is left out: it comes without some of its meshes)")
    return [name for label, name in names.items() if label in (only or names) and
            label not in missing]


def measure(names, parts, arguments, found, failed):
    """Adds numbers of these robots to `found`, by label, and failures to `failed`."""
    options = [word for part in parts for word in ("--part", part)]
    options += ["--cycles", str(arguments.cycles)]
    for name in names if parts else []:
        print(f"measuring {label_of(name)}: {', '.join(parts)}", file=sys.stderr, flush=True)
        runs = {}
        for _ in range(arguments.runs):
            result = subprocess.run([*PROGRAM, name, *options], capture_output=True, text=True,
                                    check=False)
            if result.returncode != 0:
                failed[label_of(name)] = first_line(result)
            for line in result.stdout.splitlines():
                word, number, _ = line.split()
                runs.setdefault(word, []).append(float(number))
        found.setdefault(label_of(name), {}).update(
            {word: statistics.median(numbers) for word, numbers in runs.items()})


def slowness(numbers):
    return next((numbers[name] for name in SLOWNESS if name in numbers), 0.0)


def print_table(found, parts):
    columns = [column for column in COLUMNS if column[2] in (None, *parts) and
               (callable(column[3]) or any(column[3] in numbers for numbers in found.values()))]
    print(f"{'robot':22}" + "".join(f"{title:>{width}}" for title, width, *_ in columns))
    for label, numbers in sorted(found.items(), key=lambda one: -slowness(one[1])):
        texts = (f"{number(numbers) if callable(number) else numbers[number]:>{width}{form}}"
                 for _, width, _, number, form in columns)
        print(f"{label:22}" + "".join(texts))
    print(LEGEND, flush=True)


def wrong_states(numbers):
    """Wrong verdicts where surfaces meet or nothing does, and where one mesh is in another."""
    of_both = [sum(numbers[f"states_{question}_{what}"] for question in ("contact", "nearest"))
               for what in ("missed", "untrue", "missed_inside")]
    return of_both[0] + of_both[1], of_both[2]


def add_states(figures, label, numbers):
    def add(question, peer, words, goal):
        ours, theirs = numbers[f"states_{question}"], numbers[peer]
        figures.add(f"{label}: check_states, {question}", f"{ours:.4g} us",
                    f"{theirs:.4g}, {theirs / ours:.3g}x", f"{goal:g}x FCL's {words}",
                    theirs >= goal * ours)

    if numbers["element_pairs"] > FEW_PAIRS:
        add("contact", "states_fcl_collide", "collide", CONTACT_GOAL)
        add("nearest", "states_fcl_least", "distance", NEAREST_GOAL)
    wrong, missed_inside = wrong_states(numbers)
    figures.add(f"{label}: check_states, wrong verdicts", f"{wrong:.0f}",
                f"{numbers['states_in_contact']:.0f} of {numbers['states']:.0f}",
                f"0 (and {missed_inside:.0f} of what is inside a mesh)", wrong == 0)
    if "states_coal_collide" in numbers:
        add_coal(figures, label, numbers)


def add_coal(figures, label, numbers):
    """Times beside Coal, which have no goal, and whether the benchmarks ask it rightly."""
    for question, peer in (("contact", "collide"), ("nearest", "least")):
        ours, coal = numbers[f"states_{question}"], numbers[f"states_coal_{peer}"]
        figures.tell(f"{label}: {question}, beside Coal", f"{ours:.4g} us",
                     f"{coal:.4g}, {coal / ours:.3g}x")
    other, worst = numbers["states_coal_other_contacts"], numbers["states_coal_worst_distance"]
    figures.add(f"{label}: Coal's answers, other contacts", f"{other:.0f}", f"{1e3 * worst:.2g} mm",
                f"0, distances within {1e3 * COAL_ERROR:g} mm", other == 0 and worst <= COAL_ERROR)


def add_cycle(figures, label, numbers):
    for run, words in (("cycle_1000Hz", ""), ("cycle_1000Hz_told", ", all distances told")):
        add_cycles(figures, label + words, CYCLE_GOALS.get(label, CYCLE_GOAL), numbers, run)


def add_cycles(figures, label, goal, numbers, run):
    median, worst = numbers[f"{run}_median"], numbers[f"{run}_worst"]
    triangles = f"{numbers['triangles']:.0f} tri."
    if numbers["triangles"] <= MOST_TRIANGLES:
        figures.add(f"{label}: cycle at 1 kHz, median", f"{median:.4g} us", triangles,
                    f"< {goal:g} us", median < goal)
    figures.add(f"{label}: cycle at 1 kHz, worst", f"{worst:.4g} us",
                f"{numbers[run]:.0f} cycles", f"< {WORST_GOAL:g} us", worst < WORST_GOAL)
    differing, compared = numbers[f"{run}_differing"], numbers[f"{run}_compared"]
    alarms, missed = numbers[f"{run}_alarms"], numbers[f"{run}_missed"]
    figures.add(f"{label}: cycles other without a budget", f"{differing:.0f}",
                f"{compared:.0f} cycles", f"< {ALARM_GOAL:.0e} of them ({alarms:.0f} false alarms, "
                f"{missed:.0f} misses)", differing < ALARM_GOAL * compared or differing == 0)


def add_trajectories(figures, found):
    words = {"nearest": "nearest approaches", "contacts_only": "contacts alone"}
    arm = found.get(ARM)
    for what, goal in PATH_GOALS.items() if arm else ():
        ours = arm[f"trajectory_{what}"]
        figures.add(f"{ARM}: check_trajectory, {words[what]}", f"{ours:.3g} ms", "-",
                    f"<= {goal:g} ms", ours <= goal)
    for label, most in TIMES_ARM.items():
        for what in PATH_GOALS if arm and label in found else ():
            ours, of_arm = (numbers[f"trajectory_{what}"] for numbers in (found[label], arm))
            figures.add(f"{label}: check_trajectory, {words[what]}", f"{ours:.3g} ms",
                        f"{ours / of_arm:.3g}x {of_arm:.3g} ms", f"<= {most:g}x {ARM}",
                        ours <= most * of_arm)


def start_time(numbers, kind):
    """[s] The smaller time: on an idle machine users wait by the clock, a busy one adds to it."""
    return min(numbers[f"start_{kind}"], numbers[f"start_{kind}_processor"])


def add_start(figures, label, numbers):
    for kind, goal in START_GOALS.items() if label in STARTED else ():
        ours = start_time(numbers, kind)
        figures.add(f"{label}: set-up, {kind.replace('_', ' ')}", f"{ours:.3g} s",
                    f"{numbers['triangles']:.0f} tri.", f"<= {goal:g} s", ours <= goal)
    if label in MEMORY_GOALS:
        ours = numbers["memory_grown"]
        figures.add(f"{label}: memory", f"{ours:.3g} MB", f"{numbers['memory_most']:.3g} at most",
                    f"< {MEMORY_GOALS[label]:g} MB", ours < MEMORY_GOALS[label])


def add_figures(figures, found, parts):
    for part, add in (("states", add_states), ("cycle", add_cycle), ("start", add_start)):
        for label, numbers in found.items() if part in parts else ():
            add(figures, label, numbers)
    if "trajectory" in parts:
        add_trajectories(figures, found)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", nargs="+", default=[], metavar="ROBOT", help="by its folder")
    parser.add_argument("--part", nargs="+", default=PARTS, choices=PARTS)
    parser.add_argument("--cycles", type=int, default=10000, help="at 1 kHz; at 50 Hz a tenth")
    parser.add_argument("--runs", type=int, default=1, help="of each program; medians are printed")
    arguments = parser.parse_args()
    os.environ["COLLISION_MONITOR_SHARED_DATA"] = str(shared_data())
    names = robot_names(arguments.only)
    found, failed = {}, {}
    # A start may use all cores. It needs its own process, free of the memory of other parts.
    measure(names, [part for part in arguments.part if part == "start"], arguments, found, failed)
    stay_on_one_core()
    measure(names, [part for part in arguments.part if part != "start"], arguments, found, failed)
    complete = {label: numbers for label, numbers in found.items() if label not in failed}
    print_table(complete, arguments.part)
    figures = Figures()
    for label, reason in failed.items():
        figures.add(label, "failed", "-", f"is measured ({reason})", False)
    add_figures(figures, complete, arguments.part)
    figures.finish()


if __name__ == "__main__":
    main()
