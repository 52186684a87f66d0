# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of robots. Skipped without matplotlib."""
import numpy as np
import pytest

import collision_monitor_core as cm

pyplot = pytest.importorskip("matplotlib.pyplot", reason="python3-matplotlib is not installed")
from collision_monitor_core.plot import surface  # noqa: E402


@pytest.fixture(autouse=True)
def close_figures():
    yield
    pyplot.close("all")


def test_surface_isThatOfTheShape(arm):
    for shape in arm.shapes:
        points = surface(shape).reshape(-1, 3)
        beyond = np.abs(points) - shape.half_extents
        outside = np.linalg.norm(np.maximum(beyond, 0.0), axis=1)
        inside = np.minimum(beyond.max(axis=1), 0.0)
        assert np.allclose(outside + inside, shape.radius, atol=1e-9)
        assert np.allclose(points.max(axis=0), shape.half_extents + shape.radius)


def test_plot_drawsShapesPairsAndDistances(arm, states):
    axes = arm.plot(states[0], within=10.0, count=3)
    found = arm.distances(states[0]).sorted()[:3]
    assert len(axes.collections) == len(arm.shapes) and len(axes.lines) == 3
    assert [text.get_text() for text in axes.texts] == [
        f"{1000 * pair.distance:.0f} mm" for pair in found]
    assert axes.get_title() == arm.verdict(states[0]).name
    assert arm.plot(states[1], axes=axes) is axes


def test_plot_ofMissingNumbersSaysSo(arm):
    q = {arm.variables[-1].name: float("nan")}
    axes = arm.plot(q)
    assert len(axes.collections) < len(arm.shapes) and "pairs unknown" in axes.get_title()


def test_plot_readsStatesAsAllCalls(arm):
    with pytest.raises(cm.ArgumentError):
        arm.plot([0.0])
