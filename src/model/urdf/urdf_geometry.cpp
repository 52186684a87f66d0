// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstring>
#include <exception>

#include "geometry/constants.h"
#include "geometry/meshes/flat_triangles.h"
#include "model/urdf/urdf_elements.h"
#include "model/xml_document.h"

namespace collision_monitor {
namespace {

using tinyxml2::XMLElement;

constexpr const char* kShapes =
    "<box size>, <sphere radius>, <cylinder radius length>, <capsule radius length> or <mesh "
    "filename>";

/// The smallest length that an attribute accepts.
enum class Least { zero, above_zero };

std::optional<double> readLength(const XMLElement& element, const char* name, Least least,
                                 const Place& place) {
  const NumberAttribute attribute{name, least == Least::zero
                                            ? "one number that is 0 or greater, in metres"
                                            : "one number greater than 0, in metres"};
  const auto length = readNumbers<1>(element, attribute, place);
  if (!length) {
    return std::nullopt;
  }
  const double value = (*length)[0];
  if (value < 0.0 || (value == 0.0 && least == Least::above_zero)) {
    place.addError(element.GetLineNum(),
                   std::string(element.Name()) + " " + name + " " + quoted(element.Attribute(name)),
                   attribute.accepted);
    return std::nullopt;
  }
  if (value == 0.0) {
    place.note(Oddity::zero_size);
  }
  return value;
}

std::optional<Geometry> readBox(const XMLElement& element, const Place& place) {
  const NumberAttribute attribute{"size", "three numbers that are 0 or greater, in metres"};
  const auto size = readNumbers<3>(element, attribute, place);
  if (!size) {
    return std::nullopt;
  }
  if (size->minCoeff() < 0.0) {
    place.addError(element.GetLineNum(), "box size " + quoted(element.Attribute("size")),
                   attribute.accepted);
    return std::nullopt;
  }
  // Some published robots use a box of size 0 for links that are only frames.
  if (size->minCoeff() == 0.0) {
    place.note(Oddity::zero_size);
  }
  return Box{0.5 * *size};
}

std::optional<Geometry> readSphere(const XMLElement& element, const Place& place) {
  // Some published robots mark the corners of a foot with spheres of radius 0.
  const auto radius = readLength(element, "radius", Least::zero, place);
  return radius ? std::optional<Geometry>(Sphere{*radius}) : std::nullopt;
}

std::optional<Geometry> readCylinder(const XMLElement& element, const Place& place) {
  const auto radius = readLength(element, "radius", Least::above_zero, place);
  const auto length = readLength(element, "length", Least::above_zero, place);
  if (!radius || !length) {
    return std::nullopt;
  }
  return Cylinder{0.5 * *length, *radius};
}

std::optional<Geometry> readCapsule(const XMLElement& element, const Place& place) {
  const auto radius = readLength(element, "radius", Least::above_zero, place);
  const auto length = readLength(element, "length", Least::zero, place);
  if (!radius || !length) {
    return std::nullopt;
  }
  return Capsule{0.5 * *length, *radius};
}

/// False for numbers that are not finite.
bool isWithinReach(const TriangleMesh& mesh) {
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [](const Eigen::Vector3d& vertex) {
    return (vertex.array().abs() <= kFarthest).all();
  });
}

std::optional<Geometry> readMeshElement(const XMLElement& element, const MeshSource& meshes,
                                        const Place& place) {
  const auto name = readText(element, "filename", place);
  const auto scale = readMeshScale(element, place);
  if (!name) {
    return std::nullopt;
  }
  try {
    // Read even if the scale is faulty, so that a missing file is reported too.
    const StoredMesh& stored = meshes.store.find(*name, meshes.description.directory);
    if (!scale) {
      return std::nullopt;
    }
    const bool obeys_up_axis = meshes.description.obeys_up_axis;
    if (stored.up_axis != UpAxis::z && !obeys_up_axis) {
      place.note(Oddity::other_up_axis);
    }
    TriangleMesh result =
        scaled(obeys_up_axis ? turnedUp(stored.mesh, stored.up_axis) : stored.mesh, *scale);
    if (!isWithinReach(result)) {
      const char* const text = element.Attribute("scale");
      place.addError(element.GetLineNum(),
                     "mesh " + quoted(*name) +
                         (text == nullptr ? "" : " with scale " + quoted(text)) +
                         ": a vertex beyond 1e9 m",
                     "vertices whose coordinates are within 1e9 m of 0");
      return std::nullopt;
    }
    if (areAllFlat(result)) {
      place.note(Oddity::mesh_without_area);
    }
    return result;
  } catch (const std::exception& error) {
    const auto* fault = dynamic_cast<const MeshFault*>(&error);
    place.noteUnreadable(element.GetLineNum(), *name, error.what(),
                         fault == nullptr ? "" : fault->accepted);
    return std::nullopt;
  }
}

/// The only shape; null after an error if there is none or a second one. Elements with a namespace,
/// such as <drake:declare_convex/>, are extensions and ignored beside a shape.
const XMLElement* findShape(const XMLElement& geometry, const Place& place) {
  const XMLElement* shape = nullptr;
  for (const XMLElement* e = geometry.FirstChildElement(); e != nullptr;
       e = e->NextSiblingElement()) {
    if (std::strchr(e->Name(), ':') != nullptr) {
      continue;
    }
    if (std::strcmp(e->Name(), "origin") == 0) {
      place.addError(e->GetLineNum(), "<origin> inside of <geometry>",
                     "<origin> beside <geometry>, inside of <collision>");
      return nullptr;
    }
    if (shape != nullptr) {
      place.addError(e->GetLineNum(),
                     "<geometry> with a second shape <" + std::string(e->Name()) + ">",
                     "one shape; further ones in <collision> elements of their own");
      return nullptr;
    }
    shape = e;
  }
  if (shape == nullptr) {
    const XMLElement* other = geometry.FirstChildElement();
    place.addError(geometry.GetLineNum(),
                   other == nullptr ? "<geometry> without a shape"
                                    : "unknown geometry <" + std::string(other->Name()) + ">",
                   kShapes);
  }
  return shape;
}

}  // namespace

std::optional<Geometry> readGeometry(const XMLElement& geometry, const MeshSource& meshes,
                                     const Place& place) {
  const XMLElement* shape = findShape(geometry, place);
  if (shape == nullptr) {
    return std::nullopt;
  }
  const std::string kind = shape->Name();
  if (kind == "box") {
    return readBox(*shape, place);
  }
  if (kind == "sphere") {
    return readSphere(*shape, place);
  }
  if (kind == "cylinder") {
    return readCylinder(*shape, place);
  }
  if (kind == "capsule") {
    return readCapsule(*shape, place);
  }
  if (kind == "mesh") {
    return readMeshElement(*shape, meshes, place);
  }
  place.addError(shape->GetLineNum(), "unknown geometry <" + kind + ">", kShapes);
  return std::nullopt;
}

std::optional<Eigen::Vector3d> readMeshScale(const XMLElement& element, const Place& place) {
  const NumberAttribute attribute{"scale", "three numbers other than 0", kInfinity};
  if (element.Attribute("scale") == nullptr) {
    return Eigen::Vector3d::Ones();
  }
  auto scale = readNumbers<3>(element, attribute, place);
  if (scale && (scale->array() == 0.0).any()) {
    place.addError(element.GetLineNum(), "mesh scale " + quoted(element.Attribute("scale")),
                   attribute.accepted);
    return std::nullopt;
  }
  return scale;
}

}  // namespace collision_monitor
