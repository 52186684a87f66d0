# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""python3 -m collision_monitor_core"""
import subprocess
import sys

import pytest

from conftest import URDF

ARM = [str(URDF / "arm6.urdf"), "--srdf", str(URDF / "arm6.srdf")]


def run(*arguments):
    return subprocess.run([sys.executable, "-m", "collision_monitor_core", *arguments],
                          capture_output=True, text=True, check=False)


def test_table_nearestFirst(arm):
    done = run(*ARM, "--joints", "elbow_joint=1.5", "shoulder_lift_joint=-0.5", "--count", "3")
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert lines[0] == repr(arm) and lines[1].split()[:2] == ["link", "A"]
    rows = lines[2:5]
    metres = [float(line.split()[2]) for line in rows]
    found = arm.distances({"elbow_joint": 1.5, "shoulder_lift_joint": -0.5}).sorted()
    assert metres == [round(pair.distance, 4) for pair in found[:3]] == sorted(metres)
    assert [tuple(line.split()[:2]) for line in rows] == [pair.links for pair in found[:3]]
    assert f"and {len(arm.pairs) - 3} more" in lines[5] and lines[6].startswith("verdict: ")


def test_within_tellsHowManyAreFarther(arm):
    done = run(*ARM, "--within", "0.1")
    assert done.returncode == 0 and "farther apart than 0.1 m" in done.stdout


@pytest.mark.parametrize("arguments, words", [
    (["no_such.urdf"], "no_such.urdf"),
    ([*ARM, "--joints", "elbow_join=1"], "elbow_joint"),
    ([*ARM, "--joints", "elbow_joint=1", "elbow_joint=2"], "twice")])
def test_faultsOfInput_endWithOne(arguments, words):
    done = run(*arguments)
    assert done.returncode == 1 and done.stderr.startswith("error: ") and words in done.stderr
    assert "Traceback" not in done.stderr and not done.stdout


@pytest.mark.parametrize("arguments", [
    [], [*ARM, "--joints", "elbow_joint"], [*ARM, "--joints", "a=b"], [*ARM, "--count", "0"],
    [*ARM, "--within", "nan"], [*ARM, "--nonsense"]])
def test_faultsOfTheCommandLine_endWithTwo(arguments):
    done = run(*arguments)
    assert done.returncode == 2 and "error: " in done.stderr and "Traceback" not in done.stderr


def test_missingNumber_isUnknown():
    done = run(*ARM, "--joints", "elbow_joint=nan", "--count", "1")
    assert done.returncode == 0 and "unknown" in done.stdout.splitlines()[2]
