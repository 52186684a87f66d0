# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cycles of the running node at 1 kHz that are late, so they end more than a period after they should have started,
while 1,000 boxes come and go as fast as the service apply_objects answers. The reference is the same node in the same
time with no changes: what this machine does to it. Joint states and tf come 1,000 times a second, and somebody listens
to markers, as rviz does, and to the list of objects."""
import contextlib
import math
import os
import random
import statistics
import subprocess
import threading
import time

import rospy
from collision_monitor.msg import SceneChange, SceneObject, State
from collision_monitor.srv import ApplyObjects, ApplyObjectsRequest
from shape_msgs.msg import SolidPrimitive

import running

RATE = 1000
SECONDS = 2.0
ROUNDS = 15  # alternate, so that whatever else the machine does meets both
BOXES = 1000
MOST_ALONE = 0.05  # of the cycles
WARM_UP = 90.0  # [s] at most


def boxes_around():
    """Boxes of 5 cm from 1.5 m to 6 m away."""
    numbers = random.Random(20260101)
    boxes = []
    while len(boxes) < BOXES:
        place = [numbers.uniform(-6.0, 6.0) for _ in range(3)]
        if 1.5 < sum(x * x for x in place) ** 0.5 < 6.0:
            box = SceneObject(name=f"box_{len(boxes)}")
            box.pose.position.x, box.pose.position.y, box.pose.position.z = place
            box.pose.orientation.w = 1.0
            box.primitives = [SolidPrimitive(type=SolidPrimitive.BOX, dimensions=[0.05, 0.05, 0.05])]
            boxes.append(box)
    return boxes


def count_late(work):
    """Runs `work`. @return (cycles, late ones) in that time"""
    before = rospy.wait_for_message(f"{running.NODE}/state", State, 10.0)
    work()
    after = rospy.wait_for_message(f"{running.NODE}/state", State, 10.0)
    return after.cycles - before.cycles, after.overruns - before.overruns


class Changes:
    """Adds and clears the boxes, and notes how long each call takes [s]."""

    def __init__(self):
        rospy.wait_for_service(f"{running.NODE}/apply_objects", WARM_UP)
        self.apply = rospy.ServiceProxy(f"{running.NODE}/apply_objects", ApplyObjects, persistent=True)
        self.requests = [ApplyObjectsRequest(changes=[SceneChange(kind=SceneChange.ADD, objects=boxes_around())]),
                         ApplyObjectsRequest(changes=[SceneChange(kind=SceneChange.CLEAR)])]
        self.taken = []

    def make(self):
        """On a thread that yields to the monitor, as clients on other machines do."""
        thread = threading.Thread(target=self.run)
        thread.start()
        thread.join()

    def run(self):
        os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), 10)
        end = time.monotonic() + SECONDS
        while time.monotonic() < end:
            for request in self.requests:
                start = time.monotonic()
                answer = self.apply(request)
                self.taken.append(time.monotonic() - start)
                if not answer.success:
                    raise RuntimeError(answer.message)


@contextlib.contextmanager
def moving(label, seconds):
    """The robot moves, and the monitor knows all of its links."""
    command = ["rosrun", "collision_monitor", "collision_monitor_node_bench", label,
               str(running.process_id(WARM_UP)), str(seconds)]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as mover:
        end = time.monotonic() + WARM_UP
        while rospy.wait_for_message(f"{running.NODE}/state", State, WARM_UP).level == State.UNKNOWN:
            if time.monotonic() > end:
                raise RuntimeError("links stay unknown")
        try:
            yield
        finally:
            mover.terminate()


@contextlib.contextmanager
def listening():
    """Receives what rviz shows."""
    listeners = [rospy.Subscriber(f"{running.NODE}/{topic}", rospy.AnyMsg, queue_size=1, buff_size=1 << 24)
                 for topic in ("markers", "objects")]
    try:
        yield
    finally:
        for listener in listeners:
            listener.unregister()


def most_by_chance(late_alone, late):
    """As many late cycles in all rounds as chance allows: three standard errors more than alone, or those of a single
    one. Late cycles come in bursts, so the rounds themselves show how far they scatter.
    @param late_alone, late in each round"""
    difference = [ours - reference for ours, reference in zip(late, late_alone)]
    error = math.sqrt(len(difference) * statistics.variance(difference))
    return sum(late_alone) + 3.0 * max(1.0, error)


def add_robot(figures, robot):
    """@param robot one of shared_robots(). There is no goal for one that is late by itself.
    @return late cycles of each round, alone and in changes; empty if there is no goal"""
    label = robot[0]
    alone, changed = [], []
    with running.monitor(robot, {"rate": RATE}), moving(label, 4 * ROUNDS * SECONDS + WARM_UP), listening():
        changes = Changes()
        time.sleep(2.0)
        for _ in range(ROUNDS):
            for counts, work in ((alone, lambda: time.sleep(SECONDS)), (changed, changes.make)):
                counts.append(count_late(work))
    (cycles_alone, late_alone), (cycles, late) = zip(*alone), zip(*changed)
    name = f"{label}: late cycles at 1 kHz while {BOXES:,} boxes come and go"
    row = (f"{name} {len(changes.taken) // 2} times", f"{sum(late)} of {sum(cycles)}",
           f"{sum(late_alone)} of {sum(cycles_alone)} alone")
    is_late_alone = sum(late_alone) >= MOST_ALONE * sum(cycles_alone)
    if is_late_alone:
        figures.tell(*row)
    else:
        most = most_by_chance(late_alone, late)
        figures.add(*row, f"as alone, within chance: {most:.0f}", sum(late) <= most)
    figures.tell(f"{label}: a call of apply_objects with {BOXES:,} boxes, there and back",
                 f"{1e3 * statistics.median(changes.taken[::2]):.0f} ms", "")
    return ((), ()) if is_late_alone else (late_alone, late)


def add_robots(figures, robots):
    """Each robot, and all of them together: chance hides less in a sum."""
    counts = [add_robot(figures, robot) for robot in robots]
    late_alone, late = ([count for rounds in kind for count in rounds] for kind in zip(*counts))
    if not late:
        return
    most = most_by_chance(late_alone, late)
    figures.add("all of them: late cycles at 1 kHz while boxes come and go", sum(late), f"{sum(late_alone)} alone",
                f"as alone, within chance: {most:.0f}", sum(late) <= most)
