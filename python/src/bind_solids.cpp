// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>

#include <limits>

#include "collision_monitor/arguments.h"
#include "collision_monitor/solid.h"
#include "columns.h"
#include "enums.h"
#include "failures.h"
#include "given_number.h"
#include "interruptible_work.h"
#include "numbers.h"
#include "pair_answers.h"

namespace collision_monitor::python {
namespace {

namespace py = pybind11;

/// A solid, and what Python prints of it.
struct NamedSolid {
  Solid solid;
  std::string name;
};

/// The scratch of this thread: it keeps warm starts as long as the same two are asked about.
SolidQuery& queryHere() {
  thread_local SolidQuery query;
  return query;
}

std::vector<Eigen::Vector3d> readPoints(const py::object& given, const char* name) {
  const Array rows = readArray(given, name, "rows of 3 numbers");
  if (rows.ndim() != 2 || rows.shape(1) != 3) {
    throw ArgumentError({"`" + std::string(name) + "` has the shape " + shapeText(rows) +
                         "; accepted: rows of 3 numbers"});
  }
  std::vector<Eigen::Vector3d> points(static_cast<std::size_t>(rows.shape(0)));
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = Eigen::Map<const Eigen::Vector3d>(rows.data() + 3 * i);
  }
  return points;
}

std::uint32_t vertexOf(double number, std::size_t triangle, std::size_t vertices) {
  // Not by a cast first: a number out of range would be any vertex.
  if (!(number >= 0.0 && number < static_cast<double>(vertices)) ||
      number != static_cast<double>(static_cast<std::uint32_t>(number))) {
    throw ArgumentError({"triangles[" + std::to_string(triangle) + "] names vertex " +
                         numberText(number) + "; accepted: whole numbers from 0 to " +
                         std::to_string(vertices) + " - 1"});
  }
  return static_cast<std::uint32_t>(number);
}

NamedSolid meshOf(const py::object& vertices, const py::object& triangles) {
  TriangleMesh mesh;
  mesh.vertices = readPoints(vertices, "vertices");
  const std::vector<Eigen::Vector3d> corners = readPoints(triangles, "triangles");
  mesh.triangles.resize(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      mesh.triangles[i][k] =
          vertexOf(corners[i][static_cast<Eigen::Index>(k)], i, mesh.vertices.size());
    }
  }
  const std::string name = "mesh of " + countText(corners.size(), "triangle");
  return {runInterruptibly([&] { return Solid::mesh(mesh); }), name};
}

NamedSolid hullOf(const py::object& points) {
  const std::vector<Eigen::Vector3d> corners = readPoints(points, "points");
  const py::gil_scoped_release no_gil;
  return {Solid::hull(corners), "hull of " + countText(corners.size(), "point")};
}

Eigen::Vector3d threeOf(const py::object& given, const char* name, bool may_be_one) {
  const std::string accepted = may_be_one ? "one number, or three" : "three numbers";
  const Array numbers = readArray(given, name, accepted);
  if (may_be_one && numbers.ndim() == 0) {
    return Eigen::Vector3d::Constant(*numbers.data());
  }
  if (numbers.ndim() != 1 || numbers.shape(0) != 3) {
    throw ArgumentError({"`" + std::string(name) + "` has the shape " + shapeText(numbers) +
                         "; accepted: " + accepted});
  }
  return Eigen::Map<const Eigen::Vector3d>(numbers.data());
}

std::string readPath(const py::object& given) {
  std::string path;
  try {
    path = py::module_::import("os").attr("fsencode")(given).cast<std::string>();
  } catch (const py::error_already_set&) {
  }
  if (path.empty() || path.find('\0') != std::string::npos) {
    throw ArgumentError({"`file` is no path; accepted: the path of a mesh file"});
  }
  return path;
}

NamedSolid meshInFile(const py::object& file, const py::object& scale) {
  const std::string path = readPath(file);
  const Eigen::Vector3d factors = threeOf(scale, "scale", true);
  return {runInterruptibly([&] { return Solid::mesh(std::filesystem::path(path), factors); }),
          "mesh of " + path};
}

std::string lengthsText(const char* kind, double radius, double length) {
  return std::string(kind) + " of radius " + numberText(radius) + " m, length " +
         numberText(length) + " m";
}

NamedSolid boxOf(const py::object& size) {
  const Eigen::Vector3d lengths = threeOf(size, "size", false);
  return {Solid::box(lengths), "box of " + numberText(lengths.x()) + " x " +
                                   numberText(lengths.y()) + " x " + numberText(lengths.z()) +
                                   " m"};
}

SolidDistance distance(const NamedSolid& a, const py::object& pose_a, const NamedSolid& b,
                       const py::object& pose_b, const GivenNumber& within) {
  const Pose world_from_a = readPose(pose_a, "world_from_a");
  const Pose world_from_b = readPose(pose_b, "world_from_b");
  const double reach = numberOf(within, "within");
  const py::gil_scoped_release no_gil;
  return queryHere().distance(a.solid, world_from_a, b.solid, world_from_b, reach);
}

