#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""The programs refuse what is no regular file at once, and Ctrl-C ends them and what they started.

COLLISION_MONITOR_FIT, COLLISION_MONITOR_PAIRS and COLLISION_MONITOR_COMPARE name the programs; ctest sets
those that are built.
"""
import functools
import glob
import http.server
import os
import pathlib
import signal
import subprocess
import tempfile
import threading
import time
import unittest

PROGRAMS = [os.environ["COLLISION_MONITOR_" + name] for name in ("FIT", "PAIRS", "COMPARE")
            if "COLLISION_MONITOR_" + name in os.environ]
HAS_ROS = "COLLISION_MONITOR_MONITOR" in os.environ
DEADLINE = 60.0
ROBOT = "<robot name='r'><link name='a'><collision><geometry><mesh filename='%s'/></geometry></collision></link></robot>"


class QuietHandler(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def busy_children_of(process):
    """Numbers of the processes that it started and that run at this moment."""
    found = []
    for path in glob.glob("/proc/[0-9]*/stat"):
        try:
            fields = pathlib.Path(path).read_text(encoding="utf-8").rpartition(")")[2].split()
        except OSError:
            continue
        if fields[1] == str(process) and fields[0] == "R":
            found.append(int(path.split("/")[2]))
    return found


def wait_for(look, what):
    """Returns what look() found: a second look may find less."""
    end = time.monotonic() + DEADLINE
    while True:
        found = look()
        if found:
            return found
        if time.monotonic() > end:
            raise AssertionError("waited for " + what)
        time.sleep(0.01)


@unittest.skipUnless(PROGRAMS, "the environment names no programs")
class OddFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.urdf = self.folder / "robot.urdf"

    def test_pipes_are_refused(self):
        pipe = self.folder / "pipe.stl"
        os.mkfifo(pipe)
        self.urdf.write_text(ROBOT % "pipe.stl", encoding="utf-8")
        for program in PROGRAMS:
            for robot in (self.urdf, pipe):
                ended = subprocess.run([program, robot], capture_output=True, text=True, timeout=DEADLINE, check=False)
                self.assertIn("is a pipe (FIFO), not a regular file", ended.stderr)
                self.assertNotEqual(ended.returncode, 0)

    def test_standard_input_without_end_is_refused(self):
        for program in PROGRAMS[:2]:
            with subprocess.Popen(["yes", "<a>"], stdout=subprocess.PIPE) as endless:
                self.addCleanup(endless.kill)
                ended = subprocess.run([program, "-"], stdin=endless.stdout, capture_output=True, text=True,
                                       timeout=DEADLINE, check=False)
                endless.kill()
            self.assertEqual(ended.returncode, 1, ended.stderr)
            self.assertIn("standard input is larger than the limit of 200000000 bytes", ended.stderr)
            self.assertIn("files/max_size", ended.stderr)

    def test_mesh_that_is_a_pipe_in_a_package_root_is_refused(self):
        os.mkfifo(self.folder / "package.xml")
        self.urdf.write_text(ROBOT % "package://p/a.stl", encoding="utf-8")
        ended = subprocess.run([PROGRAMS[0], self.urdf, "--package-root", self.folder], capture_output=True,
                               text=True, timeout=DEADLINE, check=False)
        self.assertEqual(ended.returncode, 1, ended.stderr)

    @unittest.skipUnless(HAS_ROS, "built without ROS, no program fetches files")
    def test_schemes_must_be_allowed(self):
        self.urdf.write_text(ROBOT % "http://127.0.0.1:1/a.stl", encoding="utf-8")
        for program in PROGRAMS[:2]:
            for arguments, text in (([], "has the scheme 'http'"), (["--scheme", "http"], "127.0.0.1:1")):
                ended = subprocess.run([program, self.urdf, *arguments], capture_output=True, text=True,
                                       timeout=DEADLINE, check=False)
                self.assertIn(text, ended.stderr)
                self.assertEqual("has the scheme" in ended.stderr, not arguments)

    @unittest.skipUnless(HAS_ROS, "built without ROS, no program fetches files")
    def test_page_in_place_of_a_file_is_told(self):
        handler = functools.partial(QuietHandler, directory=str(self.folder))
        with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
            threading.Thread(target=server.serve_forever, daemon=True).start()
            self.urdf.write_text(ROBOT % f"http://127.0.0.1:{server.server_port}/missing.stl", encoding="utf-8")
            ended = subprocess.run([PROGRAMS[0], self.urdf, "--scheme", "http"], capture_output=True, text=True,
                                   timeout=DEADLINE, check=False)
            server.shutdown()
        self.assertEqual(ended.returncode, 1, ended.stderr)
        self.assertIn("the server answers with a web page", ended.stderr)

    def test_ctrl_c_ends_a_program_and_its_reader(self):
        count = 300000
        with open(self.folder / "polygon.obj", "w", encoding="utf-8") as file:  # its face takes many minutes
            file.writelines("v %d %d 0\n" % (i, i * 7919 % 1000) for i in range(count))
            file.write("f " + " ".join(str(i + 1) for i in range(count)) + "\n")
        self.urdf.write_text(ROBOT % "polygon.obj", encoding="utf-8")
        for program in PROGRAMS:
            # Scripts start what runs in the background with SIGINT ignored, and children inherit it.
            with subprocess.Popen([program, self.urdf], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                  preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)) as process:
                self.addCleanup(process.kill)
                reader = wait_for(lambda: busy_children_of(process.pid), "the reader of " + program)[0]
                process.send_signal(signal.SIGINT)
                self.assertEqual(process.wait(timeout=DEADLINE), -signal.SIGINT)
                wait_for(lambda: not os.path.exists("/proc/%d" % reader), "the end of the reader of " + program)


if __name__ == "__main__":
    unittest.main()
