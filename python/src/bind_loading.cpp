// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include <array>

#include "collision_monitor/arguments.h"
#include "failures.h"
#include "interruptible_work.h"
#include "numbers.h"
#include "robot.h"

namespace collision_monitor::python {
namespace {

namespace py = pybind11;

RefineGeometry detailOf(const std::string& name) {
  if (name == "mesh") {
    return RefineGeometry::mesh;
  }
  if (name == "hull") {
    return RefineGeometry::hull;
  }
  if (name == "none") {
    return RefineGeometry::none;
  }
  throw ArgumentError({"`detail` is '" + name + "'; accepted: 'mesh', 'hull', 'none'"});
}

std::vector<NamedPair> namedPairs(const std::vector<std::pair<std::string, std::string>>& names) {
  std::vector<NamedPair> pairs;
  for (const auto& [a, b] : names) {
    pairs.push_back({a, b});
  }
  return pairs;
}

std::vector<Pose> rootPoses(const py::list& given) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < given.size(); ++i) {
    poses.push_back(readPose(given[i], "world_from_root[" + std::to_string(i) + "]"));
  }
  return poses;
}

DocumentText documentOf(const py::dict& given, const std::string& name) {
  return {given[(name + "_source").c_str()].cast<std::string>(),
          given[name.c_str()].cast<std::string>(), ""};
}

MonitorOptions readOptions(const py::dict& given) {
  MonitorOptions options;
  options.limits.contact_distance = given["contact_distance"].cast<double>();
  options.limits.warning_distance = given["warning_distance"].cast<double>();
  options.detail = detailOf(given["detail"].cast<std::string>());
  options.distance_tolerance = given["distance_tolerance"].cast<double>();
  options.padding = given["padding"].cast<double>();
  options.fit.max_shapes = given["max_shapes"].cast<std::uint32_t>();
  options.fit.target_overshoot = given["target_overshoot"].cast<double>();
  options.shape_rules = documentOf(given, "rules");
  options.pair_rules = documentOf(given, "pair_rules");
  options.world = documentOf(given, "world");
  options.ignored_pairs =
      namedPairs(given["ignored_pairs"].cast<std::vector<std::pair<std::string, std::string>>>());
  options.ignore_default_overlap = given["ignore_default_overlap"].cast<bool>();
  for (const std::string& root : given["packages"].cast<std::vector<std::string>>()) {
    options.package_roots.emplace_back(root);
  }
  options.fit_cache = given["fit_cache"].cast<std::string>();
  options.world_from_root = rootPoses(given["world_from_root"].cast<py::list>());
  return options;
}

SharedRobot loadFiles(const std::vector<std::array<std::string, 3>>& files, const py::dict& given) {
  std::vector<RobotFiles> robots;
  for (const auto& [urdf, srdf, prefix] : files) {
    robots.push_back({urdf, srdf, prefix});
  }
  const MonitorOptions options = readOptions(given);
  return runInterruptibly(
      [&] { return std::make_shared<Robot>(RobotMonitor::fromFiles(robots, options)); });
}

SharedRobot loadTexts(const std::vector<std::array<std::string, 3>>& texts,
                      const std::string& directory, const py::dict& given) {
  std::vector<RobotDescription> robots;
  for (const auto& [urdf, srdf, prefix] : texts) {
    RobotDescription robot;
    robot.source = "URDF";
    robot.urdf_xml = urdf;
    robot.srdf_xml = srdf;
    robot.tf_prefix = prefix;
    robot.directory = directory;
    robots.push_back(robot);
  }
  const MonitorOptions options = readOptions(given);
  return runInterruptibly([&] { return std::make_shared<Robot>(RobotMonitor(robots, options)); });
}

SharedRobot withWorld(const Robot& robot, const py::dict& given) {
  const DocumentText world = documentOf(given, "world");
  return runInterruptibly(
      [&] { return std::make_shared<Robot>(robot.monitor().withWorld(world)); });
}

}  // namespace

void bindLoading(py::module_& module) {
  module.def("load_files", loadFiles, py::arg("robots"), py::arg("options"),
             "What load() calls, with checked arguments.");
  module.def("load_texts", loadTexts, py::arg("robots"), py::arg("directory"), py::arg("options"),
             "What loads() calls, with checked arguments.");
  module.def("with_world", withWorld, py::arg("robot"), py::arg("world"),
             "What Robot.with_world() calls, with checked arguments.");
}

}  // namespace collision_monitor::python
