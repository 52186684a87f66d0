# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robots that tests share. They are in this package, so no test needs other data."""
import pathlib

import numpy as np
import pytest

import collision_monitor_core as cm

PACKAGE = pathlib.Path(__file__).resolve().parents[2]
URDF = PACKAGE / "urdf"


@pytest.fixture(scope="session")
def arm():
    return cm.load(URDF / "arm6.urdf", URDF / "arm6.srdf", fit_cache="none")


@pytest.fixture(scope="session")
def states(arm):
    """(200, n) random states."""
    return np.random.default_rng(20260101).uniform(arm.lower, arm.upper, (200, len(arm.lower)))
