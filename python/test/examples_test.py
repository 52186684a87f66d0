# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples run, are short, and dask gives what one process gives."""
import ast
import importlib.util
import subprocess
import sys

import numpy as np
import pytest

import collision_monitor_core as cm

from conftest import PACKAGE, URDF

EXAMPLES = PACKAGE / "examples"
ARM = [str(URDF / "arm6.urdf"), str(URDF / "arm6.srdf")]


def run(name, *arguments):
    return subprocess.run([sys.executable, EXAMPLES / name, *arguments], capture_output=True,
                          text=True, check=True, timeout=300).stdout


def test_examples_haveAtMostThirtyLines():
    files = sorted(EXAMPLES.glob("*.py"))
    assert len(files) >= 4
    assert [file.name for file in files if len(file.read_text().splitlines()) > 30] == []


@pytest.mark.parametrize("name, words", [
    ("distances.py", "nearest points"), ("check_path.py", "share in contact"),
    ("two_shapes.py", "touch: True")])
def test_examples_run(name, words):
    assert words in run(name)


@pytest.fixture(scope="module")
def sweep():
    pytest.importorskip("dask.distributed", reason="python3-distributed is not installed")
    spec = importlib.util.spec_from_file_location("sweep", EXAMPLES / "sweep_dask.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def scheduler(sweep):
    """The address of a cluster of two workers, each a process."""
    from dask.distributed import LocalCluster
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        yield cluster.scheduler_address


def counts(text):
    """The last line of the sweep: {"clear": 12, ...}"""
    return ast.literal_eval(text.strip().splitlines()[-1])


def test_sweep_twoWorkersGiveWhatOneProcessGives(sweep, scheduler):
    wanted = sum(sweep.check(tuple(ARM), block) for block in range(3))
    assert counts(run("sweep_dask.py", *ARM, scheduler, "30000")) == {
        verdict.name: wanted[verdict] for verdict in cm.Verdict}


def test_sweep_ofRecordings(sweep, scheduler, arm, states, tmp_path):
    names = [each.name for each in arm.variables]
    order = np.random.default_rng(1).permutation(len(names))
    files = [tmp_path / "a.csv", tmp_path / "b.csv"]
    for file, rows in zip(files, (states[:120], states[120:])):
        np.savetxt(file, rows[:, order], delimiter=",", comments="", fmt="%.17g",
                   header=",".join(names[i] for i in order))
    wanted = np.bincount(arm.check(states).verdict, minlength=4)
    assert counts(run("sweep_dask.py", *ARM, scheduler, *map(str, files))) == {
        verdict.name: wanted[verdict] for verdict in cm.Verdict}
