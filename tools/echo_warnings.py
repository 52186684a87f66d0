#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the monitor's sentence whenever the verdict of a pair of links changes."""
import argparse
import sys

import rospy

from collision_monitor.msg import PairWarning


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--monitor", default="/collision_monitor", help="the monitor (default %(default)s)")
    options = parser.parse_args(rospy.myargv()[1:])
    rospy.init_node("echo_warnings", anonymous=True)
    rospy.Subscriber(options.monitor + "/warnings", PairWarning,
                     lambda warning: print(warning.sentence, flush=True))
    rospy.spin()
    return 0


if __name__ == "__main__":
    sys.exit(main())
