// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot_lists.h"

#include <pybind11/numpy.h>

#include <algorithm>
#include <string>

#include "collision_monitor/model/pair_rules.h"
#include "failures.h"
#include "model/object_links.h"

namespace collision_monitor::python {
namespace {

namespace py = pybind11;

/// "1 link", "2 links"
std::string counted(std::ptrdiff_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string robotText(const Robot& robot) {
  const RobotModel& model = robot.monitor().model();
  std::string names;
  std::ptrdiff_t robots = 0;
  for (const auto& one : model.robots) {
    if (!one.is_world) {
      names += (names.empty() ? "" : ", ") + one.tf_prefix + (one.tf_prefix.empty() ? "" : "/") +
               one.name;
      ++robots;
    }
  }
  std::ptrdiff_t links = 0;
  std::ptrdiff_t objects = 0;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const bool is_object = isObject(model, idAt<LinkId>(i));
    objects += is_object ? 1 : 0;
    links += !is_object && hasShapes(model.links[i]) ? 1 : 0;
  }
  return (robots == 1 ? "Robot " : "Robots ") + names + ": " + counted(links, "link") +
         " with shapes, " + (objects == 0 ? "" : counted(objects, "object") + ", ") +
         counted(static_cast<std::ptrdiff_t>(model.variable_count), "variable") + ", " +
         counted(static_cast<std::ptrdiff_t>(robot.monitor().pairs().size()), "pair");
}

py::list variables(const Robot& self) {
  py::list rows;
  const py::object variable = pythonClass("records", "Variable");
  for (const JointVariable& each : self.monitor().variables()) {
    rows.append(variable(text(each.name), each.lower, each.upper, each.max_velocity));
  }
  return rows;
}

/// A number of each variable, in an array.
template <class Field>
auto ofVariables(const Field& field) {
  return [field](const Robot& self) {
    const std::vector<JointVariable>& all = self.monitor().variables();
    py::array_t<double> numbers(static_cast<py::ssize_t>(all.size()));
    std::transform(all.begin(), all.end(), numbers.mutable_data(), field);
    return numbers;
  };
}

py::list pairs(const Robot& self) {
  py::list rows;
  for (const CheckedLinkPair& pair : self.monitor().pairs()) {
    rows.append(py::make_tuple(text(self.nameOfLink(pair.a)), text(self.nameOfLink(pair.b))));
  }
  return rows;
}

py::list allPairs(const Robot& self) {
  py::list rows;
  const py::object link_pair = pythonClass("records", "LinkPair");
  for (const LinkPair& pair : self.monitor().allPairs()) {
    rows.append(link_pair(text(self.nameOfLink(pair.a)), text(self.nameOfLink(pair.b)),
                          isChecked(pair.reason), reasonText(pair.reason)));
  }
  return rows;
}

py::list shapes(const Robot& self) {
  py::list rows;
  const py::object enclosing_shape = pythonClass("records", "EnclosingShape");
  for (const EnclosingShape& each : self.monitor().shapes()) {
    const Eigen::Vector3d half_extents = coreHalfExtents(each.shape);
    py::array_t<double> pose({4, 4});
    writePose(each.link_from_shape, pose.mutable_data());
    rows.append(enclosing_shape(text(self.nameOfLink(each.link)), text(each.name),
                                kindName(each.shape), py::array_t<double>(3, half_extents.data()),
                                radiusOf(each.shape), pose, each.overshoot.max, each.overshoot.mean,
                                each.is_exact, each.is_proven));
  }
  return rows;
}

py::list warnings(const Robot& self) {
  py::list rows;
  const py::object problem = pythonClass("errors", "Problem");
  for (const Problem& each : self.monitor().warnings()) {
    rows.append(
        problem(text(each.where), text(each.found), text(each.accepted), text(each.advice)));
  }
  return rows;
}

py::list links(const Robot& self) {
  py::list names;
  for (const Link& link : self.monitor().model().links) {
    names.append(text(link.name));
  }
  return names;
}

}  // namespace

void writePose(const Pose& pose, double* rows) {
  Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> matrix(rows);
  matrix.setIdentity();
  matrix.topLeftCorner<3, 3>() = pose.rotation;
  matrix.topRightCorner<3, 1>() = pose.translation;
}

void addLists(py::class_<Robot, SharedRobot>& type) {
  type.def("__repr__", [](const Robot& self) { return text(robotText(self)); });

  type.def_property_readonly("variables", variables,
                             "The n numbers of a state, in order: Variable(name, lower, upper, "
                             "max_velocity).")
      .def_property_readonly("lower",
                             ofVariables([](const JointVariable& each) { return each.lower; }),
                             "(n,) [rad] or [m]; -inf where unlimited.")
      .def_property_readonly("upper",
                             ofVariables([](const JointVariable& each) { return each.upper; }),
                             "(n,) [rad] or [m]; inf where unlimited.")
      .def_property_readonly(
          "default_state",
          [](const Robot& self) {
            const JointPositions& state = self.monitor().defaultState();
            return py::array_t<double>(static_cast<py::ssize_t>(state.size()), state.data());
          },
          "(n,) Zeros as far as limits allow.")
      .def_property_readonly("links", links, "Names of all links, in the order of link_poses.")
      .def_property_readonly("pairs", pairs, "Names of links A and B of each pair that is checked.")
      .def_property_readonly("all_pairs", allPairs,
                             "LinkPair(link_a, link_b, is_checked, reason) of all links with "
                             "shapes.")
      .def_property_readonly("shapes", shapes, "The EnclosingShapes of all links.")
      .def_property_readonly("warnings", warnings,
                             "Problem(where, found, accepted, advice) that did not stop loading.")
      .def_property_readonly(
          "contact_distance",
          [](const Robot& self) { return self.monitor().limits().contact_distance; },
          "[m] At or below: contact.")
      .def_property_readonly(
          "warning_distance",
          [](const Robot& self) { return self.monitor().limits().warning_distance; },
          "[m] At or below: warning.");
}

}  // namespace collision_monitor::python
