# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Collisions and distances of robots, for joint values, without ROS.

    import collision_monitor_core as cm

    robot = cm.load("panda.urdf", srdf="panda.srdf", packages="/opt/robots")
    robot.distances(q, within=0.1)     # signed distances with points, normals and quality
    robot.check(many)                  # a verdict for each row, on all cores
    robot.check_path(way_points)       # proven for all of the way
    cm.distance(cm.Solid.sphere(0.1), None, cm.Solid.box([1, 1, 1]), [0, 0, 2])

Frames: world. Units: metres, radians, seconds. Sign: distance > 0 apart, 0 touching, < 0 minus the
depth of the overlap. docs/library.md shows all of it by example.
"""
from ._core import (Contact, Distances, PairDistance, PairOnPath, PathAnswer, Robot, Solid,
                    SolidDistance, StateAnswers, collide, distance)
from .enums import PathState, Quality, Verdict
from .errors import ArgumentError, Problem, SetupError
from .loading import load, loads
from .records import EnclosingShape, LinkPair, StateAnswer, Variable

__all__ = [
    "ArgumentError", "Contact", "Distances", "EnclosingShape", "LinkPair", "PairDistance",
    "PairOnPath", "PathAnswer", "PathState", "Problem", "Quality", "Robot", "SetupError", "Solid",
    "SolidDistance", "StateAnswer", "StateAnswers", "Variable", "Verdict", "collide", "distance",
    "load", "loads"]
