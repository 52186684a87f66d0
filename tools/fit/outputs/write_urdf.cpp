// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outputs/write_urdf.h"

#include <tinyxml2.h>

#include <Eigen/Geometry>
#include <array>
#include <charconv>
#include <map>

#include "geometry/rpy.h"
#include "model/xml_declaration.h"

namespace collision_monitor::fit_tool {
namespace {

using tinyxml2::XMLElement;

constexpr double kGrowth = 1e-9;  // [m]

/// The shortest text that reads back as the same number, in every locale.
std::string number(double value) {
  std::array<char, 40> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string numbers(const Eigen::Vector3d& values) {
  return number(values.x()) + " " + number(values.y()) + " " + number(values.z());
}

/// Collects pieces that are given in the frame of one shape.
class PieceList {
 public:
  explicit PieceList(const Pose& link_from_body) : link_from_body_(link_from_body) {}

  void add(const Geometry& geometry, const Eigen::Vector3d& center,
           const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity()) {
    pieces_.push_back({geometry, link_from_body_ * Pose{rotation, center}});
  }
  std::vector<UrdfPiece> take() { return std::move(pieces_); }

 private:
  Pose link_from_body_;
  std::vector<UrdfPiece> pieces_;
};

/// Both ends of an extent; only its middle if it is 0.
std::vector<double> endsOf(double half_extent) {
  return half_extent > 0.0 ? std::vector<double>{-half_extent, half_extent}
                           : std::vector<double>{0.0};
}

/// Adds the cylinders along one axis of a rounded box.
void addEdges(const RoundedBox& box, Eigen::Index axis, PieceList& pieces) {
  if (box.half_extents[axis] <= 0.0) {
    return;
  }
  const Eigen::Index second = (axis + 1) % 3;
  const Eigen::Index third = (axis + 2) % 3;
  const Eigen::Matrix3d along_axis =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Unit(axis))
          .toRotationMatrix();
  for (const double y : endsOf(box.half_extents[second])) {
    for (const double z : endsOf(box.half_extents[third])) {
      Eigen::Vector3d center = Eigen::Vector3d::Zero();
      center[second] = y;
      center[third] = z;
      pieces.add(Cylinder{box.half_extents[axis], box.radius}, center, along_axis);
    }
  }
}

void addRoundedBox(const RoundedBox& box, PieceList& pieces) {
  const Eigen::Vector3d& half = box.half_extents;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d longer = half + box.radius * Eigen::Vector3d::Unit(axis);
    if (longer.minCoeff() > 0.0) {
      pieces.add(Box{longer}, Eigen::Vector3d::Zero());
    }
    addEdges(box, axis, pieces);
  }
  for (const double x : endsOf(half.x())) {
    for (const double y : endsOf(half.y())) {
      for (const double z : endsOf(half.z())) {
        pieces.add(Sphere{box.radius}, {x, y, z});
      }
    }
  }
}

void addPieces(const Shape& shape, PieceList& pieces) {
  if (const auto* box = std::get_if<Box>(&shape)) {
    pieces.add(*box, Eigen::Vector3d::Zero());
    return;
  }
  if (const auto* capsule = std::get_if<Capsule>(&shape); capsule && capsule->half_length > 0.0) {
    pieces.add(Cylinder{capsule->half_length, capsule->radius}, Eigen::Vector3d::Zero());
  }
  if (const auto* rounded = std::get_if<RoundedBox>(&shape)) {
    addRoundedBox(*rounded, pieces);
    return;
  }
  for (const double z : endsOf(coreHalfExtents(shape).z())) {
    pieces.add(Sphere{radiusOf(shape)}, {0.0, 0.0, z});
  }
}

void addGeometry(const Geometry& geometry, XMLElement& parent) {
  XMLElement* element = parent.InsertNewChildElement("geometry");
  if (const auto* sphere = std::get_if<Sphere>(&geometry)) {
    element->InsertNewChildElement("sphere")->SetAttribute("radius",
                                                           number(sphere->radius).c_str());
  } else if (const auto* box = std::get_if<Box>(&geometry)) {
    element->InsertNewChildElement("box")->SetAttribute("size",
                                                        numbers(2.0 * box->half_extents).c_str());
  } else if (const auto* cylinder = std::get_if<Cylinder>(&geometry)) {
    XMLElement* own = element->InsertNewChildElement("cylinder");
    own->SetAttribute("radius", number(cylinder->radius).c_str());
    own->SetAttribute("length", number(2.0 * cylinder->half_length).c_str());
  }
}

/// Adds a `<collision>` or `<visual>` with the piece.
XMLElement& addPiece(const char* tag, const std::string& name, const UrdfPiece& piece,
                     XMLElement& link) {
  XMLElement* element = link.InsertNewChildElement(tag);
  element->SetAttribute("name", name.c_str());
  XMLElement* origin = element->InsertNewChildElement("origin");
  origin->SetAttribute("xyz", numbers(piece.link_from_geometry.translation).c_str());
  origin->SetAttribute("rpy", numbers(rpyOf(piece.link_from_geometry.rotation)).c_str());
  addGeometry(piece.geometry, *element);
  return *element;
}

/// Writes the color into each material: some readers do not share materials between links.
void addMaterial(const Shape& shape, XMLElement& visual) {
  static const std::array<const char*, 3> kColours{"0.34 0.71 0.91 1", "0.00 0.62 0.45 1",
                                                   "0.90 0.62 0.00 1"};  // sphere, capsule, boxes
  XMLElement* material = visual.InsertNewChildElement("material");
  material->SetAttribute("name", (std::string("fitted_") + kindName(shape)).c_str());
  material->InsertNewChildElement("color")->SetAttribute(
      "rgba", kColours.at(static_cast<std::size_t>(coreKindOf(shape))));
}

void removeAll(const char* tag, XMLElement& link) {
  while (XMLElement* element = link.FirstChildElement(tag)) {
    link.DeleteChild(element);
  }
}

void replaceShapes(const std::vector<PosedShape>& shapes, XMLElement& link) {
  removeAll("visual", link);
  removeAll("collision", link);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const PosedShape larger{grown(shapes[i].shape, kGrowth), shapes[i].geometry_from_body};
    const std::string name = std::string(kindName(larger.shape)) + "_" + std::to_string(i + 1);
    const std::vector<UrdfPiece> pieces = piecesOf(larger);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const std::string own = pieces.size() == 1 ? name : name + "_part_" + std::to_string(k + 1);
      addMaterial(larger.shape, addPiece("visual", own, pieces[k], link));
      addPiece("collision", own, pieces[k], link);
    }
  }
}

