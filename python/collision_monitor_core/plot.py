# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures for notebooks and papers. Needs matplotlib."""
from typing import Any, Dict, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

from ._core import PairDistance, Robot
from .enums import Quality, Verdict
from .records import EnclosingShape

# Colour-blind people can tell them apart, also by their lightness. The first two: Okabe and Ito.
_COLOURS = {Verdict.clear: "#0072B2", Verdict.warning: "#E69F00",
            Verdict.contact: "#960000"}
Floats = npt.NDArray[np.float64]
_LARGE = 100.0  # [m] half a width: larger shapes, as planes are, do not set the view
_STEPS = 12  # points of a quarter of a turn, rounded up to what looks round


def surface(shape: EnclosingShape) -> Floats:
    """(rows, columns, 3) A grid of points on a shape, in its own frame.

    A ball's grid, moved outward by the half extents of the core: each quarter goes with a corner.
    """
    # The angles at which a quarter ends stand twice: once for each of the two corners there.
    quarter = np.linspace(0.0, np.pi / 2, _STEPS // 2 + 1)
    around = np.concatenate([quarter + i * np.pi / 2 for i in range(4)] + [[2.0 * np.pi]])
    corner_x = np.concatenate([np.full(len(quarter), x) for x in (1, -1, -1, 1)] + [[1]])
    corner_y = np.concatenate([np.full(len(quarter), y) for y in (1, 1, -1, -1)] + [[1]])
    up = np.concatenate([quarter - np.pi / 2, quarter])
    corner_z = np.repeat([-1, 1], len(quarter))
    ball = np.stack([np.outer(np.cos(up), np.cos(around)), np.outer(np.cos(up), np.sin(around)),
                     np.outer(np.sin(up), np.ones_like(around))], axis=-1)
    ones = np.ones_like(up)
    corners = np.stack([np.outer(ones, corner_x), np.outer(ones, corner_y),
                        np.outer(corner_z, np.ones_like(around))], axis=-1)
    grid = shape.radius * ball + shape.half_extents * corners
    return np.concatenate([_cap(grid[:1]), grid, _cap(grid[-1:])])


def _cap(border: Floats) -> Floats:
    """A row of one point in the middle of a border, so that the grid is closed."""
    return np.broadcast_to(border[:, :-1].mean(axis=1, keepdims=True), border.shape)


def _in_world(grid: Floats, world_from_shape: Floats) -> Floats:
    placed: Floats = grid @ world_from_shape[:3, :3].T + world_from_shape[:3, 3]
    return placed


def _placed_shapes(robot: Robot, poses: Floats) -> List[Tuple[EnclosingShape, Floats]]:
    """The shapes of known links, with their poses in the world."""
    pose_of = dict(zip(robot.links, poses))
    return [(shape, pose_of[shape.link] @ shape.link_from_shape) for shape in robot.shapes
            if np.isfinite(pose_of[shape.link]).all()]


def _half_width(shape: EnclosingShape) -> float:
    return float(shape.half_extents.max()) + shape.radius


def _view(placed: List[Tuple[EnclosingShape, Floats]]) -> Tuple[Floats, float]:
    """The middle and half the width of what is shown: all but very large shapes."""
    grids = [_in_world(surface(shape), pose).reshape(-1, 3) for shape, pose in placed
             if _half_width(shape) < _LARGE]
    if not grids:
        return np.zeros(3), 1.0
    points = np.concatenate(grids)
    low, high = points.min(axis=0), points.max(axis=0)
    return (low + high) / 2, max((high - low).max() / 2, 1e-3)


def _draw_shapes(axes: Any, placed: List[Tuple[EnclosingShape, Floats]], middle: Floats,
                 reach: float, pairs: List[PairDistance]) -> None:
    """Draws shapes, and of very large ones the part in view."""
    worst: Dict[str, Verdict] = {}
    for pair in pairs:
        for link in pair.links:
            worst[link] = max(worst.get(link, Verdict.clear), pair.verdict)
    for shape, pose in placed:
        grid = surface(shape)
        if _half_width(shape) >= _LARGE:
            seen = (middle - pose[:3, 3]) @ pose[:3, :3]
            grid = np.clip(grid, seen - reach, seen + reach)
        verdict = worst.get(shape.link, Verdict.clear)
        colour = "lightsteelblue" if verdict == Verdict.clear else _COLOURS[verdict]
        axes.plot_surface(*np.moveaxis(_in_world(grid, pose), -1, 0), color=colour, alpha=0.35,
                          linewidth=0, rstride=1, cstride=1, shade=True)


def _draw_pair(axes: Any, pair: PairDistance) -> None:
    """A line between the nearest points, with the distance in millimetres."""
    ends = np.stack([pair.point_on_a, pair.point_on_b])
    colour = _COLOURS[pair.verdict]
    axes.plot(*ends.T, color=colour, marker="o", markersize=3, linewidth=1.5, zorder=10)
    axes.text(*ends.mean(axis=0), f"{1000 * pair.distance:.0f} mm", color=colour, fontsize=8,
              zorder=11, bbox={"facecolor": "white", "alpha": 0.7, "linewidth": 0, "pad": 1.0})


def _show(axes: Any, middle: Floats, reach: float) -> None:
    """Equal scales, and limits that hold all that is drawn."""
    for set_limits, centre in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim), middle):
        set_limits(centre - reach, centre + reach)
    axes.set_box_aspect((1, 1, 1))
    axes.set_xlabel("x [m]")
    axes.set_ylabel("y [m]")
    axes.set_zlabel("z [m]")


def plot(robot: Robot, q: Any, within: float = 0.2, count: int = 10,
         axes: Optional[Any] = None) -> Any:
    """Draws a robot's enclosing shapes at a state, and lines between the nearest points of pairs.

    within: [m] pairs that are farther apart get no line. count: most lines, the nearest first.
    axes: of matplotlib with projection="3d"; None: of a new figure. Links that are unknown are not
    drawn; the title tells how many pairs are unknown.
    Returns the axes, whose `figure` can be saved.
    """
    try:
        from matplotlib import pyplot
    except ImportError as fault:
        raise ImportError("plot() needs matplotlib (Debian: python3-matplotlib)") from fault
    found = robot.distances(q, within).sorted()
    known = [pair for pair in found if pair.quality != Quality.unknown][:count]
    if axes is None:
        axes = pyplot.figure(figsize=(8, 8)).add_subplot(projection="3d", computed_zorder=False)
    placed = _placed_shapes(robot, robot.link_poses(q))
    middle, reach = _view(placed)
    _draw_shapes(axes, placed, middle, reach, known)
    _show(axes, middle, reach)
    for pair in known:
        _draw_pair(axes, pair)
    unknown = sum(pair.quality == Quality.unknown for pair in found)
    pairs = "pair" if unknown == 1 else "pairs"
    axes.set_title(f"{robot.verdict(q).name}" + (f", {unknown} {pairs} unknown" if unknown else ""))
    return axes