bool collide(const NamedSolid& a, const py::object& pose_a, const NamedSolid& b,
             const py::object& pose_b) {
  const Pose world_from_a = readPose(pose_a, "world_from_a");
  const Pose world_from_b = readPose(pose_b, "world_from_b");
  const py::gil_scoped_release no_gil;
  return queryHere().collide(a.solid, world_from_a, b.solid, world_from_b);
}

std::string distanceText(const SolidDistance& answer) {
  return answer.quality == Quality::unknown
             ? std::string("SolidDistance: unknown")
             : "SolidDistance: " + numberText(answer.measured.distance) + " m (" +
                   nameOf(answer.quality) + ")";
}

void bindSolid(py::module_& module) {
  py::class_<NamedSolid>(
      module, "Solid",
      "Something that can be measured; it never changes. Units: metres. Each is centered at its\n"
      "frame's origin, with its axis along z, unless it is made of points.\n"
      "Raises ArgumentError for lengths that are negative or not finite, and for meshes that are\n"
      "not sound.")
      .def_static(
          "sphere",
          [](double radius) {
            return NamedSolid{Solid::sphere(radius),
                              "sphere of radius " + numberText(radius) + " m"};
          },
          py::arg("radius"))
      .def_static(
          "capsule",
          [](double radius, double length) {
            return NamedSolid{Solid::capsule(radius, length),
                              lengthsText("capsule", radius, length)};
          },
          py::arg("radius"), py::arg("length"), "length: between the centers of its caps.")
      .def_static("box", boxOf, py::arg("size"), "size: three lengths.")
      .def_static(
          "cylinder",
          [](double radius, double length) {
            return NamedSolid{Solid::cylinder(radius, length),
                              lengthsText("cylinder", radius, length)};
          },
          py::arg("radius"), py::arg("length"))
      .def_static(
          "cone",
          [](double radius, double length) {
            return NamedSolid{Solid::cone(radius, length), lengthsText("cone", radius, length)};
          },
          py::arg("radius"), py::arg("length"),
          "The tip is at +length / 2. Made of a hull around the cone that sticks out by at most\n"
          "0.2 % of the radius; its distances are lower bounds.")
      .def_static("hull", hullOf, py::arg("points"), "The convex hull of (k, 3) points.")
      .def_static("mesh", meshOf, py::arg("vertices"), py::arg("triangles"),
                  "vertices: (k, 3). triangles: (m, 3) whole numbers, counter-clockwise from "
                  "outside where\nthe mesh is closed. Vertices that no triangle uses do not count.")
      .def_static("mesh_file", meshInFile, py::arg("file"), py::arg("scale") = 1.0,
                  "A mesh file: STL, DAE, OBJ, PLY. scale: one number, or three.")
      .def("__repr__", [](const NamedSolid& self) { return text("Solid: " + self.name); });
}

void bindSolidDistance(py::module_& module) {
  py::class_<SolidDistance>(module, "SolidDistance", "Frames: world. Units: metres.")
      .def_property_readonly(
          "distance", [](const SolidDistance& self) { return self.measured.distance; },
          "[m] > 0 apart, 0 touching, < 0 minus the depth of the overlap. NaN: unknown.")
      .def_property_readonly(
          "point_on_a",
          [](const SolidDistance& self) { return pointArray(self.measured.point_on_a); },
          "(3,) [m]")
      .def_property_readonly(
          "point_on_b",
          [](const SolidDistance& self) { return pointArray(self.measured.point_on_b); },
          "(3,) [m]")
      .def_property_readonly(
          "normal_a_to_b",
          [](const SolidDistance& self) { return pointArray(self.measured.normal_a_to_b); },
          "(3,) Unit vector.")
      .def_property_readonly(
          "quality", [](const SolidDistance& self) { return member(self.quality); }, "A Quality.")
      .def("__repr__", [](const SolidDistance& self) { return text(distanceText(self)); });
}

}  // namespace

void bindSolids(py::module_& module) {
  bindSolid(module);
  bindSolidDistance(module);
  module.def("distance", distance, py::arg("a"), py::arg("world_from_a"), py::arg("b"),
             py::arg("world_from_b"), py::arg("within") = std::numeric_limits<double>::infinity(),
             "The signed distance of two solids: a SolidDistance.\n\n"
             "world_from_a, world_from_b: a (4, 4) pose, a translation of 3 numbers, or None.\n"
             "within: [m] > 0: beyond it the search may stop. The answer is then a lower bound of "
             "at least\nthis, and its points may be NaN.\n"
             "A pose that is not rigid or not finite gives Quality.unknown and NaN.");
  module.def("collide", collide, py::arg("a"), py::arg("world_from_a"), py::arg("b"),
             py::arg("world_from_b"),
             "Whether two solids touch or overlap, by the cheapest search that tells.\n\n"
             "Raises ArgumentError if a pose is not rigid or not finite: yes and no would both be "
             "wrong.");
}

}  // namespace collision_monitor::python
