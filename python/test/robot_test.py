# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Answers of a robot: they agree with each other, and arrays are as their docstrings say."""
import threading
import time

import numpy as np
import pytest

import collision_monitor_core as cm

from conftest import URDF


def test_lists_areAsLongAsTheyClaim(arm):
    n = len(arm.variables)
    assert n == 7 and arm.lower.shape == arm.upper.shape == arm.default_state.shape == (n,)
    assert all(low == each.lower for low, each in zip(arm.lower, arm.variables))
    checked = [(pair.link_a, pair.link_b) for pair in arm.all_pairs if pair.is_checked]
    assert sorted(checked) == sorted(arm.pairs) and len(checked) > 3
    assert {shape.link for shape in arm.shapes} >= {name for pair in arm.pairs for name in pair}
    assert repr(arm) == f"Robot arm6: 10 links with shapes, 7 variables, {len(arm.pairs)} pairs"


def test_distances_columnsAndRowsAgree(arm, states):
    found = arm.distances(states[0], gradients=True)
    k = len(found)
    assert k == len(arm.pairs) and found.distance.shape == (k,)
    assert found.point_on_a.shape == found.normal_a_to_b.shape == (k, 3)
    assert found.gradient.shape == (k, 7) and np.isfinite(found.gradient).all()
    apart = found.point_on_b - found.point_on_a
    assert np.allclose(apart, found.distance[:, None] * found.normal_a_to_b, atol=1e-9)
    for i, row in enumerate(found):
        assert row.distance == found.distance[i] and row.pair == found.pair[i]
        assert row.links == arm.pairs[found.pair[i]] == found.links[i]
        assert row.verdict == found.verdict[i] and isinstance(row.verdict, cm.Verdict)
        assert (row.point_on_a == found.point_on_a[i]).all()
    assert found[-1].pair == found.pair[-1]
    with pytest.raises(IndexError):
        found[k]


def test_distances_viewsOutliveTheirOwnerAndCannotBeWritten(arm, states):
    found = arm.distances(states[0])
    column, copy = found.distance, found.distance.copy()
    del found
    for state in states[1:50]:
        arm.distances(state)
    assert (column == copy).all()
    with pytest.raises(ValueError):
        column[0] = 1.0


def test_distances_withinLeavesOutWhatIsFarther(arm, states):
    every = arm.distances(states[0])
    near = arm.distances(states[0], within=0.3)
    assert 0 < len(near) < len(every)
    assert set(near.pair) == set(every.pair[every.distance <= 0.3])


def test_distances_gradientIsTheDerivative(arm, states):
    state, step = states[1], 1e-6
    found = arm.distances(state, gradients=True)
    for joint in range(7):
        moved = state.copy()
        moved[joint] += step
        change = (arm.distances(moved).distance - found.distance) / step
        assert np.allclose(change, found.gradient[:, joint], atol=1e-3)


def test_calls_agreeWithEachOther(arm, states):
    answers = arm.check(states)
    assert len(set(answers.verdict)) > 1
    touching = arm.check(states, "contact").verdict == cm.Verdict.contact
    assert (touching == (answers.verdict == cm.Verdict.contact)).all()
    for i, state in enumerate(states):
        every = arm.distances(state)
        nearest = arm.nearest(state)
        assert nearest.distance == pytest.approx(every.distance.min(), abs=1e-9)
        assert arm.verdict(state) == answers[i].verdict == every.verdict.max()
        assert bool(arm.contacts(state)) == touching[i]
        if not touching[i] and answers[i].quality == cm.Quality.exact:
            assert answers.distance[i] == pytest.approx(nearest.distance, abs=1e-9)
            assert answers[i].links == nearest.links
        assert touching[i] or answers.distance[i] <= nearest.distance + 1e-9
    assert (answers.quality == cm.Quality.exact)[~touching].sum() > 10


def test_check_sameBytesForAnyNumberOfThreads(arm, states):
    one, many = arm.check(states, threads=1), arm.check(states, threads=4)
    for field in ("verdict", "quality", "pair", "distance"):
        assert getattr(one, field).tobytes() == getattr(many, field).tobytes()
    assert len(arm.check(states[:0])) == 0


def test_state_takesNamesAndAnyFormOfNumbers(arm, states):
    state = states[2]
    names = [each.name for each in arm.variables]
    wanted = arm.distances(state).distance.tobytes()
    wide = np.zeros((7, 2))
    wide[:, 0] = state
    for form in (dict(zip(names, state)), list(state), tuple(state), wide[:, 0],
                 state.astype(">f8"), np.ma.array(state), memoryview(state)):
        assert (arm.state(form) == state).all()
        assert np.allclose(np.frombuffer(wanted), arm.distances(form).distance, atol=1e-9)
    one = arm.state({names[1]: 0.25})
    assert one[1] == 0.25 and (np.delete(one, 1) == np.delete(arm.default_state, 1)).all()


