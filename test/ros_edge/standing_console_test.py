#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""A console that nobody reads, as a terminal that was stopped by ctrl-S, holds up no cycle and no change."""
import fcntl
import os
import signal
import subprocess
import sys
import unittest

import rospy
import rostest
from std_srvs.srv import SetBool

from collision_monitor.srv import SetPairs
from monitor_probe import DEADLINE, Probe

NAME = "/unread"
BYTES = 4096  # of the pipe
TIMES = 150  # each makes two lines of 40 bytes or more: three times what the pipe takes


class StandingConsole(unittest.TestCase):

    def setUp(self):
        read, write = os.pipe()
        self.addCleanup(os.close, read)
        fcntl.fcntl(write, fcntl.F_SETPIPE_SZ, BYTES)
        self.process = subprocess.Popen(["rosrun", "collision_monitor", "monitor", "__name:=" + NAME[1:]],
                                        stdin=subprocess.DEVNULL, stdout=write, stderr=write)
        os.close(write)
        self.addCleanup(self.process.wait)
        self.addCleanup(self.process.kill)

    def test_linesOfTheCycle_whenNobodyReadsThem_cyclesAndChangesGoOn(self):
        probe = Probe(NAME)
        rospy.wait_for_service(NAME + "/set_enabled", timeout=DEADLINE)
        set_enabled = rospy.ServiceProxy(NAME + "/set_enabled", SetBool)
        for i in range(2 * TIMES):
            is_enabled = i % 2 == 1
            set_enabled(is_enabled)
            probe.wait(lambda: probe.state is not None and bool(probe.state.enabled) == is_enabled,
                       "the monitor to be switched for the %d. time" % (i + 1))
        for rules, duration in (("[]", 0.0), ("[{a: '*', b: '*', check: false}]", 0.2)):
            answer = rospy.ServiceProxy(NAME + "/set_pairs", SetPairs)(rules, 0, duration)
            self.assertTrue(answer.success, answer.message)
        probe.wait(lambda: probe.state.pairs_muted > 0, "the mute")
        probe.wait(lambda: probe.state.pairs_muted == 0, "the mute to end")
        self.process.send_signal(signal.SIGINT)
        self.assertEqual(self.process.wait(DEADLINE), 0)


if __name__ == "__main__":
    rospy.init_node("standing_console_test")
    rostest.rosrun("collision_monitor", "standing_console", StandingConsole, sys.argv)
