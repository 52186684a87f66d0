# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads the arguments of load() and loads(). All faults are told at once."""
import os
import re
from typing import Any, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

from . import _core
from .errors import ArgumentError

Path = Union[str, "os.PathLike[str]"]
DEFAULTS = {
    "detail": "mesh", "padding": 0.0, "contact_distance": 0.0, "warning_distance": 0.05,
    "distance_tolerance": 0.0, "max_shapes": 4, "target_overshoot": 0.01,
    "ignore_default_overlap": True, "fit_cache": ""}
DOCUMENTS = {"rules": "a YAML file", "pair_rules": "a YAML file",
             "world": "a YAML or .scene file"}
_KINDS = {float: "a number", int: "a whole number from 0", bool: "True or False", str: "a str"}


def _several(given: Any) -> List[Any]:
    return list(given) if isinstance(given, (list, tuple)) else [given]


def _path(given: Any, name: str, faults: List[str]) -> bytes:
    """The path as the system takes it."""
    try:
        path = os.fsencode(given)
    except (TypeError, UnicodeError):
        faults.append(f"`{name}` is {given!r:.100}; accepted: a path")
        return b""
    if b"\0" in path:
        faults.append(f"`{name}` has a zero byte; accepted: a path")
    return os.path.expanduser(path)


def _text(given: Any, name: str, faults: List[str]) -> str:
    try:
        if isinstance(given, str):
            given.encode()
            return given
    except UnicodeError:
        pass
    faults.append(f"`{name}` is {given!r:.100}; accepted: a str")
    return ""


def _matched(given: Any, count: int, name: str, faults: List[str], missing: Any) -> List[Any]:
    """One of each robot."""
    if given is None:
        return [missing] * count
    items = [missing if item is None else item for item in _several(given)]
    if len(items) != count:
        faults.append(f"`{name}` has {len(items)} entries; accepted: one for each of the {count} "
                      "robots")
        return [missing] * count
    return items


def _plain(name: str, value: Any, faults: List[str]) -> Any:
    kind: type = type(DEFAULTS[name])
    if kind is bool or isinstance(value, bool):
        is_good = kind is bool and isinstance(value, bool)
    elif kind is str:
        is_good = isinstance(value, str) or (name == "fit_cache" and hasattr(value, "__fspath__"))
    elif kind is int:
        is_good = hasattr(value, "__index__") and 0 <= value.__index__() < 2**32
    else:
        is_good = hasattr(value, "__float__") or hasattr(value, "__index__")
    if is_good:
        try:
            return os.fsencode(value) if kind is str else kind(value)
        except (TypeError, ValueError, OverflowError):  # of objects that refuse, too
            pass
    faults.append(f"`{name}` is {value!r:.100}; accepted: {_KINDS[kind]}")
    return DEFAULTS[name]


def _is_text(given: str) -> bool:
    """Whether this is YAML, and no name of a file."""
    return "\n" in given or given.lstrip()[:2] in ("", "- ", "[]") or given.lstrip()[0] in "[{#" \
        or re.match(r"\w+:(\s|$)", given.lstrip()) is not None


def _document(given: Any, name: str, what: str, faults: List[str]) -> Dict[str, Union[str, bytes]]:
    """A text with its name in messages, or no text and the path of a file."""
    nothing: Dict[str, Union[str, bytes]] = {name: "", name + "_source": ""}
    if given is None or (isinstance(given, str) and not given):
        return nothing
    if isinstance(given, str) and _is_text(given) and not os.path.isfile(os.path.expanduser(given)):
        return {name: _text(given, name, faults), name + "_source": name}
    if not isinstance(given, (str, bytes)) and not hasattr(given, "__fspath__"):
        faults.append(f"`{name}` is {given!r:.100}; accepted: {what}, or text in YAML")
        return nothing
    return {name: "", name + "_source": _path(given, name, faults)}


def _pairs(given: Any, faults: List[str]) -> List[Tuple[str, str]]:
    pairs = []
    try:
        for pair in given:
            link_a, link_b = pair
            pairs.append((_text(link_a, "ignore_pairs", faults),
                          _text(link_b, "ignore_pairs", faults)))
    except (TypeError, ValueError):
        faults.append("`ignore_pairs` is not a list of pairs; accepted: pairs of link names or "
                      "patterns, as [('hand', 'finger_*')]")
    return pairs