@pytest.mark.parametrize("missing", [np.nan, np.inf, -np.inf, np.ma.masked])
def test_missingNumber_isUnknownAndNeverClear(arm, missing):
    state = np.ma.array(np.zeros(7))
    state[0] = missing
    assert arm.verdict(state) in (cm.Verdict.unknown, cm.Verdict.contact)
    assert arm.check(state.filled(np.nan)[None])[0].verdict != cm.Verdict.clear
    found = arm.distances(state, within=0.0, gradients=True)
    unknown = found.quality == cm.Quality.unknown
    assert unknown.any() and np.isnan(found.distance[unknown]).all()
    assert np.isnan(found.gradient[unknown]).all()
    first = found.sorted()[0]
    assert first.quality == cm.Quality.unknown and first.shape_a is None
    assert "unknown" in repr(first) and "unknown" in repr(found)
    assert any(len(contact.points) == 0 for contact in arm.contacts(state))


def test_checkPath_findsTheFirstContact(arm, states):
    touching = arm.check(states).verdict == cm.Verdict.contact
    start, end = states[~touching][0], states[touching][0]
    answer = arm.check_path([start, end], times=[1.0, 3.0])
    first = answer.first_contact
    assert answer.verdict == cm.Verdict.contact and first.state == cm.PathState.contact
    assert 1.0 < first.time <= 3.0 and answer.time[first.pair] == first.time
    moment = (first.time - 1.0) / 2.0
    assert arm.nearest(start + moment * (end - start)).distance == pytest.approx(0.0, abs=1e-4)
    assert "contact" in repr(answer) and "contact" in repr(first)
    assert len(answer) == len(arm.pairs) == len(list(answer))
    clear = arm.check_path([start, start])
    assert clear.first_contact is None and clear.verdict != cm.Verdict.contact
    assert (clear.at_least <= clear.distance + 1e-6).all()


def test_checkPath_budgetEndsItUndecided(arm, states):
    answer = arm.check_path(states[:5], budget=1)
    assert (answer.state == cm.PathState.undecided).any()


def test_progress_growsAndItsExceptionEndsTheCall(arm, states):
    told = []
    arm.check(np.tile(states, (50, 1)), threads=1, progress=told.append)
    assert told and told == sorted(told) and told[-1] == 1.0

    def refuse(_):
        raise RuntimeError("enough")
    with pytest.raises(RuntimeError, match="enough"):
        arm.check(states, progress=refuse)
    with pytest.raises(RuntimeError, match="enough"):
        arm.check_path(states[:2], progress=refuse)


def test_threads_shareARobot(arm, states):
    wanted = [(arm.verdict(state), arm.nearest(state).distance) for state in states]
    failures = []

    def work(first):
        for i in range(first, len(states), 4):
            verdict, distance = wanted[i]
            if (arm.verdict(states[i]) != verdict
                    or abs(arm.nearest(states[i]).distance - distance) > 1e-9):
                failures.append(i)
    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures


def test_gil_isFreeWhileManyStatesAreChecked(arm, states):
    many = np.tile(states, (200, 1))
    ended, turns = threading.Event(), 0
    thread = threading.Thread(target=lambda: (arm.check(many, threads=1), ended.set()))
    thread.start()
    while not ended.is_set():
        time.sleep(0.001)
        turns += 1
    thread.join()
    assert turns > 3


def test_load_severalRobots():
    pair = cm.load([URDF / "arm6.urdf"] * 2, prefix=["left", "right"],
                   world_from_root=[None, [0.0, 0.9, 0.0]], fit_cache="none")
    assert len(pair.variables) == 14 and "left" in repr(pair) and "right" in repr(pair)
    assert any(a.startswith("left/") and b.startswith("right/") for a, b in pair.pairs)
    roots = pair.link_poses(pair.default_state)[[pair.links.index(name) for name in pair.links
                                                 if name.endswith("/base_link")]]
    assert np.allclose(roots[1][:3, 3] - roots[0][:3, 3], [0.0, 0.9, 0.0])


def test_loads_sameAsLoad(arm, states):
    same = cm.loads((URDF / "arm6.urdf").read_text(), (URDF / "arm6.srdf").read_text(),
                    fit_cache="none")
    assert same.pairs == arm.pairs
    assert same.check(states).distance.tobytes() == arm.check(states).distance.tobytes()


def test_options_changeWhatTheySay(states):
    thick = cm.load(URDF / "arm6.urdf", URDF / "arm6.srdf", padding=0.01, warning_distance=0.2,
                    detail="none", ignore_pairs=[("*", "*")][:0], fit_cache="none")
    plain = cm.load(URDF / "arm6.urdf", URDF / "arm6.srdf", detail="none", fit_cache="none")
    assert thick.warning_distance == 0.2 and plain.warning_distance == 0.05
    assert np.allclose([shape.radius for shape in thick.shapes if shape.kind == "capsule"],
                       [shape.radius + 0.01 for shape in plain.shapes if shape.kind == "capsule"])
