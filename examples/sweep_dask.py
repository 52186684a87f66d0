# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks random states, or CSV recordings (a line of joint names, then one of numbers a state), by
dask: sweep_dask.py ROBOT.urdf SRDF|- SCHEDULER|WORKERS STATES|CSV..."""
import functools
import sys
import numpy as np
from dask.distributed import Client, progress
import collision_monitor_core as cm

load = functools.lru_cache(cm.load)  # each worker reads the robot once

def check(robot_files, part, size=10_000):
    robot = load(*robot_files)
    if isinstance(part, int):  # the number of a block of random states
        low, high = np.maximum(robot.lower, -np.pi), np.minimum(robot.upper, np.pi)
        states = np.random.default_rng(part).uniform(low, high, (size, len(low)))
    else:
        table = np.atleast_1d(np.genfromtxt(part, delimiter=",", names=True, deletechars=""))
        rows = [dict(zip(table.dtype.names, row)) for row in table.tolist()]
        states = np.stack([robot.state(row) for row in rows])
    return np.bincount(robot.check(states, threads=1).verdict, minlength=4)

if __name__ == "__main__":
    urdf, srdf, cluster, *what = sys.argv[1:]
    parts = range(int(what[0]) // 10_000) if what[0].isdecimal() else what
    local = {"n_workers": int(cluster), "threads_per_worker": 1} if cluster.isdecimal() else {}
    with Client(None if local else cluster, **local) as client:
        answers = client.map(functools.partial(check, (urdf, None if srdf == "-" else srdf)), parts)
        progress(answers, notebook=False)
        counts = zip(sum(client.gather(answers)), cm.Verdict)
        print("\n" + ", ".join(f"{count} {verdict.name}" for count, verdict in counts))
