#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the monitor's sentence whenever the verdict of a pair of links changes."""
import rospy

from collision_monitor.msg import Warning as CollisionWarning

rospy.init_node("echo_warnings", anonymous=True)
rospy.Subscriber("/collision_monitor/warnings", CollisionWarning,
                 lambda warning: print(warning.sentence, flush=True))
rospy.spin()
