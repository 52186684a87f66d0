# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Published link approximations of the shared data, each written as a URDF of primitives. Its links
have the names of the robot that it approximates."""
import json
import math
import xml.etree.ElementTree as ElementTree

# Model: its file, and the robot whose meshes it approximates.
MODELS = {
    "franka capsules": ("franka_manufacturer_capsules/capsules.json", "panda_moveit"),
    "franka capsules + 0.03": ("franka_capsules_expanded_003/primitives.json", "panda_moveit"),
    "rai panda capsules": ("rai_panda_capsules/capsules.json", "panda_moveit"),
    "vamp panda spheres": ("vamp_spheres/panda_spheres.json", "panda_moveit"),
    "curobo franka spheres": ("curobo_spheres/franka_spheres.json", "panda_moveit"),
    "robometrics franka spheres": ("robometrics_franka_spheres/franka_spheres.json",
                                   "panda_moveit"),
    "foam panda spheres": ("foam_spheres/smaller_panda_spherized.json", "panda_moveit"),
    "drake panda spheres": ("drake_models/panda_arm_hand.json", "panda_moveit"),
    "vamp fetch spheres": ("vamp_spheres/fetch_spheres.json", "fetch"),
    "foam fetch 1 sphere": ("foam_spheres/fetch_spherized_1.json", "fetch"),
    "foam fetch 6 spheres": ("foam_spheres/fetch_spherized_6.json", "fetch"),
    "foam fetch 8 spheres": ("foam_spheres/fetch_spherized_8.json", "fetch"),
    "vamp ur5 spheres": ("vamp_spheres/ur5_spheres.json", "ur5_robotiq"),
    "kinova gen3 capsules": ("kinova_gen3_capsules/capsules.json", "kinova_gen3"),
    "drake iiwa14 spheres": ("drake_models/iiwa14_spheres_collision.json", "iiwa14_drake"),
    "drake iiwa14 dense spheres": ("drake_models/iiwa14_spheres_dense_collision.json",
                                   "iiwa14_drake"),
}
# Published, but the shared data has no meshes to compare them with.
WITHOUT_MESHES = ("curobo ur10e and dual ur10e spheres", "drake ur3e cylinders and spheres",
                  "drake jaco cylinders and spheres", "centauro capsules")


def rpy_along(axis):
    """The roll, pitch and yaw that turn z to an axis."""
    x, y, z = axis
    length = math.sqrt(x * x + y * y + z * z)
    if not length > 0.0:
        return (0.0, 0.0, 0.0)
    return (0.0, math.atan2(math.hypot(x, y), z), math.atan2(y, x))


def capsule(start, end, radius):
    along = [e - s for s, e in zip(start, end)]
    return {"type": "capsule", "xyz": [0.5 * (s + e) for s, e in zip(start, end)],
            "rpy": rpy_along(along), "radius": radius, "length": math.hypot(*along)}


def capsule_about(center, axis, length, radius):
    half = [0.5 * length * a for a in axis]
    return capsule([c - h for c, h in zip(center, half)], [c + h for c, h in zip(center, half)],
                   radius)


def turned(point, yaw):
    return [math.cos(yaw) * point[0] - math.sin(yaw) * point[1],
            math.sin(yaw) * point[0] + math.cos(yaw) * point[1], point[2]]


AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
# For rai: the rotations in its file, and the links of its joints.
RAI_AXES = {"": AXES["z"], "d(90 0 1 0)": AXES["x"], "d(90 1 0 0)": (0.0, -1.0, 0.0)}
RAI_LINKS = {"panda_hand_joint(hand)": "panda_hand"}

# For kinova: links that the URDF with the meshes spells differently.
KINOVA_LINKS = {
    "Shoulder_Link": "shoulder_link", "HalfArm1_Link": "half_arm_1_link",
    "HalfArm2_Link": "half_arm_2_link", "ForeArm_Link": "forearm_link",
    "SphericalWrist1_Link": "spherical_wrist_1_link",
    "SphericalWrist2_Link": "spherical_wrist_2_link", "Bracelet_Link": "bracelet_link"}


def franka_links(capsules):
    links = {}
    for entry in capsules:
        yaw = entry["frame_rpy"][2]
        links.setdefault("panda_" + entry["link"], []).append(capsule_about(
            turned(entry["center"], yaw), turned(AXES[entry["axis"]], yaw), entry["length"],
            entry["radius"]))
    return links


def rai_links(capsules):
    links = {}
    for entry in capsules:
        frame = entry["frame"]
        name = RAI_LINKS.get(frame, frame.split("(")[0].replace("joint", "link"))
        links.setdefault(name, []).append(capsule_about(entry["t"], RAI_AXES[entry["rot"]],
                                                        entry["length"], entry["radius"]))
    return links


def joined(primitives):
    """Joins a cylinder and two later spheres of its radius to a capsule, equal up to rounding."""
    shapes = list(primitives)
    for i in range(len(shapes) - 3, -1, -1):
        three = shapes[i:i + 3]
        if ([entry["type"] for entry in three] == ["cylinder", "sphere", "sphere"] and
                len({entry["radius"] for entry in three}) == 1):
            shapes[i:i + 3] = [capsule(three[1]["xyz"], three[2]["xyz"], three[0]["radius"])]
    return shapes


def primitive(entry):
    if "p1" in entry:
        return capsule(entry["p1"], entry["p2"], entry["radius"])
    if "center" in entry:
        return {"type": "sphere", "xyz": entry["center"], "radius": entry["radius"]}
    return entry


def read_links(file):
    """Link name to primitives, each a dict with type, xyz, rpy and sizes, as URDF has them."""
    data = json.loads(file.read_text(encoding="utf-8"))
    data = data.get("collision_spheres", data)
    if isinstance(data.get("capsules"), list):
        capsules = data["capsules"]
        return franka_links(capsules) if "link" in capsules[0] else rai_links(capsules)
    links = {KINOVA_LINKS.get(name, name): [primitive(entry) for entry in entries]
             for name, entries in data.items()}
    # cuRobo gives disabled spheres a radius that is not positive.
    return {name: joined(entry for entry in entries
                         if entry["type"] != "mesh" and entry["radius"] > 0.0)
            for name, entries in links.items()}


def write_urdf(links, file):
    robot = ElementTree.Element("robot", name="published")
    ElementTree.SubElement(robot, "link", name="root_of_model")
    for name, primitives in links.items():
        link = ElementTree.SubElement(robot, "link", name=name)
        for entry in primitives:
            collision = ElementTree.SubElement(link, "collision")
            ElementTree.SubElement(collision, "origin", {
                key: " ".join(repr(float(value)) for value in entry.get(key, (0.0, 0.0, 0.0)))
                for key in ("xyz", "rpy")})
            ElementTree.SubElement(
                ElementTree.SubElement(collision, "geometry"), entry["type"],
                {key: repr(float(entry[key])) for key in ("radius", "length") if key in entry})
        joint = ElementTree.SubElement(robot, "joint", name="to_" + name, type="fixed")
        ElementTree.SubElement(joint, "parent", link="root_of_model")
        ElementTree.SubElement(joint, "child", link=name)
    ElementTree.ElementTree(robot).write(file, encoding="utf-8")
