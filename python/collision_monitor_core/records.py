# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rows of a robot's lists."""
from typing import NamedTuple, Optional, Tuple

import numpy as np
import numpy.typing as npt

from .enums import Quality, Verdict


class Variable(NamedTuple):
    """One number of a state: the position of a joint, or a part of it."""
    name: str  #: of the joint; planar and floating joints have an ending: "base/x"
    lower: float  #: [rad] or [m]; -inf if unlimited
    upper: float  #: likewise
    max_velocity: float  #: [rad/s] or [m/s]; inf if unlimited


class LinkPair(NamedTuple):
    """Two links that have shapes, and whether their distance is looked at."""
    link_a: str
    link_b: str
    is_checked: bool
    reason: str  #: why, or why not


class EnclosingShape(NamedTuple):
    """A shape that encloses a part of a link, centered at the origin of its own frame. It is all
    points within `radius` of a core: a point, a segment along z, or a box."""
    link: str
    name: str  #: unique within its link
    kind: str  #: "sphere", "capsule", "box" or "rounded_box"
    half_extents: npt.NDArray[np.float64]  #: (3,) [m] of the core
    radius: float  #: [m] with the padding
    link_from_shape: npt.NDArray[np.float64]  #: (4, 4) its pose in the frame of the link
    max_overshoot: float  #: [m] how far it sticks out; NaN for shapes that rules give
    mean_overshoot: float  #: [m] likewise
    is_exact: bool  #: it is the geometry of the URDF
    is_proven: bool  #: False: a shape that rules give, which the link may stick out of


class StateAnswer(NamedTuple):
    """The answer for one of many states."""
    verdict: Verdict
    quality: Quality  #: of the distance
    links: Optional[Tuple[str, str]]  #: the nearest pair; None if there is none
    distance: float  #: [m] of that pair; 0 or below: contact. NaN without a pair
