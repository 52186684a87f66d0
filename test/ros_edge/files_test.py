#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that crash or hang who reads them are errors, at start and in a reload, and the monitor
that runs goes on; Ctrl-C ends every stage of the set-up."""
import glob
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import rospy
import rostest
from std_srvs.srv import Trigger

from monitor_probe import DEADLINE, Probe

LINK = """<link name="%s"><collision><geometry>%s</geometry></collision></link>"""
DAE = """<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset/>
<library_geometries><geometry id="g"><mesh><source id="p">
<float_array id="a" count="%s">0 0 0 1 0 0 0 1 0</float_array><technique_common>
<accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y"
type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="1"><input
semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>
</library_geometries><library_visual_scenes><visual_scene id="s">%s</visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>"""
INSTANCE = '<instance_geometry url="#g"/>'
# Doubled thirty times, a node fills any memory.
DOUBLED = "".join('<node id="n%d"><instance_node url="#n%d"/><instance_node url="#n%d"/></node>'
                  % (i, i + 1, i + 1) for i in range(30)) + '<node id="n30">%s</node>' % INSTANCE
ANGLE = "package://collision_monitor/test/data/angle.stl"


def robot(geometries):
    """A chain of floating links with a geometry each."""
    names = ["link_%d" % i for i in range(len(geometries))]
    joints = ['<joint name="j_%s" type="floating"><parent link="%s"/><child link="%s"/></joint>'
              % (b, a, b) for a, b in zip(names, names[1:])]
    return "<robot name='r'>%s</robot>" % "".join(
        [LINK % pair for pair in zip(names, geometries)] + joints)


def mesh(name, scale="1 1 1"):
    return '<mesh filename="%s" scale="%s"/>' % (name, scale)


GOOD = robot(['<sphere radius="0.1"/>', '<sphere radius="0.2"/>'])


def long_polygon():
    """An OBJ whose one face takes many minutes."""
    lines = ["v %d %d 0" % (i, i * 7919 % 1000) for i in range(300000)]
    return "\n".join(lines) + "\nf " + " ".join(str(i + 1) for i in range(300000)) + "\n"


class SilentServer:
    """Takes connections and says nothing."""

    def __init__(self):
        self.socket = socket.create_server(("127.0.0.1", 0))
        self.root = "http://127.0.0.1:%d/" % self.socket.getsockname()[1]
        self.is_asked = threading.Event()
        self.open = []
        threading.Thread(target=self._serve, daemon=True).start()

    def _serve(self):
        while True:
            self.open.append(self.socket.accept())
            self.is_asked.set()


class Node:
    """A monitor with these private parameters."""

    def __init__(self, name, urdf=None, **parameters):
        self.name = "/" + name
        for key, value in dict({"fit_cache": "none"}, **parameters).items():
            rospy.set_param(self.name + "/" + key, value)
        if urdf is not None:
            rospy.set_param(self.name + "/robot_description", urdf)
        self.output = tempfile.TemporaryFile(mode="w+")
        self.process = subprocess.Popen(
            ["rosrun", "collision_monitor", "monitor", "__name:=" + name],
            stdin=subprocess.DEVNULL, stdout=self.output, stderr=subprocess.STDOUT,
            env=dict(os.environ, ROSCONSOLE_STDOUT_LINE_BUFFERED="1"))

    def text(self):
        self.output.seek(0)
        return self.output.read()

    def wait_until(self, predicate, what):
        end = time.monotonic() + DEADLINE
        while not predicate():
            if time.monotonic() > end or self.process.poll() is not None:
                raise AssertionError("waited for %s; it said: %s" % (what, self.text()))
            time.sleep(0.01)

    def helpers(self):
        """Names of the programs that it runs."""
        names = []
        for path in glob.glob("/proc/[0-9]*/status"):
            try:
                with open(path, encoding="utf-8") as status:
                    fields = dict(line.rstrip("\n").split(":\t", 1) for line in status
                                  if ":\t" in line)
            except OSError:
                continue
            if fields.get("PPid") == str(self.process.pid):
                names.append((fields["Name"], fields["State"]))
        return names

    def reload(self):
        rospy.wait_for_service(self.name + "/reload", timeout=DEADLINE)
        return rospy.ServiceProxy(self.name + "/reload", Trigger)()

    def end(self):
        """Exit code after Ctrl-C."""
        self.process.send_signal(signal.SIGINT)
        return self.process.wait(timeout=DEADLINE)


class FilesTest(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.nodes = []
        self.addCleanup(self.kill_nodes)

    def kill_nodes(self):
        for node in self.nodes:
            if node.process.poll() is None:
                node.process.kill()
                node.process.wait()

    def start(self, *arguments, **parameters):
        self.nodes.append(Node(*arguments, **parameters))
        return self.nodes[-1]

    def path(self, name, text=None):
        path = os.path.join(self.folder, name)
        if text is not None:
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        return path

    def bad_robot(self):
        """Its URDF, and what an error has to say of each of its meshes."""
        faults = {
            self.path("count.dae", DAE % ("-1", "<node>%s</node>" % INSTANCE)): "count '-1'",
            self.path("itself.dae", DAE % (
                "9", '<node id="n">%s<instance_node url="#n"/></node>' % INSTANCE)):
            "instances itself",
            self.path("nested.dae", DAE % (
                "9", "<node>" * 10000 + INSTANCE + "</node>" * 10000)): "nest deeper",
            self.path("doubled.dae", DAE % ("9", DOUBLED)): "needs more memory",
            self.path("pipe.stl"): "is a pipe (FIFO)",
            self.path("folder.stl"): "is a folder",
            "/dev/zero.stl": "cannot be read",
            "http://127.0.0.1/a.stl": "has the scheme 'http'"}
        os.mkfifo(self.path("pipe.stl"))
        os.mkdir(self.path("folder.stl"))
        return robot([mesh(name) for name in faults]), faults

    def check_names_all(self, faults, text):
        for name, fault in faults.items():
            line = [line for line in text.splitlines() if "'%s'" % name in line]
            self.assertEqual(len(line), 1, name + " in " + text)
            self.assertIn(fault, line[0])

    def test_badMeshesAtStart_areAllNamed(self):
        urdf, faults = self.bad_robot()
        node = self.start("bad_start", urdf, files={"mesh_memory": 1e8})
        self.assertEqual(node.process.wait(timeout=60), 1, node.text())
        self.check_names_all(faults, node.text())

    def test_badMeshesInAReload_theMonitorGoesOn(self):
        node = self.start("reloaded", GOOD, files={"mesh_memory": 1e8})
        probe = Probe(node.name)
        probe.wait(lambda: probe.state is not None, "a state")
        urdf, faults = self.bad_robot()
        rospy.set_param(node.name + "/robot_description", urdf)
        answer = node.reload()
        self.assertFalse(answer.success)
        self.check_names_all(faults, answer.message)
        count = probe.state_count
        probe.wait(lambda: probe.state_count > count, "another state")
        self.assertEqual(node.helpers(), [], "no process is left")
        rospy.set_param(node.name + "/robot_description",
                        GOOD.replace('"0.1"', '"0.3"'))
        self.assertTrue(node.reload().success)
        self.assertEqual(node.end(), 0)

    def test_robotAndRulesInPipes_areErrors(self):
        pipe = self.path("pipe")
        os.mkfifo(pipe)
        node = self.start("pipes", shape_rules=pipe,
                          robots=[{"file": pipe, "semantic_file": pipe}])
        self.assertEqual(node.process.wait(timeout=60), 1, node.text())
        self.assertEqual(node.text().count("is a pipe (FIFO)"), 3, node.text())

    def test_silentServer_reloadsFailInTime_laterOnesDoNot(self):
        server = SilentServer()
        node = self.start("silent", GOOD, files={"schemes": ["http"], "download_time": 0.5})
        names = [server.root + "a.stl", server.root + "b.stl"]
        rospy.wait_for_service(node.name + "/reload", timeout=DEADLINE)
        rospy.set_param(node.name + "/robot_description", robot([mesh(name) for name in names]))
        for _ in range(2):
            answer = node.reload()
            self.assertFalse(answer.success)
            self.check_names_all(dict.fromkeys(names, "not read within the limit of 0.5 s"),
                                 answer.message)
        rospy.set_param(node.name + "/robot_description", GOOD)
        self.assertTrue(node.reload().success)
        self.assertEqual(node.end(), 0)

    def test_ctrlC_endsTheWaitForADescription(self):
        node = self.start("waits", wait_for_description=1e5)
        node.wait_until(lambda: self.is_known(node), "the node")
        self.assertEqual(node.end(), 0, node.text())

    @staticmethod
    def is_known(node):
        """Whether the master knows the node, which it does before it waits."""
        try:
            return bool(rospy.get_master().lookupNode(node.name)[2])
        except (OSError, rospy.ROSException):
            return False

    def test_ctrlC_endsADownload_atStartAndInAReload(self):
        server = SilentServer()
        files = {"schemes": ["http"], "download_time": 1e5}
        node = self.start("loads", robot([mesh(server.root + "a.stl")]), files=files)
        node.wait_until(server.is_asked.is_set, "the download")
        self.assertEqual(node.end(), 0, node.text())

        server = SilentServer()
        node = self.start("reloads", GOOD, files=files)
        rospy.wait_for_service(node.name + "/reload", timeout=DEADLINE)
        rospy.set_param(node.name + "/robot_description", robot([mesh(server.root + "a.stl")]))
        threading.Thread(target=self.reload_quietly, args=(node,), daemon=True).start()
        node.wait_until(server.is_asked.is_set, "the download")
        self.assertEqual(node.end(), 0, node.text())

    @staticmethod
    def reload_quietly(node):
        try:
            node.reload()
        except rospy.ServiceException:
            pass  # the node ends meanwhile

    def test_ctrlC_endsTheReadingOfAMesh(self):
        node = self.start("reads", robot([mesh(self.path("polygon.obj", long_polygon()))]),
                          files={"mesh_time": 1e5})
        node.wait_until(lambda: ("read_meshes", "R (running)") in node.helpers(), "the reader")
        self.assertEqual(node.end(), 0, node.text())

    def test_ctrlC_endsFitting(self):
        scales = ["1 1 %g" % (1.0 + 0.001 * i) for i in range(2000)]
        node = self.start("fits", robot([mesh(ANGLE, scale) for scale in scales]))
        node.wait_until(lambda: "fitting shapes to link" in node.text(), "fitting")
        self.assertEqual(node.end(), 0, node.text())


if __name__ == "__main__":
    rospy.init_node("files_test")
    rostest.rosrun("collision_monitor", "files", FilesTest, sys.argv)
