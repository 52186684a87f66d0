# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks random states, or CSV recordings (a line of joint names, then one of numbers a state), by
dask: sweep_dask.py ROBOT.urdf SRDF|- SCHEDULER|here STATES|CSV..."""
import functools
import sys
import numpy as np
from dask.distributed import Client, progress
import collision_monitor_core as cm


def check(robot_files, part, size=10_000):
    robot = cm.load(*robot_files)  # milliseconds: fits are kept
    if isinstance(part, int):  # the number of a block of random states
        low, high = np.maximum(robot.lower, -np.pi), np.minimum(robot.upper, np.pi)
        states = np.random.default_rng(part).uniform(low, high, (size, len(low)))
    else:
        table = np.atleast_1d(np.genfromtxt(part, delimiter=",", names=True, deletechars=""))
        states = np.stack([robot.state(dict(zip(table.dtype.names, row))) for row in table])
    return np.bincount(robot.check(states, threads=1).verdict, minlength=4)


if __name__ == "__main__":
    urdf, srdf, scheduler, *what = sys.argv[1:]
    parts = range(int(what[0]) // 10_000) if what[0].isdecimal() else what
    job = functools.partial(check, (urdf, None if srdf == "-" else srdf))
    with Client(None if scheduler == "here" else scheduler) as client:
        answers = client.map(job, parts)
        progress(answers, notebook=False)
        print("\n", dict(zip(cm.Verdict.__members__, sum(client.gather(answers)).tolist())), sep="")
