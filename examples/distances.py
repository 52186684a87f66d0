# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The nearest pairs of links of a robot at joint values."""
import pathlib

import numpy as np

import collision_monitor_core as cm

package = pathlib.Path(__file__).resolve().parent.parent
robot = cm.load(package / "urdf/arm6.urdf", package / "urdf/arm6.srdf", packages=package)
print(robot)

q = np.array([0.3, 1.2, 1.9, 0.0, 0.8, 0.0, 0.02])
found = robot.distances(q, within=0.5, gradients=True)
print(found)
if len(found):
    row = np.argmin(found.distance)
    print("nearest points:", found.point_on_a[row], found.point_on_b[row])
    print("how its distance changes with each joint [m/rad]:", found.gradient[row].round(3))
print("verdict:", robot.verdict({robot.variables[1].name: 0.5}).name, "with one joint at 0.5 rad")
