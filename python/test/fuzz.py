# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Calls the module with wild arguments: fuzz.py COUNT [SEED]. Each call must answer or raise one of
the exceptions below. A crash ends the interpreter and so the test."""
import collections
import faulthandler
import pathlib
import random
import sys
import warnings

import numpy as np

import collision_monitor_core as cm

URDF = pathlib.Path(__file__).resolve().parents[2] / "urdf"
WORLD = b"""
- {name: floor, kind: plane, xyz: [0, 0, -1], touch_links: [box_a]}
- {name: part, kind: cone, attach: box_b, radius: 0.1, length: 0.2, padding: 0.01}
- {name: post, frame: box_a, shapes: [{kind: box, size: [1, 1, 1]}, {kind: sphere, radius: 2}]}
"""
ALLOWED = (cm.ArgumentError, cm.SetupError, TypeError, IndexError)
NUMBERS = [0.0, 1.0, -1.0, 0.1, 3.0, 1e-9, 1e-300, 5e-324, 1e9, 1e10, 1e300, -1e300, float("inf"),
           -float("inf"), float("nan"), 2**31, 2**32, 2**63, 2**64, 10**400, -1, 7, True, None, "1",
           b"2", 1j, np.float32(0.5), np.int8(-3), np.nan]


class Unruly:
    """Raises wherever numpy and Python look."""

    def __array__(self, *_):
        raise ValueError("no array")

    def __float__(self):
        raise ValueError("no number")

    def __len__(self):
        return 6

    def __getitem__(self, _):
        raise ValueError("no item")


class Maker:
    """Makes arguments."""

    def __init__(self, seed, robots):
        self.random = random.Random(seed)
        self.robots = robots

    def pick(self, *choices):
        return self.random.choice(choices)

    def number(self):
        return self.random.choice(NUMBERS) if self.random.random() < 0.5 \
            else self.random.uniform(-3.0, 3.0)

    def floats(self, *shape):
        array = np.random.default_rng(self.random.getrandbits(32)).uniform(-3.0, 3.0, shape)
        if array.size and self.random.random() < 0.4:
            for _ in range(self.random.randint(1, 3)):
                number = self.random.choice([n for n in NUMBERS[:15]])
                array.flat[self.random.randrange(array.size)] = number
        return array

    def size(self):
        return self.pick(0, 1, 2, 3, 4, 5, 6, 7, 8, 40)

    def array(self, *shape):
        """Of the shape, or a wild one, in one of many forms."""
        if self.random.random() < 0.25:
            shape = tuple(self.size() for _ in range(self.random.randrange(4)))
        array = self.floats(*shape)
        form = self.random.randrange(14)
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            forms = {
                1: array.tolist, 2: lambda: array.astype(self.pick("f4", ">f8", "i4", "?", "f2")),
                3: lambda: array.astype(self.pick(complex, object, str, "S4")),
                4: lambda: np.ma.array(array, mask=array > 1.0),
                5: lambda: np.asfortranarray(array), 6: lambda: array[..., ::-1],
                7: lambda: np.repeat(array, 2, axis=-1)[..., ::2] if array.ndim else array,
                8: lambda: unaligned(array), 9: lambda: array.view(np.recarray)}
            return forms.get(form, lambda: array)()

    def anything(self, n=6):
        return self.pick(
            None, self.number(), "abc", "\ud800", "\0", b"\xff", [], {}, (), set(), object(),
            Unruly(), nested(), iter([1.0]), self.array(n), self.array(4, 4), self.robots[0],
            cm.Solid.sphere(1.0), lambda *_: 1, [Unruly()] * n, range(n), slice(None))

    def state(self, robot):
        n = len(robot.variables)
        if self.random.random() < 0.2:
            return self.anything(n)
        if self.random.random() < 0.2:
            names = [each.name for each in robot.variables] + ["?", "", "\0", 3, None]
            return {self.random.choice(names): self.number()
                    for _ in range(self.random.randrange(5))}
        return self.array(n)

    def states(self, robot):
        if self.random.random() < 0.1:
            return self.anything()
        return self.array(self.size(), len(robot.variables))

    def pose(self):
        if self.random.random() < 0.1:
            return self.anything()
        pose = np.eye(4)
        pose[:3, 3] = self.floats(3)
        return self.pick(None, pose, self.array(3), self.array(4, 4))

    def solid(self):
        make = {
            0: lambda: cm.Solid.sphere(self.number()),
            1: lambda: cm.Solid.capsule(self.number(), self.number()),
            2: lambda: cm.Solid.box(self.array(3)),
            3: lambda: cm.Solid.cylinder(self.number(), self.number()),
            4: lambda: cm.Solid.cone(self.number(), self.number()),
            5: lambda: cm.Solid.hull(self.array(self.size(), 3)),
            6: lambda: cm.Solid.mesh(self.array(self.size(), 3), self.triangles()),
            7: lambda: cm.Solid.mesh_file(self.pick(self.anything(), URDF, "no.stl"),
                                          self.number())}
        return make[self.random.randrange(8)]()

    def triangles(self):
        return self.pick(self.array(self.size(), 3), np.array([[0, 1, 2], [2, 1, 0]]),
                         np.array([[0, 0, 0]]), np.arange(6).reshape(2, 3),
                         [[0, self.number(), 2]])


def unaligned(array):
    """The same numbers, one byte beside where doubles stand."""
    memory = np.zeros(array.nbytes + 1, np.uint8)
    view = memory[1:].view(np.float64).reshape(array.shape) if array.nbytes else array
    view[...] = array
    return view


def nested(depth=100):
    """A list in a list in a list ..."""
    inner = [0.0]
    for _ in range(depth):
        inner = [inner]
    return inner


def use(answer):
    """Reads what an answer has."""
    for name in dir(answer):
        if not name.startswith("_") and name != "plot":
            getattr(answer, name)
    repr(answer)
    if hasattr(answer, "__getitem__") and hasattr(answer, "__len__"):
        for i in (0, -1, len(answer), -len(answer) - 1, 2**40):
            try:
                repr(answer[i])
            except IndexError:
                pass


class Calls:
    """The calls, one a method."""

    def __init__(self, maker):
        self.make = maker
        self.solids = [cm.Solid.sphere(1.0), cm.Solid.box([1.0, 2.0, 3.0])]

    def robot(self):
        return self.make.random.choice(self.make.robots)

    def one_state(self):
        robot = self.robot()
        method = self.make.pick("verdict", "nearest", "contacts", "link_poses", "state")
        use(getattr(robot, method)(self.make.state(robot)))

    def distances(self):
        robot = self.robot()
        use(robot.distances(self.make.state(robot), self.make.number(),
                            self.make.pick(True, False, None, 3)))

    def check(self):
        robot = self.robot()
        use(robot.check(self.make.states(robot), self.make.pick("nearest", "contact", "", 3),
                        self.make.pick(0, 1, 2, 8, self.make.number()),
                        self.make.pick(None, None, lambda _: None, self.make.anything())))

    def check_path(self):
        robot = self.robot()
        options = {name: self.make.number() for name in ("margin", "resolution", "tolerance")
                   if self.make.random.random() < 0.5}
        use(robot.check_path(
            self.make.states(robot), self.make.pick(None, self.make.array(self.make.size())),
            self.make.pick(None, None, self.make.states(robot)),
            budget=self.make.random.randrange(300),
            progress=self.make.pick(None, None, self.make.anything()), **options))

    def make_solid(self):
        solid = self.make.solid()
        self.solids = [*self.solids[-20:], solid]

    def two_solids(self):
        pick = lambda: self.make.anything() if self.make.random.random() < 0.05 \
            else self.make.random.choice(self.solids)
        measure = self.make.pick(cm.distance, cm.collide)
        rest = [self.make.number()] if measure is cm.distance and self.make.pick(0, 1) else []
        use(measure(pick(), self.make.pose(), pick(), self.make.pose(), *rest))

    def index(self):
        robot = self.robot()
        found = robot.distances(robot.default_state)
        found[self.make.number()]

    def wrong_arguments(self):
        robot = self.robot()
        names = [name for name in dir(robot) if not name.startswith("_") and name != "plot"]
        attribute = getattr(robot, self.make.random.choice(names))
        if callable(attribute):
            attribute(*(self.make.anything() for _ in range(self.make.random.randrange(4))))

    def load_text(self):
        name = self.make.pick("two_boxes.urdf", "three_capsules.urdf")
        text = bytearray((URDF / name).read_bytes())
        for _ in range(self.make.random.randrange(4)):
            text[self.make.random.randrange(len(text))] = self.make.random.randrange(256)
        robot = cm.loads(text.decode("latin-1"), fit_cache="none")
        use(robot)
        robot.distances(robot.default_state)

    def with_world(self):
        text = bytearray(WORLD)
        for _ in range(self.make.random.randrange(4)):
            text[self.make.random.randrange(len(text))] = self.make.random.randrange(256)
        robot = self.robot().with_world(self.make.pick(text.decode("latin-1"),
                                                       self.make.anything(), None))
        use(robot)
        robot.distances(robot.default_state)

    def load_options(self):
        names = ["prefix", "world_from_root", "packages", "rules", "pair_rules", "world",
                 "ignore_pairs", "padding",
                 "contact_distance", "warning_distance", "distance_tolerance", "detail",
                 "max_shapes", "target_overshoot", "ignore_default_overlap", "fit_cache"]
        options = {self.make.random.choice(names): self.make.pick(self.make.anything(),
                                                                  self.make.number())
                   for _ in range(self.make.random.randrange(3))}
        options["fit_cache"] = "none"
        use(cm.load(self.make.pick(URDF / "two_boxes.urdf", URDF / "two_boxes.urdf",
                                   self.make.anything()), **options))


# Calls that read robots take a thousand times as long as others.
WEIGHTS = {"one_state": 30, "distances": 20, "check": 10, "check_path": 10, "make_solid": 15,
           "two_solids": 30, "index": 3, "wrong_arguments": 10, "load_text": 1, "with_world": 1, "load_options": 1}


def main():
    count, seed = int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 20260101
    faulthandler.enable()
    robots = [cm.load(URDF / f"{name}.urdf", srdf and URDF / f"{name}.srdf", fit_cache="none")
              for name, srdf in (("arm6", True), ("two_boxes", None), ("three_capsules", None))]
    calls = Calls(Maker(seed, robots))
    methods = [getattr(calls, name) for name in WEIGHTS]
    outcomes = collections.Counter()
    warnings.simplefilter("ignore")
    for _ in range(count):
        try:
            calls.make.random.choices(methods, [*WEIGHTS.values()])[0]()
            outcomes["answered"] += 1
        except ALLOWED as failure:
            outcomes[type(failure).__name__] += 1
    print(f"{count} calls of seed {seed}:", dict(outcomes))
    return 0 if outcomes["answered"] > count / 10 else 1


if __name__ == "__main__":
    sys.exit(main())
