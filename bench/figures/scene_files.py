# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of the shared data as files that a monitor reads. Planning scenes of MoveIt stay as they
are, but for meshes that are not at hand; other formats are written anew as lists of objects."""
import dataclasses
import gzip
import json
import pathlib
import xml.etree.ElementTree

import yaml


@dataclasses.dataclass
class SceneSet:
    label: str
    robot: str
    files: list
    packages: list = dataclasses.field(default_factory=list)  # folders that hold packages
    is_timed: bool = False


def write_objects(file, objects):
    file.write_text(json.dumps({"world": objects}), encoding="utf-8")  # JSON is YAML
    return file


def vamp_object(source):
    dims = source["dims"]
    shape = {"box": lambda: {"size": dims},
             "cylinder": lambda: {"length": dims[0], "radius": dims[1]},
             "sphere": lambda: {"radius": dims[0]}}[source["type"]]()
    return {"name": source["id"], "kind": source["type"], "xyz": source["pos"],
            "quat_xyzw": source["quat_xyzw"], **shape}


def vamp_sets(data, folder):
    """The problems of MotionBenchMaker as VAMP publishes them, one scene each."""
    for robot in ("panda", "fetch"):
        sets = {}
        with gzip.open(data / "scenes/mbm_vamp" / f"{robot}_problems.jsonl.gz", "rt") as lines:
            for line in lines:
                problem = json.loads(line)
                file = folder / f"{problem['set']}_{problem['index']}.yaml"
                write_objects(file, [vamp_object(source) for source in problem["objects"]])
                sets.setdefault(problem["set"], []).append(file)
        for name, files in sets.items():
            yield SceneSet(name, robot, files, is_timed=True)


def curobo_objects(source):
    """`pose` is x, y, z and the quaternion w, x, y, z."""
    objects = []
    for kind, of_kind in source.items():
        for name, fields in (of_kind or {}).items():
            pose = fields.get("pose", [*fields.get("position", []), 1, 0, 0, 0])
            one = {"name": name, "xyz": pose[:3], "quat_xyzw": [*pose[4:7], pose[3]]}
            if kind == "cuboid":
                one.update(kind="box", size=fields["dims"])
            elif kind == "sphere":
                one.update(kind="sphere", radius=fields["radius"])
            elif kind == "cylinder":
                one.update(kind="cylinder", radius=fields["radius"], length=fields["height"])
            elif kind == "capsule":
                one["shapes"] = [capsule_shape(fields)]
            else:
                raise ValueError(f"{name}: unknown kind {kind}")
            objects.append(one)
    return objects


def capsule_shape(fields):
    base, tip = fields["base"], fields["tip"]
    if base[:2] != tip[:2]:
        raise ValueError(f"a capsule from {base} to {tip} is not along z")
    return {"kind": "capsule", "radius": fields["radius"], "length": abs(tip[2] - base[2]),
            "xyz": [0.5 * (a + b) for a, b in zip(base, tip)]}


def curobo_sets(data, folder):
    files = [write_objects(folder / f"curobo_{source.stem}.yaml",
                           curobo_objects(yaml.safe_load(source.read_text(encoding="utf-8"))))
             for source in sorted((data / "scenes/curobo_scenes").glob("*.yml"))]
    yield SceneSet("curobo", "panda", files)
    problems = yaml.safe_load(
        (data / "scenes/robometrics_demo/demo_set.yaml").read_text(encoding="utf-8"))
    files = [write_objects(folder / f"robometrics_{name}_{i}.yaml",
                           curobo_objects(problem["obstacles"]))
             for name, of_name in problems.items() for i, problem in enumerate(of_name)]
    yield SceneSet("robometrics", "panda", files)


def numbers_of(element, name):
    return [float(word) for word in (element.get(name) if element is not None else "0 0 0").split()]


def urdf_objects(urdf, packages):
    """Meshes of a URDF at zero; joints have no rotation of their own."""
    robot = xml.etree.ElementTree.parse(urdf).getroot()
    parents = {joint.find("child").get("link"): joint for joint in robot.findall("joint")}

    def place(link):
        offset = [0.0, 0.0, 0.0]
        while link in parents:
            origin = parents[link].find("origin")
            if any(numbers_of(origin, "rpy")):
                raise ValueError(f"{urdf}: joint {parents[link].get('name')} is turned")
            offset = [a + b for a, b in zip(offset, numbers_of(origin, "xyz"))]
            link = parents[link].find("parent").get("link")
        return offset

    objects = []
    for link in robot.findall("link"):
        for part in link.findall("collision"):
            origin = part.find("origin")
            xyz = [a + b for a, b in zip(place(link.get("name")), numbers_of(origin, "xyz"))]
            mesh = file_of(part.find("geometry/mesh").get("filename"), packages)
            objects.append({"name": link.get("name"), "kind": "mesh", "file": str(mesh),
                            "xyz": xyz, "rpy": numbers_of(origin, "rpy")})
    return objects


def file_of(name, packages):
    """The file of a package:// name, which may not be there."""
    path = name.removeprefix("package://")
    found = [folder / path for folder in packages if (folder / path).is_file()]
    return found[0] if found else packages[0] / path


