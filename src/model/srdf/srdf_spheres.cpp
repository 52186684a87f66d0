// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/srdf/srdf_spheres.h"

#include <optional>

namespace collision_monitor {
namespace {

using tinyxml2::XMLElement;

constexpr double kMost = 1e6;  // [m]

/// Numbers from -kMost to kMost; nothing, after a warning, if they are not that.
std::optional<Eigen::VectorXd> readMetres(const XMLElement& sphere, const char* attribute,
                                          int count, const Place& place) {
  Eigen::VectorXd numbers(count);
  const std::string text = attributeOf(sphere, attribute);
  if (!parseNumbers(text, numbers) && numbers.cwiseAbs().maxCoeff() <= kMost) {
    return numbers;
  }
  place.addWarning(sphere.GetLineNum(), std::string("sphere ") + attribute + " " + quoted(text),
                   "the spheres of its link are not used; " + std::to_string(count) +
                       (count == 1 ? " number" : " numbers") + " up to 1e6, in metres, " +
                       (count == 1 ? "is" : "are") + " accepted");
  return std::nullopt;
}

/// @return whether the sphere could be read; one of radius 0 is not added.
bool addSphere(const XMLElement& sphere, const Place& place, std::vector<PosedShape>& spheres) {
  const auto center = readMetres(sphere, "center", 3, place);
  const auto radius = readMetres(sphere, "radius", 1, place);
  if (!center || !radius) {
    return false;
  }
  if ((*radius)[0] < 0.0) {
    place.addWarning(sphere.GetLineNum(), "a sphere of negative radius",
                     "the spheres of its link are not used");
    return false;
  }
  if ((*radius)[0] > 0.0) {
    Pose link_from_sphere;
    link_from_sphere.translation = *center;
    spheres.push_back({Sphere{(*radius)[0]}, link_from_sphere});
  }
  return true;
}

std::vector<PosedShape> readSpheresOf(const XMLElement& element, const Place& place) {
  std::vector<PosedShape> spheres;
  for (const XMLElement* sphere = element.FirstChildElement("sphere"); sphere != nullptr;
       sphere = sphere->NextSiblingElement("sphere")) {
    if (!addSphere(*sphere, place, spheres)) {
      return {};
    }
  }
  return spheres;
}

}  // namespace

std::vector<SrdfPairs::Spheres> readSpheres(const XMLElement& root, const NameIndex& names,
                                            const Place& place) {
  constexpr const char* kElement = "link_sphere_approximation";
  std::vector<SrdfPairs::Spheres> approximations;
  for (const XMLElement* element = root.FirstChildElement(kElement); element != nullptr;
       element = element->NextSiblingElement(kElement)) {
    std::string name = attributeOf(*element, "link");
    name.erase(0, name.find_first_not_of('/'));
    const auto link = names.link(name);
    const std::vector<PosedShape> spheres =
        link ? readSpheresOf(*element, place) : std::vector<PosedShape>();
    if (!spheres.empty()) {
      approximations.push_back({*link, spheres, element->GetLineNum()});
    }
  }
  return approximations;
}

}  // namespace collision_monitor
