#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the includes of the package against the table of rooms below.

Prints one line for each forbidden include and exits 1 if there is one.
"""
import argparse
import pathlib
import re
import sys

GEOMETRY = {"geometry"}
PHASES = {"broad_phase", "narrow_phase", "motion"}
MAY_INCLUDE = {
    "geometry": GEOMETRY,
    "fitting": GEOMETRY | {"fitting"},
    "model": GEOMETRY | {"fitting", "model"},
    "broad_phase": GEOMETRY | {"broad_phase"},
    "narrow_phase": GEOMETRY | {"narrow_phase"},
    "motion": GEOMETRY | {"narrow_phase", "motion"},
    "pipeline": GEOMETRY | {"fitting", "model", "pipeline"} | PHASES,
    "library": GEOMETRY | {"fitting", "model", "pipeline", "library"} | PHASES,
    "ros_edge": GEOMETRY | {"fitting", "model", "pipeline", "ros_edge"} | PHASES,
}
# The same for folders within a room. Files directly in a room may include any folder, and the
# reverse. Folders of rooms that are not listed may include each other.
CONVEX = {"closed_form", "contact", "gjk"}
MESHES = {"mesh", "mesh_inside", "mesh_front", "mesh_depth", "triangle"}
MAY_INCLUDE_WITHIN = {
    "geometry": {
        "lanes": {"lanes"},
        "meshes": {"meshes", "lanes"},
        "bvh": {"bvh", "meshes"},
        "hulls": {"hulls", "bvh"},
    },
    "fitting": {
        "search": {"search"},
        "proofs": {"proofs", "search"},
        "shapes": {"shapes", "proofs", "search"},
        "inner": {"inner", "proofs", "search"},
        "parts": {"parts", "shapes", "proofs", "search"},
        "sphere_trees": {"sphere_trees", "shapes", "proofs", "search"},
    },
    "model": {
        "mesh_files": {"mesh_files"},
        "mesh_loading": {"mesh_loading", "mesh_files"},
        "resources": {"resources", "mesh_files"},
        "urdf": {"urdf", "mesh_loading", "mesh_files"},
        "srdf": {"srdf"},
        "rules": {"rules"},
        "world": {"world", "rules", "mesh_loading", "mesh_files"},
        "kinematics": {"kinematics"},
        "second_reader": {"second_reader"},
    },
    "narrow_phase": {
        "closed_form": {"closed_form"},
        "contact": {"contact", "closed_form"},
        "gjk": CONVEX,
        "epa": CONVEX | {"epa"},
        "sat": CONVEX | {"sat"},
        "warm_start": CONVEX | {"warm_start"},
        "convex": CONVEX | {"convex", "epa", "sat", "warm_start"},
        "simd": {"simd", "closed_form"},
        "triangle": CONVEX | {"triangle"},
        "mesh": CONVEX | MESHES | {"warm_start"},
        "mesh_front": CONVEX | MESHES,
        "mesh_depth": CONVEX | MESHES,
        "mesh_inside": MESHES,
    },
}
# Headers that only the named rooms may include; all other third-party headers are free.
RESERVED = {
    re.compile(r"^(ros|tf2|tf2_ros|nodelet|pluginlib|diagnostic_\w+|resource_retriever)/"): {"ros_edge"},
    re.compile(r"^(geometry|sensor|shape|std|trajectory|visualization)_(msgs|srvs)/"): {"ros_edge"},
    re.compile(r"^assimp/"): {"model"},
    re.compile(r"^tinyxml2\.h$"): {"model"},
    re.compile(r"^yaml-cpp/"): {"model"},
    re.compile(r"^(urdf_model|urdf_parser|console_bridge)/"): {"model"},
    re.compile(r"^openssl/"): {"pipeline"},
    re.compile(r"^hwy/"): {"geometry", "fitting", "model", "broad_phase", "narrow_phase", "motion", "pipeline"},
    re.compile(r"^libqhull"): {"geometry"},
    re.compile(r"^(fcl|coal)/"): set(),
}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def room_of(path, root):
    parts = path.relative_to(root).parts
    if parts[0] == "include":
        return parts[2] if len(parts) > 3 else "library"
    return parts[1]


def included_room(include, path):
    """@return the room of an included header, or None if it is outside the package."""
    parts = pathlib.PurePosixPath(include).parts
    if parts[0] == "collision_monitor":
        if len(parts) > 2:
            return parts[1]
        # One level deep: generated headers of messages, and the library's own, in lower case.
        return "library" if parts[1].islower() else "ros_edge"
    if (path.parent / include).exists():
        return None  # in the same folder
    return parts[0] if parts[0] in MAY_INCLUDE else None


def folder_faults_of(path, root, include):
    """@return the faults of an include between folders of one room."""
    parts = path.relative_to(root).parts
    folders = MAY_INCLUDE_WITHIN.get(parts[1]) if parts[0] == "src" and len(parts) == 4 else None
    if folders is None:
        return []
    if parts[2] not in folders:
        return [f"{path.relative_to(root)}: no folder '{parts[2]}' in the table of check_layers.py"]
    target = pathlib.PurePosixPath(include).parts
    if len(target) != 3 or target[0] != parts[1] or target[1] in folders[parts[2]]:
        return []
    return [f"{path.relative_to(root)}: {parts[2]} may not include {target[1]} ({include})"]


def faults_of(path, root):
    room = room_of(path, root)
    if room not in MAY_INCLUDE:
        return [f"{path.relative_to(root)}: no room '{room}' in the table of check_layers.py"]
    faults = []
    for include in INCLUDE.findall(path.read_text(encoding="utf-8")):
        target = included_room(include, path)
        if target is not None and target not in MAY_INCLUDE[room]:
            faults.append(f"{path.relative_to(root)}: {room} may not include {target} ({include})")
        faults += folder_faults_of(path, root, include)
        for pattern, rooms in RESERVED.items():
            if pattern.match(include) and room not in rooms:
                faults.append(f"{path.relative_to(root)}: {room} may not include {include}")
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("root", nargs="?", default=pathlib.Path(__file__).resolve().parent.parent,
                        type=pathlib.Path, help="the package's folder")
    root = parser.parse_args().root.resolve()
    files = sorted(path for folder in ("include/collision_monitor", "src")
                   for suffix in ("*.h", "*.cpp") for path in (root / folder).rglob(suffix))
    if not files:
        sys.exit(f"no sources under {root}")
    faults = [fault for path in files for fault in faults_of(path, root)]
    print("\n".join(faults) if faults else f"{len(files)} files keep to their layers")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
