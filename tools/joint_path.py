# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Joint paths: reads and checks waypoints from a YAML file, and interpolates them. Needs no ROS.

The file format is described in play_joint_path.py.
"""
import math
import os
import stat
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

import yaml

FRAME_FIELDS = 6


def read_regular_file(path):
    """@return its bytes. Raises PathError if it is not a regular file: a pipe would block, a device may do
    anything."""
    mode = os.stat(path).st_mode
    if not stat.S_ISREG(mode):
        kinds = {stat.S_IFDIR: "a folder", stat.S_IFIFO: "a pipe (FIFO)", stat.S_IFSOCK: "a socket"}
        raise PathError([f"'{path}' is {kinds.get(stat.S_IFMT(mode), 'a device')}, not a regular file"])
    with open(path, "rb") as file:
        return file.read()


class PathError(Exception):
    """All problems of a path file, one per line."""

    def __init__(self, problems):
        super().__init__("\n".join(problems))
        self.problems = problems


@dataclass
class JointPath:
    """Rows hold the joint positions first, then six numbers for each floating link."""

    joints: list
    floating: dict
    interpolation: str
    times: list
    rows: list
    slopes: list = field(default_factory=list)

    @property
    def duration(self):
        return self.times[-1]


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) <= sys.float_info.max


def check_numbers(values, count, place, accepted, problems):
    """Adds a problem unless `values` is a list of `count` finite numbers."""
    if not isinstance(values, list) or len(values) != count:
        found = f"{len(values)} values" if isinstance(values, list) else repr(values)
        problems.append(f"{place}: found {found}; accepted: {accepted}")
        return
    for index, value in enumerate(values):
        if not is_number(value):
            problems.append(f"{place}, value {index + 1}: found {value!r}; accepted: a finite number")


def check_way_point(point, place, joints, floating, problems):
    if not isinstance(point, dict):
        problems.append(f"{place}: found {point!r}; accepted: time, positions and, if needed, frames")
        return
    for key in sorted(set(map(str, point)) - {"time", "positions", "frames"}):
        problems.append(f"{place}: found key '{key}'; accepted: time, positions, frames")
    if not is_number(point.get("time")) or point["time"] < 0:
        problems.append(f"{place}, time: found {point.get('time')!r}; accepted: seconds, 0 or more")
    check_numbers(point.get("positions"), len(joints), f"{place}, positions",
                  "one number for each joint", problems)
    frames = point.get("frames", {})
    if not isinstance(frames, dict) or set(frames) != set(floating):
        found = sorted(map(str, frames)) if isinstance(frames, dict) else repr(frames)
        problems.append(f"{place}, frames: found {found}; accepted: one entry for each of {sorted(floating)}")
        return
    for child, numbers in frames.items():
        check_numbers(numbers, FRAME_FIELDS, f"{place}, frames, {child}",
                      "x, y, z [m], roll, pitch, yaw [rad]", problems)


def check_header(content, name, problems):
    for key in sorted(set(map(str, content)) - {"joints", "interpolation", "floating", "way_points"}):
        problems.append(f"{name}: found key '{key}'; accepted: joints, interpolation, floating, way_points")
    joints = content.get("joints")
    if not isinstance(joints, list) or not all(isinstance(j, str) and j for j in joints):
        problems.append(f"{name}, joints: found {joints!r}; accepted: a list of joint names")
        joints = []
    for joint in sorted({j for j in joints if joints.count(j) > 1}):
        problems.append(f"{name}, joints: found '{joint}' twice; accepted: each name once")
    interpolation = content.get("interpolation", "cubic")
    if interpolation not in ("cubic", "cosine"):
        problems.append(f"{name}, interpolation: found {interpolation!r}; accepted: cubic, cosine")
    floating = content.get("floating", {})
    if not isinstance(floating, dict) or not all(isinstance(x, str) for kv in floating.items() for x in kv):
        problems.append(f"{name}, floating: found {floating!r}; accepted: child link: parent link")
        floating = {}
    return joints, interpolation, floating


def parse_path(text, name):
    """@return the path in `text`, bytes or str. `name` is for messages. Raises PathError with every problem."""
    try:
        content = yaml.safe_load(text)
    except yaml.YAMLError as error:
        raise PathError([f"{name}: not YAML: {' '.join(str(error).split())}"]) from error
    if not isinstance(content, dict):
        raise PathError([f"{name}: found {type(content).__name__}; accepted: joints and way_points"])
    problems = []
    joints, interpolation, floating = check_header(content, name, problems)
    points = content.get("way_points")
    if not isinstance(points, list) or not points:
        problems.append(f"{name}, way_points: found {points!r}; accepted: a list of one or more")
        points = []
    for number, point in enumerate(points, 1):
        check_way_point(point, f"{name}, way-point {number}", joints, floating, problems)
    if problems:
        raise PathError(problems)
    for number, (before, after) in enumerate(zip(points, points[1:]), 2):
        if after["time"] <= before["time"]:
            problems.append(f"{name}, way-point {number}, time: found {after['time']}; "
                            f"accepted: more than {before['time']}, the time before")
    if problems:
        raise PathError(problems)
    rows = [p["positions"] + [x for child in floating for x in p["frames"][child]] for p in points]
    times = [p["time"] for p in points]
    slopes = [find_slopes(times, column) for column in zip(*rows)]
    return JointPath(joints, floating, interpolation, times, rows, slopes)


def check_robot(path, name, urdf, urdf_name):
    """Raises PathError unless the path moves exactly the joints of the URDF text that move on their own. A
    joint without positions would leave links without a pose."""
    try:
        robot = ElementTree.fromstring(urdf)
    except ElementTree.ParseError as error:
        raise PathError([f"{urdf_name}: not XML: {error}"]) from error
    joints = [joint.get("name") for joint in robot.findall("joint")
              if joint.get("type") in ("revolute", "continuous", "prismatic") and joint.find("mimic") is None]
    problems = [f"{name}, joints: found '{joint}', which {urdf_name} does not move; accepted: {', '.join(joints)}"
                for joint in path.joints if joint not in joints]
    problems += [f"{name}, joints: '{joint}' of {urdf_name} is missing" for joint in joints if joint not in path.joints]
    if problems:
        raise PathError(problems)


def find_slopes(times, values):
    """Slopes of a cubic that does not overshoot: zero at the ends and at turning points, else the
    weighted harmonic mean of both neighboring slopes (Fritsch and Butland, "A method for constructing local
    monotone piecewise cubic interpolants", SIAM J. Sci. Stat. Comput. 5, 1984)."""
    slopes = [0.0] * len(values)
    for k in range(1, len(values) - 1):
        before, after = times[k] - times[k - 1], times[k + 1] - times[k]
        rise_before, rise_after = (values[k] - values[k - 1]) / before, (values[k + 1] - values[k]) / after
        if rise_before * rise_after > 0:
            a, b = 2 * after + before, after + 2 * before
            slopes[k] = (a + b) / (a / rise_before + b / rise_after)
    return slopes


def sample(path, time):
    """@return values and their rates at `time`, clamped to the path's times."""
    time = min(max(time, path.times[0]), path.times[-1])
    if len(path.times) == 1:
        return list(path.rows[0]), [0.0] * len(path.rows[0])
    k = max(i for i in range(len(path.times) - 1) if i == 0 or path.times[i] <= time)
    span = path.times[k + 1] - path.times[k]
    u = (time - path.times[k]) / span
    values, rates = [], []
    for start, end, slopes in zip(path.rows[k], path.rows[k + 1], path.slopes):
        m0, m1 = slopes[k] * span, slopes[k + 1] * span
        if path.interpolation == "cosine":
            values.append(start + (end - start) * (1 - math.cos(math.pi * u)) / 2)
            rates.append((end - start) * math.pi * math.sin(math.pi * u) / 2 / span)
        else:  # cubic Hermite
            c3, c2 = 2 * (start - end) + m0 + m1, 3 * (end - start) - 2 * m0 - m1
            values.append(((c3 * u + c2) * u + m0) * u + start)
            rates.append(((3 * c3 * u + 2 * c2) * u + m0) / span)
    return values, rates


def quaternion_from_rpy(roll, pitch, yaw):
    """x, y, z, w of Rz(yaw) Ry(pitch) Rx(roll), the convention of URDF."""
    cr, sr = math.cos(roll / 2), math.sin(roll / 2)
    cp, sp = math.cos(pitch / 2), math.sin(pitch / 2)
    cy, sy = math.cos(yaw / 2), math.sin(yaw / 2)
    return (sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy)


def check_loop(path, name):
    """Raises PathError unless the path can be repeated without a jump."""
    if len(path.rows) < 2 or path.rows[0] != path.rows[-1]:
        raise PathError([f"{name}, way-point {len(path.rows)}: the last of {len(path.rows)}, differs from the first or is "
                         "the only one; accepted in a loop: two or more way-points, the last equal to the first"])