def _options(packages: Any, ignore_pairs: Any, poses: List[Any], given: Mapping[str, Any],
             faults: List[str]) -> Dict[str, Any]:
    plain = {name: value for name, value in given.items() if name not in DOCUMENTS}
    unknown = sorted(set(plain) - set(DEFAULTS))
    if unknown:
        faults.append(f"there is no option {', '.join(map(repr, unknown))}; accepted: "
                      + ", ".join(sorted([*DEFAULTS, *DOCUMENTS])))
    options = {name: _plain(name, plain.get(name, value), faults)
               for name, value in DEFAULTS.items()}
    for name, what in DOCUMENTS.items():
        options.update(_document(given.get(name), name, what, faults))
    options["packages"] = [_path(root, "packages", faults) for root in _several(packages)]
    options["ignored_pairs"] = _pairs(ignore_pairs, faults)
    options["world_from_root"] = poses
    return options


def load(urdf: Union[Path, Sequence[Path]],
         srdf: Union[None, Path, Sequence[Optional[Path]]] = None, *,
         prefix: Union[None, str, Sequence[str]] = None, world_from_root: Any = None,
         packages: Union[Path, Sequence[Path]] = (),
         ignore_pairs: Iterable[Tuple[str, str]] = (), **options: Any) -> "_core.Robot":
    """Reads a robot, encloses its links in shapes and decides which pairs of links are checked.

    urdf, srdf: files. For several robots lists, with one `prefix` and pose of each.
    world_from_root: where the root link stands: a (4, 4) pose or 3 numbers; None: the origin. For
        several robots a list.
    packages: where package://NAME/ is looked up, each a package or a folder of packages;
        ROS_PACKAGE_PATH and AMENT_PREFIX_PATH follow.
    ignore_pairs: pairs of names or patterns of links that are not checked, beside those of the
        SRDF.

    Options that are a file, or text in YAML: rules for shapes (config/shape_rules.yaml); pair_rules
    (config/pair_rules.yaml); world, objects beside the robots or attached to links
    (config/cells/table.yaml, or a .scene file of MoveIt), each a link of its own in answers.

    Other options: contact_distance=0.0 and warning_distance=0.05 [m] decide verdicts; padding=0.0
    [m] is added to every shape; detail="mesh" measures exact geometry, "hull" convex hulls, "none"
    the enclosing shapes; distance_tolerance=0.0 [m] lets distances be less than exact; max_shapes=4
    and target_overshoot=0.01 [m] are of each link; ignore_default_overlap=True leaves out, without
    an SRDF, pairs that touch in the default state; fit_cache="" keeps fits below $ROS_HOME or
    ~/.ros, "none" nowhere, else in that folder.

    Raises SetupError with all faults of robots, meshes, rules and options, and ArgumentError with
    all arguments of a wrong form.
    """
    faults: List[str] = []
    urdfs = [_path(path, "urdf", faults) for path in _several(urdf)]
    srdfs = [path if path == b"" else _path(path, "srdf", faults)
             for path in _matched(srdf, len(urdfs), "srdf", faults, b"")]
    prefixes = [_text(each, "prefix", faults)
                for each in _matched(prefix, len(urdfs), "prefix", faults, "")]
    given = _options(packages, ignore_pairs, _roots(world_from_root, len(urdfs), faults),
                     options, faults)
    if faults:
        raise ArgumentError(faults)
    return _core.load_files(list(zip(urdfs, srdfs, prefixes)), given)


def loads(urdf: str, srdf: str = "", *, directory: Path = "", prefix: str = "",
          world_from_root: Any = None, packages: Union[Path, Sequence[Path]] = (),
          ignore_pairs: Iterable[Tuple[str, str]] = (), **options: Any) -> "_core.Robot":
    """As load() of one robot, from the texts of its URDF and SRDF.

    directory: the base of relative names of meshes.
    """
    faults: List[str] = []
    texts = [_text(urdf, "urdf", faults), _text(srdf, "srdf", faults),
             _text(prefix, "prefix", faults)]
    folder = _path(directory, "directory", faults)
    given = _options(packages, ignore_pairs, _roots(world_from_root, 1, faults), options,
                     faults)
    if faults:
        raise ArgumentError(faults)
    return _core.load_texts([texts], folder, given)


def with_world(robot: "_core.Robot", world: Any) -> "_core.Robot":
    """What Robot.with_world() does."""
    faults: List[str] = []
    given = _document(world, "world", DOCUMENTS["world"], faults)
    if faults:
        raise ArgumentError(faults)
    return _core.with_world(robot, given)


def _roots(given: Any, count: int, faults: List[str]) -> List[Any]:
    """One pose of each robot. For one robot, the pose need not be in a list."""
    if given is None:
        return []
    if count == 1 and not (isinstance(given, (list, tuple)) and len(given) == 1):
        return [given]
    return [None if pose == "" else pose
            for pose in _matched(given, count, "world_from_root", faults, "")] \
        if isinstance(given, (list, tuple)) else _not_poses(given, faults)


def _not_poses(given: Any, faults: List[str]) -> List[Any]:
    faults.append(f"`world_from_root` is of type '{type(given).__name__}'; accepted: a list of "
                  "poses, one for each robot")
    return []
