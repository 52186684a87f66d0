# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bad input gets one exception with all faults, which names what is accepted."""
import pickle
import re

import numpy as np
import pytest

import collision_monitor_core as cm

from conftest import URDF


@pytest.mark.parametrize("q", [
    [0.0] * 6, [0.0] * 8, np.zeros((1, 7)), 0.0, None, "abc", ["0"] * 7, [None] * 7, object(),
    np.zeros(7, complex), iter([0.0] * 7), [[0.0], [0.0, 0.0]], {0.0, 1.0}])
def test_state_ofWrongForm_isRefused(arm, q):
    for call in (arm.state, arm.verdict, arm.distances, arm.nearest, arm.contacts, arm.link_poses):
        with pytest.raises(cm.ArgumentError, match="(?s)`q`.*7 numbers") as caught:
            call(q)
        assert len(caught.value.faults) == 1


def test_state_byNames_allFaultsAtOnce(arm):
    name = arm.variables[0].name
    with pytest.raises(cm.ArgumentError) as caught:
        arm.verdict({"no_joint": 0.0, name + "x": 1.0, name: "far", 3: 0.0})
    text = str(caught.value)
    assert len(caught.value.faults) == 4
    assert all(word in text for word in (
        "no_joint", name + "x", f"'{name}' is of type 'str'", "the name of a joint"))


@pytest.mark.parametrize("states", [np.zeros(7), np.zeros((2, 6)), np.zeros((1, 2, 7)), None, []])
def test_manyStates_ofWrongShape_areRefused(arm, states):
    with pytest.raises(cm.ArgumentError, match="rows of 7 numbers"):
        arm.check(states)
    with pytest.raises(cm.ArgumentError, match="rows of 7 numbers"):
        arm.check_path(states)


def test_path_faultsOfTimesAndSizes(arm):
    way = np.zeros((3, 7))
    for times in ([0.0, 1.0], [0.0, 1.0, 1.0], [0.0, np.nan, 2.0]):
        with pytest.raises(cm.ArgumentError, match="times"):
            arm.check_path(way, times=times)
    with pytest.raises(cm.ArgumentError, match="velocities"):
        arm.check_path(way, velocities=np.zeros((2, 7)))


def test_requests_outOfRange(arm):
    with pytest.raises(cm.ArgumentError, match="within"):
        arm.distances(arm.default_state, within=np.nan)
    with pytest.raises(cm.ArgumentError, match="'nearest', 'contact'"):
        arm.check([arm.default_state], "far")


@pytest.mark.parametrize("argument, value, sentence", [
    ("threads", -1, "`threads` is -1; accepted: a whole number from 0"),
    ("threads", 1.5, "`threads` is 1.5;"), ("threads", np.zeros(3), "type 'numpy.ndarray'"),
    ("budget", -1, "`budget` is -1; accepted: a whole number"), ("budget", 2**64, "is 1844674"),
    ("margin", None, "`margin` is None; accepted: a number"), ("resolution", "1", "is '1';"),
    ("tolerance", [1], "type 'list'"), ("within", "far", "`within` is 'far'; accepted: a number")])
def test_numbersOfWrongKind_areToldInALine(arm, argument, value, sentence):
    call = {"threads": arm.check, "within": arm.distances}.get(argument, arm.check_path)
    states = arm.default_state if argument == "within" else np.zeros((2, 7))
    with pytest.raises(cm.ArgumentError, match=re.escape(sentence)) as caught:
        call(states, **{argument: value})
    assert len(str(caught.value).splitlines()) == 1
    if argument == "within":
        with pytest.raises(cm.ArgumentError, match=re.escape(sentence)):
            cm.distance(cm.Solid.sphere(1), None, cm.Solid.sphere(1), None, within=value)


def test_rowsOfDifferentLengths_nameTheRow(arm):
    rows = [[0.0] * 7, [0.0], [0.0] * 2]
    with pytest.raises(cm.ArgumentError, match=re.escape("`states[1]` has 1 number; accepted")):
        arm.check(rows)
    with pytest.raises(cm.ArgumentError, match=re.escape("`velocities[1]` has 1 number;")):
        arm.check_path(np.zeros((3, 7)), velocities=rows)


def test_countsOfOne_areSingular(arm):
    assert repr(arm.check([arm.default_state])).startswith("StateAnswers of 1 state:")


def test_robotWithManyFaults_tellsAllOfThem(tmp_path):
    urdf = tmp_path / "faulty.urdf"
    links = "".join(f'<link name="l{i}"><collision><geometry><sphere radius="-{i}"/></geometry>'
                    "</collision></link>" for i in range(1, 10))
    urdf.write_text(f'<robot name="r">{links}<link name="m"><collision><geometry>'
                    '<mesh filename="no.stl"/></geometry></collision></link></robot>')
    with pytest.raises(cm.SetupError) as caught:
        cm.load(urdf, tmp_path / "no.srdf", fit_cache="none")
    problems = caught.value.problems
    assert any("no.srdf" in problem.found for problem in problems)
    with pytest.raises(cm.SetupError) as caught:
        cm.load(urdf, fit_cache="none")
    problems = caught.value.problems
    assert len(problems) >= 10 and all(problem.where for problem in problems)
    assert any("no.stl" in str(problem) for problem in problems)
    assert str(caught.value).count("\n") >= len(problems) - 1
    copy = pickle.loads(pickle.dumps(caught.value))
    assert copy.problems == problems and str(copy) == str(caught.value)


def test_arguments_ofLoad_allFaultsAtOnce():
    with pytest.raises(cm.ArgumentError) as caught:
        cm.load(3, prefix=7, packages=[None], rules=4, ignore_pairs=["ab", "c"],
                padding="thick", max_shapes=-1, detail=None, speed=1, ignore_default_overlap=1)
    text = str(caught.value)
    assert len(caught.value.faults) >= 9
    assert all(re.search(name, text) for name in (
        "urdf", "prefix", "packages", "rules", "ignore_pairs", "padding", "max_shapes", "detail",
        "speed", "ignore_default_overlap"))


def test_files_thatCannotBeRead_areToldWithTheFaultsOfTheRobot(tmp_path):
    with pytest.raises(cm.SetupError) as caught:
        cm.load(tmp_path / "no.urdf", rules="/no/rules.yaml", pair_rules=tmp_path,
                world=tmp_path / "no.yaml", fit_cache="none")
    text = str(caught.value)
    assert len(caught.value.problems) == 4
    assert all(name in text for name in ("no.urdf", "shape_rules", "pair_rules", "no.yaml"))


def test_options_ofLoad_areCheckedByTheLibrary():
    with pytest.raises(cm.SetupError, match="padding"):
        cm.load(URDF / "arm6.urdf", padding=-1.0, fit_cache="none")
    with pytest.raises(cm.ArgumentError, match="'mesh', 'hull', 'none'"):
        cm.load(URDF / "arm6.urdf", detail="exact", fit_cache="none")


def test_instancesWithNothingInThem_cannotBeMade():
    made = [kind for kind in vars(cm).values() if isinstance(kind, type)
            and type(kind).__name__ == "pybind11_type"]
    assert cm.Robot in made and len(made) > 5
    for kind in made:
        with pytest.raises(TypeError):
            kind.__new__(kind)
        with pytest.raises(TypeError):
            kind()


def test_exceptions_arePickledWithTheirLists():
    copy = pickle.loads(pickle.dumps(cm.ArgumentError(["one", "two"])))
    assert copy.faults == ["one", "two"] and str(copy) == "one\ntwo"
