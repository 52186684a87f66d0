# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python module beside the library in C++, on the same states. Times are processor time of one
core. The module is measured in a process of its own."""
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

BENCH = ("rosrun", "collision_monitor", "collision_monitor_library_states_bench")
ROBOT = "panda_moveit"
MANY = 100_000
CHECK_GOAL = 1.3  # times the time of C++
CALL_GOAL = 5.0  # [us] above the time of C++
IMPORT_GOAL = 0.3  # [s]
LOAD_GOAL = 0.05  # [s]
IMPORT = ("import time; start = time.process_time(); import collision_monitor_core; "
          "print(time.process_time() - start)")


def median_time(call, count=5):
    """[s] of one call"""
    times = []
    for _ in range(count):
        start = time.process_time()
        call()
        times.append(time.process_time() - start)
    return statistics.median(times)


def measure(urdf, srdf, fit_cache, move, many):
    """{"figure": time}, in this process"""
    import collision_monitor_core as cm
    import numpy as np

    def load():
        return cm.load(urdf, srdf, fit_cache=fit_cache)
    robot = load()
    moving = list(np.fromfile(move).reshape(-1, len(robot.variables)))
    states = np.fromfile(many).reshape(-1, len(robot.variables))

    def distances():
        for state in moving:
            robot.distances(state)
    return {"load": median_time(load), "distances": 1e6 * median_time(distances) / len(moving),
            "check": 1e6 * median_time(lambda: robot.check(states, threads=1)) / len(states)}


def make_states(robot_files, folder):
    """Writes states of a move between random states, and random states."""
    import collision_monitor_core as cm
    import numpy as np
    robot = cm.load(*robot_files, fit_cache=folder / "fits")
    random = np.random.default_rng(20260101)

    def draw(count):
        return random.uniform(robot.lower, robot.upper, (count, len(robot.variables)))
    ends = draw(21)
    np.concatenate([np.linspace(a, b, 100) for a, b in zip(ends, ends[1:])]).tofile(folder / "move")
    draw(MANY).tofile(folder / "many")


def run(command, environment):
    return subprocess.run(list(map(str, command)), env=environment, capture_output=True, text=True,
                          check=True).stdout


def add_python(figures):
    """Adds figures of the Python module."""
    from figure import package_path, shared_robots
    robot = next(robot for robot in shared_robots() if robot[0] == ROBOT)
    environment = package_path(robot[1])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run([sys.executable, __file__, "states", *robot[2:4], folder], environment)
        files = (*robot[2:4], folder / "fits")
        ours = json.loads(run([sys.executable, __file__, "times", *files, folder / "move",
                               folder / "many"], environment))
        cpp = {call: float(run([*BENCH, call, *files, folder / states], environment))
               for call, states in (("distances", "move"), ("check", "many"))}
    imports = statistics.median(float(run([sys.executable, "-c", IMPORT], environment))
                                for _ in range(5))
    figures.add(f"{ROBOT}: Python, check of {MANY} states", f"{ours['check']:.4g} us",
                f"C++ {cpp['check']:.4g}", f"<= {CHECK_GOAL}x C++",
                ours["check"] <= CHECK_GOAL * cpp["check"])
    figures.add(f"{ROBOT}: Python, one distances(q)", f"{ours['distances']:.4g} us",
                f"C++ {cpp['distances']:.4g}", f"<= C++ + {CALL_GOAL:g} us",
                ours["distances"] <= cpp["distances"] + CALL_GOAL)
    figures.add("Python, import", f"{imports:.3g} s", "-", f"< {IMPORT_GOAL} s",
                imports < IMPORT_GOAL)
    figures.add(f"{ROBOT}: Python, load with kept fits", f"{1000 * ours['load']:.3g} ms", "-",
                f"< {1000 * LOAD_GOAL:g} ms", ours["load"] < LOAD_GOAL)


if __name__ == "__main__":
    if sys.argv[1] == "states":
        make_states(sys.argv[2:4], pathlib.Path(sys.argv[4]))
    else:
        print(json.dumps(measure(*sys.argv[2:])))
