# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects and rules for pairs."""
import numpy as np
import pytest

import collision_monitor_core as cm

from conftest import PACKAGE, URDF

BOXES = URDF / "two_boxes.urdf"
POST = "- {name: post, kind: sphere, radius: 0.1, xyz: [0.25, 0.5, 0]}\n"
FLOOR = "- {name: floor, kind: plane, xyz: [0, 0, -1]}\n"


def distance(robot, *links):
    found = robot.distances(robot.default_state)
    return found.distance[found.links.index(links)]


def test_world_fromATextAndFromAFile_isTheSame(tmp_path):
    file = tmp_path / "cell.yaml"
    file.write_text(POST + FLOOR)
    of_text = cm.load(BOXES, world=POST + FLOOR, fit_cache="none")
    of_file = cm.load(BOXES, world=file, fit_cache="none")
    for robot in (of_text, of_file):
        assert distance(robot, "box_b", "post") == pytest.approx(0.35, abs=1e-12)
        assert distance(robot, "box_b", "floor") == pytest.approx(0.95, abs=1e-12)
        assert "3 links with shapes, 2 objects, 2 variables" in repr(robot)


def test_meshes_areFoundBesideARelativeFile(tmp_path, monkeypatch):
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "t.obj").write_text(
        "v 0 0 5\nv 1 0 5\nv 0 1 5\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
    (tmp_path / "sub" / "w.yaml").write_text("- {name: t, kind: mesh, file: t.obj}")
    monkeypatch.chdir(tmp_path)
    assert "t" in cm.load(BOXES, world="sub/w.yaml", fit_cache="none").links
    monkeypatch.chdir(tmp_path / "sub")
    assert "t" in cm.load(BOXES, world="w.yaml", fit_cache="none").links


@pytest.mark.parametrize("text", ["", "[]", "world: []", "- {name: p, kind: plane}",
                                  "# nothing", "[{name: p, kind: plane}]"])
def test_textWithoutLineBreak_isNoFileName(text):
    assert len(cm.load(BOXES, world=text, fit_cache="none").links) >= 4


@pytest.mark.parametrize("name", ["#cell.yaml", "world:", "[]", "- a.yaml"])
def test_fileThatIsThere_isReadWhateverItsName(name, tmp_path, monkeypatch):
    (tmp_path / name).write_text(POST)
    monkeypatch.chdir(tmp_path)
    assert "post" in cm.load(BOXES, world=name, fit_cache="none").links


@pytest.mark.parametrize("wrong", ["/dev/zero", "no.yaml", 5, [{"name": "a"}], "x" * 10**6])
def test_whatIsNoTextAndNoFile_isAShortFault(wrong):
    with pytest.raises((cm.ArgumentError, cm.SetupError), match="or (its text|text in)") as caught:
        cm.load(BOXES, world=wrong, fit_cache="none")
    assert len(str(caught.value)) < 400


def test_withWorld_leavesTheRobotAsItIs():
    robot = cm.load(BOXES, fit_cache="none")
    beside = robot.with_world(POST)
    assert distance(beside, "box_b", "post") == pytest.approx(0.35, abs=1e-12)
    assert len(beside.pairs) == len(robot.pairs) + 3
    assert beside.with_world(None).pairs == robot.pairs


def test_pairRules_nameObjects():
    rules = "- {a: post, b: '*', check: false}\n"
    robot = cm.load(BOXES, world=POST, pair_rules=rules, fit_cache="none")
    assert all("post" not in links for links in robot.pairs)
    assert any("rule" in pair.reason for pair in robot.all_pairs if pair.link_b == "post")


def test_cellOfThePackage_isLoadedWithMeshesAndAttachedPart():
    robot = cm.load(URDF / "arm6.urdf", URDF / "arm6.srdf", fit_cache="none",
                    world=PACKAGE / "config" / "cells" / "table.yaml")
    answers = robot.check(np.random.default_rng(1).uniform(robot.lower, robot.upper, (200, 7)))
    assert 0 < sum(answers.verdict == cm.Verdict.contact) <= 200
    assert {"floor", "table"} <= set(robot.links)


def test_faults_areAllTold(tmp_path):
    with pytest.raises(cm.ArgumentError) as caught:
        cm.load(BOXES, world=2.5, pair_rules=3, fit_cache="none")
    assert len(caught.value.faults) == 2
    with pytest.raises(cm.SetupError, match="no.yaml"):
        cm.load(BOXES, fit_cache="none").with_world(tmp_path / "no.yaml")
    with pytest.raises(cm.ArgumentError, match="world"):
        cm.load(BOXES, fit_cache="none").with_world(3)
    with pytest.raises(cm.SetupError) as failed:
        cm.load(BOXES, world=POST + POST + "- {name: x, kind: sphere}\n", fit_cache="none")
    assert len(failed.value.problems) == 2


def test_plot_ofAPlane_keepsTheViewAtTheRobot():
    pytest.importorskip("matplotlib")
    axes = cm.load(BOXES, world=POST + FLOOR, fit_cache="none").plot([0.0, 0.0])
    low, high = axes.get_xlim()
    assert high - low < 3.0
