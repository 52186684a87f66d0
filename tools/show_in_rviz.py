#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Waits for the monitor, then becomes rviz with the monitor's world frame as the fixed frame.

Only the monitor knows that frame: by default it is the root link of the robot's URDF. With --frame, this
program does not wait. It passes ROS's own NAME:=VALUE on to rviz.
"""
import argparse
import os
import sys

import rospy

from collision_monitor.msg import State

PATIENCE = 10.0  # [s] wall time between two lines in the log


def wait_for_frame(topic):
    """@return the frame of the monitor's results; None if ROS shuts down."""
    while not rospy.is_shutdown():
        try:
            return rospy.wait_for_message(topic, State, timeout=PATIENCE).header.frame_id
        except rospy.ROSException:
            if not rospy.is_shutdown():
                rospy.logwarn("nothing on %s yet; rviz starts when the monitor does", topic)
    return None


def frame_of_monitor(name):
    rospy.init_node("show_in_rviz")
    frame = wait_for_frame(rospy.resolve_name(name + "/state"))
    rospy.signal_shutdown("rviz takes its place")  # including its name
    return frame


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("config", help="rviz's file")
    parser.add_argument("--monitor", default="/collision_monitor", help="the monitor (default %(default)s)")
    parser.add_argument("--frame", help="the fixed frame, instead of the monitor's")
    options = parser.parse_args(rospy.myargv()[1:])
    frame = options.frame or frame_of_monitor(options.monitor)
    if frame is None:
        return 0
    names = [argument for argument in sys.argv[1:] if ":=" in argument]
    try:
        os.execvp("rviz", ["rviz", "-d", options.config, "-f", frame, *names])
    except FileNotFoundError:
        print("error: rviz is not installed; it is in the package rviz (Debian) or ros-noetic-rviz", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"error: rviz cannot be started: {error.strerror}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
