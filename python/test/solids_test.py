# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two solids with poses."""
import numpy as np
import pytest

import collision_monitor_core as cm

from conftest import PACKAGE

CUBE = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
FACES = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6],
         [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]


@pytest.mark.parametrize("solid, reach", [
    (cm.Solid.sphere(1.0), 1.0), (cm.Solid.capsule(0.25, 1.5), 1.0), (cm.Solid.box([1, 1, 2]), 1.0),
    (cm.Solid.cylinder(0.5, 2.0), 1.0), (cm.Solid.cone(0.5, 2.0), 1.0), (cm.Solid.hull(CUBE), 1.0),
    (cm.Solid.mesh(CUBE, FACES), 1.0)])
def test_distance_alongZ(solid, reach):
    ball = cm.Solid.sphere(0.5)
    found = cm.distance(solid, None, ball, [0.0, 0.0, 3.0])
    assert found.distance == pytest.approx(3.0 - 0.5 - reach, abs=1e-6)
    assert found.point_on_a[2] == pytest.approx(reach, abs=1e-6)
    assert np.allclose(found.normal_a_to_b, [0.0, 0.0, 1.0], atol=1e-6)
    assert not cm.collide(solid, None, ball, [0.0, 0.0, 3.0])
    assert cm.collide(solid, None, ball, [0.0, 0.0, 1.2])
    assert "Solid" in repr(solid) and "m" in repr(found)


def test_distance_posesTurn():
    turned = np.eye(4)
    turned[:3, :3] = [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]
    turned[:3, 3] = [1.0, 0.0, 0.0]
    long_box, ball = cm.Solid.box([0.2, 0.2, 4.0]), cm.Solid.sphere(0.5)
    assert cm.distance(long_box, turned, ball, [4.0, 0.0, 0.0]).distance == pytest.approx(0.5)


def test_meshes_overlapIsNegative():
    cube = cm.Solid.mesh(CUBE, FACES)
    found = cm.distance(cube, None, cube, [1.5, 0.0, 0.0])
    assert found.distance == pytest.approx(-0.5, abs=1e-6)


def test_meshFile_isReadAndScaled():
    file = PACKAGE / "test" / "data" / "angle.stl"
    small, large = cm.Solid.mesh_file(file), cm.Solid.mesh_file(file, scale=2.0)
    ball = cm.Solid.sphere(0.0)
    far = [0.0, 0.0, 1000.0]
    assert (cm.distance(large, None, ball, far).distance
            < cm.distance(small, None, ball, far).distance < 1000.0)
    with pytest.raises(cm.ArgumentError, match="no_such.stl"):
        cm.Solid.mesh_file("no_such.stl")
    with pytest.raises(cm.ArgumentError, match="scale"):
        cm.Solid.mesh_file(file, scale=[1.0, np.nan, 1.0])


@pytest.mark.parametrize("make", [
    lambda: cm.Solid.sphere(-1.0), lambda: cm.Solid.capsule(np.nan, 1.0),
    lambda: cm.Solid.cylinder(np.inf, -1.0), lambda: cm.Solid.box([1.0, 2.0]),
    lambda: cm.Solid.box([1.0, 2.0, -3.0]), lambda: cm.Solid.hull(np.zeros((0, 3))),
    lambda: cm.Solid.hull([[0.0, np.nan, 0.0]]), lambda: cm.Solid.mesh(CUBE, [[0, 1, 8]]),
    lambda: cm.Solid.mesh(CUBE, [[0, 1, -1]]), lambda: cm.Solid.mesh(CUBE, [[0, 1, 1.5]]),
    lambda: cm.Solid.mesh(CUBE, [[0, 1, np.nan]]), lambda: cm.Solid.mesh(CUBE, [[0, 1, 1e300]]),
    lambda: cm.Solid.mesh(np.zeros((0, 3)), np.zeros((0, 3), int)),
    lambda: cm.Solid.mesh("abc", FACES)])
def test_solids_ofBadNumbers_areRefused(make):
    with pytest.raises(cm.ArgumentError):
        make()


def test_poses_notRigid():
    ball = cm.Solid.sphere(1.0)
    stretched = np.diag([2.0, 1.0, 1.0, 1.0])
    for pose in (stretched, [np.nan, 0.0, 0.0]):
        assert cm.distance(ball, pose, ball, None).quality == cm.Quality.unknown
        with pytest.raises(cm.ArgumentError, match="world_from_b"):
            cm.collide(ball, None, ball, pose)
    for pose in (np.zeros((4, 4)), np.zeros((3, 3)), "here", [1.0, 2.0]):
        with pytest.raises(cm.ArgumentError, match="world_from_a"):
            cm.distance(ball, pose, ball, None)
    with pytest.raises(cm.ArgumentError, match="within"):
        cm.distance(ball, None, ball, None, within=0.0)


@pytest.mark.parametrize("ball", [cm.Solid.sphere(2.0), cm.Solid.capsule(2.0, 1.0)])
def test_ballOverAnOpenMesh_touchesIt(ball):
    triangle = cm.Solid.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    for a, b in ((triangle, ball), (ball, triangle)):
        found = cm.distance(a, [0.9, 0.7, 0.4], b, [0.0, 0.0, 0.1])
        assert found.quality == cm.Quality.estimate and found.distance <= 0.0
        assert cm.collide(a, [0.9, 0.7, 0.4], b, [0.0, 0.0, 0.1])
