#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plays a joint path from a YAML file as sensor_msgs/JointState, for robot_state_publisher.

The file:

    joints: [shoulder, elbow]           # names as in the URDF
    interpolation: cubic                # or cosine; optional
    floating: {torso: odom}             # optional: child link: parent link, sent to /tf
    way_points:
      - {time: 0.0, positions: [0.0, 0.0], frames: {torso: [0, 0, 0.3, 0, 0, 0]}}
      - {time: 2.0, positions: [0.5, -1.2], frames: {torso: [0, 0, 0.3, 0, 0, 0.5]}}

Times in seconds, positions in rad or m. `frames` places floating and planar joints, which JointState
cannot carry: x, y, z [m], roll, pitch, yaw [rad], parent from child. Each number is interpolated by itself.

cubic stops only at turning points and at both ends. Between two waypoints it stays within their range.
cosine stops at every waypoint.
"""
import argparse
import os
import sys

import rospy
from geometry_msgs.msg import Quaternion, TransformStamped, Vector3
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64
from tf2_ros import TransformBroadcaster

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
from joint_path import (FRAME_FIELDS, PathError, check_loop, check_robot, parse_path,  # noqa: E402
                        quaternion_from_rpy, read_regular_file, sample)


class Player:
    """Owns the publishers. The path has been checked before."""

    def __init__(self, path, options):
        self.path, self.options = path, options
        self.joint_states = rospy.Publisher("joint_states", JointState, queue_size=10)
        self.progress = rospy.Publisher("~progress", Float64, queue_size=10, latch=True)
        self.broadcaster = TransformBroadcaster() if path.floating else None

    def publish(self, time):
        values, rates = sample(self.path, time)
        stamp, count = rospy.Time.now(), len(self.path.joints)
        message = JointState(name=[self.options.joint_prefix + j for j in self.path.joints],
                             position=values[:count], velocity=rates[:count])
        message.header.stamp = stamp
        self.joint_states.publish(message)
        for index, (child, parent) in enumerate(self.path.floating.items()):
            first = count + FRAME_FIELDS * index
            self.send_frame(stamp, parent, child, values[first:first + FRAME_FIELDS])

    def send_frame(self, stamp, parent, child, numbers):
        message = TransformStamped(child_frame_id=self.options.tf_prefix + child)
        message.header.stamp, message.header.frame_id = stamp, self.options.tf_prefix + parent
        message.transform.translation = Vector3(*numbers[:3])
        message.transform.rotation = Quaternion(*quaternion_from_rpy(*numbers[3:]))
        self.broadcaster.sendTransform(message)

    def hold(self, time, is_over):
        """Publishes the pose at `time` until `is_over` returns true, so that poses do not grow old."""
        rate = rospy.Rate(self.options.rate)
        while not rospy.is_shutdown() and not is_over():
            self.publish(time)
            rate.sleep()

    def wait_for(self, topic, patience):
        heard = []
        subscriber = rospy.Subscriber(topic, rospy.AnyMsg, heard.append, queue_size=1)
        deadline = rospy.Time.now() + rospy.Duration(patience)
        self.hold(0.0, lambda: heard or rospy.Time.now() > deadline)
        subscriber.unregister()
        if heard:  # lets the listener see the robot before it moves
            deadline = rospy.Time.now() + rospy.Duration(1.0)
            self.hold(0.0, lambda: rospy.Time.now() > deadline)
        elif not rospy.is_shutdown():
            rospy.logwarn("nothing came on %s within %.0f s; the path starts all the same", topic, patience)

    def play(self):
        if self.options.wait_for:
            self.wait_for(self.options.wait_for, self.options.patience)
        begin, rate = rospy.Time.now(), rospy.Rate(self.options.rate)
        while not rospy.is_shutdown():
            time = (rospy.Time.now() - begin).to_sec()
            over = time >= self.path.duration
            if over and self.options.loop:
                begin, time, over = rospy.Time.now(), 0.0, False
            self.publish(time)
            self.progress.publish(1.0 if over else time / self.path.duration)
            if over:
                break
            rate.sleep()
        if self.options.hold:
            self.hold(self.path.duration, lambda: False)


def read_options(arguments):
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="Publishes joint_states and ~progress (0 .. 1). For several robots, start one player each with "
               "__ns:=NAMESPACE and the prefixes below.")
    parser.add_argument("path", help="the YAML file")
    parser.add_argument("--check", action="store_true", help="only read the file and say what is wrong with it")
    parser.add_argument("--robot", metavar="URDF", help="make sure that the path fits this robot")
    parser.add_argument("--rate", type=float, default=50.0, help="messages a second (default %(default)s)")
    parser.add_argument("--loop", action="store_true", help="start again at the end, for ever")
    parser.add_argument("--hold", action="store_true", help="stay at the last way-point instead of ending")
    parser.add_argument("--wait-for", metavar="TOPIC", help="stay at the first way-point until a message comes")
    parser.add_argument("--patience", type=float, default=30.0, metavar="S", help="longest wait (default %(default)s)")
    parser.add_argument("--joint-prefix", default="", help="put before every joint name, e.g. left_")
    parser.add_argument("--tf-prefix", default="", help="put before the links of `floating`, e.g. left/")
    options = parser.parse_args(arguments)
    if not 0 < options.rate <= 1000:
        parser.error(f"--rate: found {options.rate:g}; accepted: more than 0, at most 1000")
    return options


def main():
    options = read_options(rospy.myargv()[1:])
    try:
        path = parse_path(read_regular_file(options.path), options.path)
        if options.loop:
            check_loop(path, options.path)
        if options.robot:
            check_robot(path, options.path, read_regular_file(options.robot), os.path.basename(options.robot))
    except (OSError, PathError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    if options.check:
        print(f"{options.path}: {len(path.times)} way-points, {len(path.joints)} joints, {path.duration:g} s")
        return 0
    rospy.init_node("play_joint_path")
    try:
        Player(path, options).play()
    except rospy.ROSInterruptException:
        pass
    return 0


if __name__ == "__main__":
    sys.exit(main())
