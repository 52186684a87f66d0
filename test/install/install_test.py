#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The collision_monitor authors
# SPDX-License-Identifier: BSD-3-Clause
"""What others use of an installed package: its library from C++ and Python, its programs, and with ROS
its node, nodelet, launch files and messages. Installs the build into a folder of its own.

COLLISION_MONITOR_BUILD is the build folder, COLLISION_MONITOR_SPACE where the built library can be used
from, COLLISION_MONITOR_CMAKE the program, COLLISION_MONITOR_HAS_ROS 1 or 0; ctest sets them. With
COLLISION_MONITOR_PREFIX, looks at what is installed there, as by catkin_make_isolated.
"""
import os
import pathlib
import shlex
import socket
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BUILD = os.environ.get("COLLISION_MONITOR_BUILD")
SPACE = os.environ.get("COLLISION_MONITOR_SPACE")
CMAKE = os.environ.get("COLLISION_MONITOR_CMAKE", "cmake")
PREFIX = os.environ.get("COLLISION_MONITOR_PREFIX")
HAS_ROS = os.environ.get("COLLISION_MONITOR_HAS_ROS") == "1"
FOUR_FACES = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
ROBOT = """<robot name="r"><link name="a"><collision><geometry><mesh filename="{}"/></geometry></collision>
</link></robot>"""
# The monitor alone and in a nodelet manager, both of one robot.
LAUNCH = """<launch>
  <param name="robot_description" textfile="$(find collision_monitor)/urdf/two_boxes.urdf"/>
  <include file="$(find collision_monitor)/launch/monitor.launch"><arg name="name" value="alone"/></include>
  <node name="manager" pkg="nodelet" type="nodelet" args="manager"/>
  <include file="$(find collision_monitor)/launch/monitor.launch">
    <arg name="name" value="within"/><arg name="manager" value="manager"/></include>
</launch>"""
HEAR_BOTH = """import rospy
from collision_monitor.msg import State
from collision_monitor.srv import CheckStates
rospy.init_node("hearer")
for name in ("alone", "within"):
    print(name, rospy.wait_for_message(f"/{name}/state", State, timeout=60).header.frame_id)
"""


def run(*command, environment=None):
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=300, check=False,
                          env=environment)


def plain_environment():
    """Without the workspaces of the one who runs the tests."""
    environment = dict(os.environ, PATH=os.path.dirname(sys.executable) + ":" + os.environ["PATH"])
    for name in ("CMAKE_PREFIX_PATH", "LD_LIBRARY_PATH", "ROS_PACKAGE_PATH", "PYTHONPATH"):
        environment.pop(name, None)
    return environment


def configured_prefix():
    cache = pathlib.Path(BUILD, "CMakeCache.txt").read_text()
    return pathlib.Path(next(line for line in cache.splitlines() if line.startswith("CMAKE_INSTALL_PREFIX:")
                             ).partition("=")[2])