/// The name as our URDF reader takes it: without surrounding white space and leading slashes.
std::string nameOf(const XMLElement& link) {
  const char* attribute = link.Attribute("name");
  const std::string text = attribute == nullptr ? "" : attribute;
  const std::size_t first = text.find_first_not_of(" \t\r\n/");
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

}  // namespace

std::vector<UrdfPiece> piecesOf(const PosedShape& shape) {
  PieceList pieces(shape.geometry_from_body);
  addPieces(shape.shape, pieces);
  return pieces.take();
}

std::string writeUrdf(const std::string& urdf_xml, const std::vector<LinkShapes>& links) {
  std::map<std::string, const std::vector<PosedShape>*> shapes_of;
  for (const LinkShapes& link : links) {
    shapes_of[link.link] = &link.shapes;
  }
  tinyxml2::XMLDocument document;
  const std::string xml = withoutLateDeclaration(urdf_xml);
  document.Parse(xml.c_str(), xml.size());
  for (XMLElement* link = document.RootElement()->FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    const auto found = shapes_of.find(nameOf(*link));
    if (found != shapes_of.end()) {
      replaceShapes(*found->second, *link);
    }
  }
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return {printer.CStr(), static_cast<std::size_t>(printer.CStrSize() - 1)};
}

}  // namespace collision_monitor::fit_tool
