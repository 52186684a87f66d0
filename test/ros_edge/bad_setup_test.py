#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""A set-up that cannot be used ends the node with every problem named; a nodelet that has one
leaves its manager alive."""
import pathlib
import subprocess
import sys
import unittest

import rosgraph
import rospy
import rostest
from nodelet.srv import NodeletList, NodeletLoad
from std_msgs.msg import Float64

from collision_monitor.msg import State
from monitor_probe import Probe

GOOD = """<robot name="good">
  <link name="base"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  <joint name="a" type="fixed"><parent link="base"/><child link="middle"/></joint>
  <link name="middle"/>
</robot>"""
BAD = GOOD.replace('radius="0.1"', 'radius="-0.1"').replace('type="fixed"', 'type="elastic"')


def run(*command):
    """Exit code and output."""
    ended = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                           stderr=subprocess.STDOUT, timeout=60, universal_newlines=True,
                           check=False)
    return ended.returncode, ended.stdout


def run_node(name, urdf=None, remap=(), **parameters):
    """Exit code and output of a node with these private parameters."""
    namespace = "/" + name
    for key, value in dict(parameters, wait_for_description=0.2).items():
        rospy.set_param(namespace + "/" + key, value)
    if urdf is not None:
        rospy.set_param(namespace + "/robot_description", urdf)
    return run("rosrun", "collision_monitor", "monitor", "__name:=" + name, *remap)


class BadSetup(unittest.TestCase):

    def test_missingDescription_namesTheParameter(self):
        code, output = run_node("missing")
        self.assertEqual(code, 1, output)
        self.assertIn("/missing/robot_description", output)

    def test_missingDescriptionOfAnotherName_namesThatOne(self):
        code, output = run_node("renamed", remap=["robot_description:=/arm/robot_description"])
        self.assertEqual(code, 1, output)
        self.assertIn("parameter /arm/robot_description", output)

    def test_badNodeName_isTold(self):
        code, output = run_node("bad name")
        self.assertEqual(code, 2, output)
        self.assertIn("[bad name]", output)
        self.assertNotIn("terminate called", output)

    def test_namesOfRos_areNoUnknownArguments(self):
        code, output = run_node("plain", remap=["__log:=/tmp/plain.log", "joint_states:=/arm/joint_states"])
        self.assertEqual(code, 1, output)
        self.assertIn("/plain/robot_description", output)

    def test_programs_helpEndsWell_whatIsUnknownDoesNot(self):
        for name in ("monitor", "two_capsules", "echo_warnings.py", "play_joint_path.py", "demo_summary.py",
                     "show_in_rviz.py"):
            code, output = run("rosrun", "collision_monitor", name, "--help", "__name:=unheard")
            self.assertEqual(code, 0, name + output)
            self.assertIn("sage", output)
            for arguments in (["--frobnicate"], ["rate", "_rate:=5"]):
                if name in ("play_joint_path.py", "show_in_rviz.py"):
                    arguments = ["file", *arguments]
                code, output = run("rosrun", "collision_monitor", name, *arguments)
                self.assertEqual(code, 2, name + output)

    def test_rvizThatIsNotInstalled_isNamedWithItsPackage(self):
        states = rospy.Publisher("/painted/state", State, queue_size=1, latch=True)
        states.publish(State())
        script = pathlib.Path(__file__).resolve().parents[2] / "tools" / "show_in_rviz.py"
        for frame in (["--monitor", "/painted"], ["--frame", "world"]):
            code, output = run("env", "PATH=/nowhere", "/usr/bin/python3", str(script), "x.rviz", *frame)
            self.assertEqual(code, 1, output)
            self.assertIn("rviz is not installed; it is in the package", output)

    def test_summaryOfADemoThatShowedNothing_isNoUsageFault(self):
        """2 is the command line everywhere."""
        states = rospy.Publisher("/mute/state", State, queue_size=1)
        progress = rospy.Publisher("/mute/progress", Float64, queue_size=1)
        done = [1.0]

        def publish(_event):
            states.publish(State(level=State.UNKNOWN, sentence="nothing is known"))
            progress.publish(done[0])
        timer = rospy.Timer(rospy.Duration(0.05), publish)
        try:
            command = ["rosrun", "collision_monitor", "demo_summary.py", "--monitor", "/mute", "--player", "/mute",
                       "--patience"]
            code, output = run(*command, "20")
            self.assertIn("no distance was ever known", output)
            self.assertEqual(code, 1, output)
            done[0] = 0.5
            code, output = run(*command, "2")
            self.assertIn("the player did not move on", output)
            self.assertEqual(code, 1, output)
        finally:
            timer.shutdown()

    def test_arguments_everyFrameIsOne_whatIsNoBoolIsRefused(self):
        """roslaunch reads 7 as a number, and maybe as no bool."""
        code, output = run("roslaunch", "--dump-params", "collision_monitor", "monitor.launch",
                           "world_frame:=7")
        self.assertEqual(code, 0, output)
        self.assertIn("/collision_monitor/world_frame: '7'", output)
        _, output = run("roslaunch", "--dump-params", "collision_monitor", "demo.launch",
                        "loop:=maybe")
        self.assertIn("maybe is not a 'bool' type", output)  # the exit code is 0 all the same

    def test_scripts_areFoundByTheirNames(self):
        """rosrun asks which one where a second file of the name may be executed."""
        for name in ("echo_warnings.py", "play_joint_path.py", "demo_summary.py", "show_in_rviz.py"):
            _, output = run("rosrun", "--prefix", "echo", "collision_monitor", name)
            self.assertNotIn("non-unique", output)
            self.assertIn("lib/collision_monitor/" + name, output)

    def test_badUrdf_namesEveryProblem(self):
        code, output = run_node("bad_urdf", BAD)
        self.assertEqual(code, 1, output)
        self.assertIn("-0.1", output)
        self.assertIn("elastic", output)

    def test_badParameters_areAllNamed(self):
        code, output = run_node("bad_parameters", GOOD, rate=-3.0, max_aeg=0.2, padding="much")
        self.assertEqual(code, 1, output)
        for text in ("/bad_parameters/rate", "-3", "/bad_parameters/max_aeg", "'max_age'",
                     "/bad_parameters/padding", "'much'"):
            self.assertIn(text, output)

    def test_faultsOfAllStages_areNamedAtOnce_eachInOneLine(self):
        sphere = {"kind": "sphere", "radius": 0.1}
        world = [{"name": "table", "kind": "box", "size": [1.0, "x", 1.0]},
                 {"name": "table", "attach": "elbow", **sphere},
                 {"name": "lamp", "kind": "spear"},
                 {"name": "part", "touch_links": ["knee"], **sphere}]
        rules = [{"a": "lamp", "b": "*", "check": "maybe"},
                 {"a": "part", "b": "shin", "check": False},
                 {"a": "table", "b": "base", "chek": True}]
        faults = ["limits/warning_distance: -1 m", "link 'ankle', which matches none", "check 'maybe'", "'chek'",
                  "size [1, x, 1]", "object 'table': this name twice", "link 'elbow', which is unknown",
                  "kind 'spear'", "touch link 'knee', which is unknown", "link 'shin', which matches none"]
        parameters = {"world": world, "pair_rules": rules, "ignore_pairs": [["ankle", "base"]]}
        code, output = run_node("all_stages", GOOD, limits={"warning_distance": -1.0}, **parameters)
        self.assertEqual(code, 1, output)
        for fault in faults:
            self.assertIn(fault, output)
        self.assertIn("%d problems in the set-up" % len(faults), output)
        code, output = run_node("most_stages", GOOD, limits={}, **parameters)
        self.assertIn("%d problems in the set-up" % (len(faults) - 1), output)

    def test_noFaultOnlyFollowsFromAnother(self):
        rules = [{"a": "table", "b": "base", "check": False}, {"a": {"group": "cart"}, "b": "base", "check": False}]
        rospy.set_param("/follows_2/robot_description_semantic", "<robot")
        mesh = GOOD.replace('<sphere radius="0.1"/>', '<mesh filename="file:///nowhere.stl"/>')
        cases = [(1, GOOD, {"world_file": "/nowhere.yaml", "pair_rules": rules}),
                 (1, GOOD, {"world": [{"name": "lamp", "kind": "spear"}], "pair_rules": [dict(rules[0], a="lamp")]}),
                 (1, GOOD, {"pair_rules": rules[1:]}),  # the SRDF cannot be read
                 (1, GOOD, {"limits": {"contact_distance": 0.1, "warning_distance": "foo"}}),
                 (1, GOOD, {"ignore_pairs": [["base"]]}),
                 (2, mesh, {"ignore_pairs": [["base", "elbow"]]})]
        for i, (count, urdf, parameters) in enumerate(cases):
            code, output = run_node("follows_%d" % i, urdf, **parameters)
            self.assertEqual(code, 1, output)
            self.assertIn("%d problem%s in the set-up" % (count, "" if count == 1 else "s"), output)

    def test_semanticThatIsNoText_isRefused(self):
        rospy.set_param("/no_text/robot_description_semantic", 7)
        code, output = run_node("no_text", GOOD)
        self.assertEqual(code, 1, output)
        self.assertIn("no text in parameter /no_text/robot_description_semantic", output)

    def test_nodelet_namesAreRemappedAsThoseOfANode(self):
        rospy.wait_for_service("/manager/load_nodelet", timeout=20.0)
        rospy.set_param("/arm/robot_description", GOOD)
        names = ["robot_description", "joint_states"]
        rospy.ServiceProxy("/manager/load_nodelet", NodeletLoad)(
            "/remapped_nodelet", "collision_monitor/Monitor", names,
            ["/arm/" + name for name in names], [], "")
        probe = Probe("/remapped_nodelet")
        probe.wait_for_level(State.UNKNOWN, "no pair of links is checked")
        master = rosgraph.Master("/bad_setup_test")
        probe.wait(lambda: "/arm/joint_states" in dict(master.getSystemState()[1]),
                   "a subscriber of /arm/joint_states")

    def test_nodelets_badOneLeavesTheManagerAlive_goodOneSpeaks(self):
        rospy.wait_for_service("/manager/load_nodelet", timeout=20.0)
        load = rospy.ServiceProxy("/manager/load_nodelet", NodeletLoad)
        rospy.set_param("/bad_nodelet/wait_for_description", 0.2)
        rospy.set_param("/bad_nodelet/robot_description", BAD)
        load("/bad_nodelet", "collision_monitor/Monitor", [], [], [], "")
        rospy.set_param("/good_nodelet/robot_description", GOOD)
        load("/good_nodelet", "collision_monitor/Monitor", [], [], [], "")
        probe = Probe("/good_nodelet")
        probe.wait_for_level(State.UNKNOWN, "no pair of links is checked")
        names = rospy.ServiceProxy("/manager/list", NodeletList)().nodelets
        self.assertIn("/good_nodelet", names)


if __name__ == "__main__":
    rospy.init_node("bad_setup_test")
    rostest.rosrun("collision_monitor", "bad_setup", BadSetup, sys.argv)