def planning_scenes(data):
    for file in sorted((data / "scenes").rglob("*.y*ml")):
        if file.stat().st_size > 10_000_000 or " collision_objects:" not in file.read_text(
                encoding="utf-8"):
            continue
        scene = yaml.safe_load(file.read_text(encoding="utf-8"))
        if isinstance(scene, dict) and (scene.get("world") or {}).get("collision_objects"):
            yield file, scene


def packages_of(data):
    return [data / "scenes/mbm_scene_templates"]


def missing_meshes(scene, packages):
    return sorted({mesh["resource"] for one in scene["world"]["collision_objects"]
                   for mesh in one.get("meshes") or []
                   if "resource" in mesh and not file_of(mesh["resource"], packages).is_file()})


def scenes_without_meshes(data):
    """([(scene, names of meshes that are not at hand)], folders of packages)"""
    packages = packages_of(data)
    lacking = [(file, missing_meshes(scene, packages)) for file, scene in planning_scenes(data)]
    return [one for one in lacking if one[1]], packages


def planning_sets(data, folder):
    """A scene without some of its meshes loses the objects that they make."""
    packages = packages_of(data)
    sets = {}
    for file, scene in planning_scenes(data):
        missing = missing_meshes(scene, packages)
        if missing:
            scene["world"]["collision_objects"] = [
                one for one in scene["world"]["collision_objects"]
                if all(mesh.get("resource") not in missing for mesh in one.get("meshes") or [])]
            if not scene["world"]["collision_objects"]:
                continue
            file = folder / f"{len(sets)}_{file.name}"
            file.write_text(yaml.safe_dump(scene), encoding="utf-8")
            sets.setdefault("robowflex, kitchen: without meshes", []).append(file)
        else:
            label = "robowflex" if "robowflex" in file.parts else "motion_bench_maker templates"
            sets.setdefault(label, []).append(file)
    for label, files in sets.items():
        yield SceneSet(label, "fetch", files, packages)


def urdf_sets(data, folder):
    packages = packages_of(data)
    files = []
    for urdf in sorted((data / "scenes").rglob("*.urdf")):
        objects = urdf_objects(urdf, packages)
        if all(pathlib.Path(one["file"]).is_file() for one in objects):
            files.append(write_objects(folder / f"urdf_{urdf.stem}.yaml", objects))
    yield SceneSet("motion_bench_maker URDFs", "fetch", files, packages)


def all_sets(data, folder):
    """Writes converted scenes into `folder`."""
    folder = pathlib.Path(folder)
    for sets in (planning_sets, urdf_sets, curobo_sets, vamp_sets):
        yield from sets(data, folder)