@unittest.skipUnless(BUILD, "COLLISION_MONITOR_BUILD names no build")
class Install(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.folder = pathlib.Path(cls.scratch.name)
        cls.environment = plain_environment()
        cls.prefix = pathlib.Path(PREFIX) if PREFIX else cls.installed()
        (cls.folder / "four.obj").write_text(FOUR_FACES)
        cls.urdf = cls.folder / "robot.urdf"
        cls.urdf.write_text(ROBOT.format(cls.folder / "four.obj"))

    @classmethod
    def installed(cls):
        # catkin's setup files have the configured prefix in them: --prefix would not move them.
        done = run(CMAKE, "--install", BUILD, environment=dict(cls.environment, DESTDIR=str(cls.folder)))
        assert done.returncode == 0, done.stdout + done.stderr
        return cls.folder / configured_prefix().relative_to("/")

    def succeed(self, *command, environment=None):
        done = run(*command, environment=environment or self.environment)
        self.assertEqual(done.returncode, 0, f"{command}\n{done.stdout[-4000:]}{done.stderr[-4000:]}")
        return done.stdout

    def sourced(self, *command):
        """Runs a command as in a terminal where setup.bash of the installation was sourced."""
        words = " ".join(shlex.quote(str(word)) for word in command)
        return self.succeed("bash", "-c", f"source {self.prefix}/setup.bash && {words}")

    def built_by_user(self, source, *options):
        """Configures and builds another package, whose programs are then below the folder returned."""
        build = self.folder / f"build_{source}_{len(list(self.folder.iterdir()))}"
        self.succeed(CMAKE, "-S", HERE / source, "-B", build, f"-DPYTHON_EXECUTABLE={sys.executable}", *options)
        self.succeed(CMAKE, "--build", build)
        return build

    def counted_by(self, build):
        """What a user's program prints, which reads an OBJ by the helper."""
        program = next(path for path in build.rglob("count_triangles") if path.is_file())
        return self.succeed(program, self.urdf)

    def test_core_is_found_where_it_is_installed(self):
        build = self.built_by_user("core_user", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        self.assertEqual(self.counted_by(build), "4 triangles\n")
        said = self.succeed(build / "distances", ROOT / "urdf/two_boxes.urdf", "slide", -0.02,
                            environment=dict(self.environment, ROS_HOME=str(self.folder)))
        self.assertEqual(said, "box_a - box_b: 0.08 m\n")

    def test_core_is_found_where_it_is_built(self):
        build = self.built_by_user("core_user", f"-DCMAKE_PREFIX_PATH={SPACE}")
        self.assertEqual(self.counted_by(build), "4 triangles\n")

    def test_module_of_python_is_imported(self):
        module = next(self.prefix.rglob("collision_monitor_core/__init__.py"), None)
        if module is None:
            self.skipTest("built without the Python module")
        command = [sys.executable, "-c", f"""{'import collision_monitor.msg' if HAS_ROS else ''}
import collision_monitor_core as cm
print(cm.__file__, cm.load({str(self.urdf)!r}, fit_cache="none"))"""]
        if HAS_ROS:
            said = self.sourced(*command)
        else:
            said = self.succeed(*command, environment=dict(self.environment,
                                                           PYTHONPATH=str(module.parents[1])))
        self.assertRegex(said, f"^{module} Robot r: 1 link with shapes")

    def test_other_version_is_refused(self):
        other = self.folder / "other"
        other.mkdir()
        text = (HERE / "core_user/CMakeLists.txt").read_text()
        (other / "CMakeLists.txt").write_text(text.replace("_core 0.1", "_core 0.2"))
        done = run(CMAKE, "-S", other, "-B", other / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}",
                   environment=self.environment)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("0.1.0", done.stderr)

    def test_core_is_configured_as_a_subfolder(self):
        said = self.succeed(CMAKE, "-S", HERE / "core_user", "-B", self.folder / "build_subfolder",
                            f"-DCORE_SOURCE={ROOT}")
        self.assertIn("Building the core without ROS", said)

    def test_programs_run(self):
        where = "lib/collision_monitor/" if HAS_ROS else "bin/collision_monitor_"
        self.assertIn("all proven to enclose",
                      self.succeed(f"{self.prefix}/{where}fit", self.urdf, "--no-cache"))
        said = self.succeed(f"{self.prefix}/{where}pairs", ROOT / "urdf/two_boxes.urdf", "--no-cache", "--states", 10)
        self.assertIn("sometimes", said)

    @unittest.skipUnless(HAS_ROS, "built without ROS")
    def test_catkin_finds_library_and_messages(self):
        build = self.built_by_user("catkin_user", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        self.assertEqual(self.counted_by(build), "4 triangles\n")

    @unittest.skipUnless(HAS_ROS, "built without ROS")
    def test_node_and_nodelet_are_launched_and_heard_from_python(self):
        launch = self.folder / "both.launch"
        launch.write_text(LAUNCH)
        with socket.socket() as free:
            free.bind(("", 0))
            port = free.getsockname()[1]
        self.environment.update(ROS_MASTER_URI=f"http://localhost:{port}", ROS_HOSTNAME="localhost")
        hear = f"{shlex.quote(sys.executable)} -c {shlex.quote(HEAR_BOTH)}"
        heard = self.sourced("bash", "-c", f"""roslaunch -p {port} {launch} >{self.folder}/log 2>&1 & launched=$!
            {hear}; code=$?; kill -INT $launched; wait $launched; exit $code""")
        # rospy says on the same stream that the master is not there yet.
        self.assertEqual(heard.splitlines()[-2:], ["alone rail", "within rail"])

    @unittest.skipUnless(HAS_ROS, "built without ROS")
    def test_programs_are_found_by_rosrun(self):
        for program in ("monitor", "fit", "echo_warnings.py", "show_in_rviz.py", "play_joint_path.py"):
            self.assertIn("usage:", self.sourced("rosrun", "collision_monitor", program, "--help").lower())


if __name__ == "__main__":
    unittest.main()
