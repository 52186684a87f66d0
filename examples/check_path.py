# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""A path proven for all of its way, and a hundred thousand states on all cores."""
import pathlib

import numpy as np

import collision_monitor_core as cm

package = pathlib.Path(__file__).resolve().parent.parent
robot = cm.load(package / "urdf/arm6.urdf", package / "urdf/arm6.srdf", packages=package)

path = np.linspace(robot.default_state, 0.8 * robot.upper, 5)
answer = robot.check_path(path, times=[0.0, 1.0, 2.0, 3.0, 4.0])
print(answer)
if answer.first_contact:
    print("touching at", answer.first_contact.time, "s, point", answer.first_contact.point_on_a)

random = np.random.default_rng(1)
states = random.uniform(robot.lower, robot.upper, (100_000, len(robot.variables)))
answers = robot.check(states, "contact")
print(answers)
print("share in contact:", np.mean(answers.verdict == cm.Verdict.contact))
