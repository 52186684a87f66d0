# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""A law: for random states, Python gives the same bytes as a program in C++ that makes the same
calls. The seed is printed on failure."""
import os
import struct
import subprocess

import numpy as np
import pytest

import collision_monitor_core as cm

from conftest import URDF

SEEDS = range(20260101, 20260106)


def bits(numbers):
    return [struct.pack(">d", number).hex() for number in np.ravel(numbers)]


def pair_lines(pair):
    return [str(pair.pair), str(int(pair.quality)), str(int(pair.verdict)),
            str(int(pair.is_refined)), *bits(pair.distance), *bits(pair.point_on_a),
            *bits(pair.point_on_b), *bits(pair.normal_a_to_b)]


def one_state(robot, state):
    every = robot.distances(state, gradients=True)
    for pair in every:
        yield from pair_lines(pair)
    yield from bits(every.gradient)
    for pair in robot.distances(state, within=0.3):
        yield from pair_lines(pair)
    yield from pair_lines(robot.nearest(state))
    for contact in robot.contacts(state):
        yield from pair_lines(contact)
        yield from bits(contact.points)
    yield str(int(robot.verdict(state)))
    yield from bits(robot.link_poses(state)[:, :3, 3])


def many_states(robot, states):
    answers = robot.check(states)
    for row in zip(answers.verdict, answers.quality, answers.pair, answers.distance):
        yield from map(str, row[:3])
        yield from bits(row[3])
    path = robot.check_path(states)
    yield str(int(path.verdict))
    for state, *numbers in zip(path.state, path.time, path.at_least, path.distance):
        yield str(state)
        yield from bits(numbers)


def random_states(robot, seed):
    random = np.random.default_rng(seed)
    states = random.uniform(robot.lower, robot.upper, (20, len(robot.variables)))
    states[random.integers(20), random.integers(states.shape[1])] = np.nan
    return states


@pytest.mark.parametrize("name", ["arm6", "dual_arm"])
@pytest.mark.parametrize("seed", SEEDS)
def test_pythonAndCpp_giveTheSameBytes(name, seed, tmp_path):
    files = URDF / f"{name}.urdf", URDF / f"{name}.srdf"
    robot = cm.load(*files, fit_cache="none")
    states = random_states(robot, seed)
    ours = [line for state in states for line in one_state(robot, state)]
    ours += many_states(robot, states)
    (tmp_path / "states").write_bytes(states.tobytes())
    run = subprocess.run([os.environ["COLLISION_MONITOR_PRINT_ANSWERS"], *files,
                          tmp_path / "states"], capture_output=True, text=True, check=True)
    theirs = run.stdout.split()
    assert len(ours) == len(theirs) > 1000
    differing = [i for i, (a, b) in enumerate(zip(ours, theirs)) if a != b and not is_nan(a, b)]
    assert not differing, f"seed {seed}: {len(differing)} numbers differ, first {differing[0]}"


def is_nan(one, other):
    """NaNs of any sign: their bits do not matter."""
    return all(len(text) == 16 and np.isnan(struct.unpack(">d", bytes.fromhex(text))[0])
               for text in (one, other))
