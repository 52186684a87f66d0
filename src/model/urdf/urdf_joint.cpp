// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "geometry/constants.h"
#include "model/joint_type_names.h"
#include "model/urdf/urdf_elements.h"
#include "model/xml_document.h"

namespace collision_monitor {
namespace {

using tinyxml2::XMLElement;

JointType readType(const XMLElement& element, const Place& place) {
  const char* const accepted = "fixed, revolute, continuous, prismatic, planar or floating";
  const char* text = element.Attribute("type");
  for (const JointTypeName& known : kJointTypeNames) {
    if (text != nullptr && std::string(text) == known.name) {
      return known.type;
    }
  }
  place.addError(element.GetLineNum(),
                 text == nullptr ? "<joint> without type" : "joint type " + quoted(text), accepted);
  return JointType::fixed;
}

std::string readEnd(const XMLElement& joint, const char* end, const Place& place) {
  const XMLElement* element = onlyChild(joint, end, place);
  if (element == nullptr) {
    place.addError(joint.GetLineNum(), "<joint> without <" + std::string(end) + ">",
                   "<" + std::string(end) + " link=\"...\"/>");
    return "";
  }
  return readName(*element, "link", place).value_or("");
}

bool hasAxis(JointType type) { return type != JointType::fixed && type != JointType::floating; }

void readAxis(const XMLElement& element, const Place& place, Joint& joint) {
  // Exporters write a zero axis for fixed joints, where it has no meaning.
  if (!hasAxis(joint.type)) {
    return;
  }
  const XMLElement* axis = onlyChild(element, "axis", place);
  if (axis == nullptr) {
    return;
  }
  const NumberAttribute attribute{"xyz", "three finite numbers, not all 0", kInfinity};
  const auto direction = readNumbers<3>(*axis, attribute, place);
  if (!direction) {
    return;
  }
  // stableNorm neither overflows nor underflows for tiny numbers.
  if (direction->stableNorm() == 0.0) {
    place.addError(axis->GetLineNum(), "axis xyz " + quoted(axis->Attribute("xyz")),
                   attribute.accepted);
    return;
  }
  joint.axis = direction->stableNormalized();
}

bool hasRange(JointType type) {
  return type == JointType::revolute || type == JointType::prismatic;
}

/// Exporters write 1e16 for "no limit".
double boundOf(double number) {
  return std::abs(number) <= kFarthest ? number : std::copysign(kInfinity, number);
}

std::string shown(const XMLElement& element, const char* attribute) {
  const char* text = element.Attribute(attribute);
  return text == nullptr ? "0 (not written)" : quoted(text);
}

/// Checks the bounds after reading.
void checkRange(const XMLElement& limit, const Place& place, const Joint& joint) {
  const std::string lower = shown(limit, "lower");
  const std::string upper = shown(limit, "upper");
  if (limit.Attribute("lower") == nullptr && limit.Attribute("upper") == nullptr) {
    place.note(Oddity::limit_without_range);
  }
  if (joint.lower > joint.upper) {
    place.addError(limit.GetLineNum(), "limit lower " + lower + " above upper " + upper,
                   "lower <= upper");
  } else if (joint.lower == kInfinity || joint.upper == -kInfinity) {
    place.addError(limit.GetLineNum(), "limit lower " + lower + ", upper " + upper,
                   "a range that holds numbers within 1e9 of 0");
  } else if (std::isinf(joint.lower) || std::isinf(joint.upper)) {
    place.note(Oddity::limit_beyond_sense);
  }
}

void readLimit(const XMLElement& element, const Place& place, Joint& joint) {
  const XMLElement* limit = element.FirstChildElement("limit");
  if (!hasRange(joint.type) && joint.type != JointType::continuous) {
    return;
  }
  if (limit == nullptr) {
    if (hasRange(joint.type)) {
      place.note(Oddity::no_limit);
    }
    return;
  }
  if (limit->NextSiblingElement("limit") != nullptr) {
    place.note(Oddity::second_limit);
  }
  const char* const accepted = "one finite number, in radians or metres";
  const Numbers<1> zero = Numbers<1>::Zero();
  if (hasRange(joint.type)) {
    // URDF: a missing bound is 0.
    joint.lower = boundOf(readNumbersOr<1>(zero, *limit, {"lower", accepted, kInfinity}, place)[0]);
    joint.upper = boundOf(readNumbersOr<1>(zero, *limit, {"upper", accepted, kInfinity}, place)[0]);
    checkRange(*limit, place, joint);
  }
  const Numbers<1> unlimited(kInfinity);
  const double velocity = readNumbersOr<1>(
      unlimited, *limit,
      {"velocity", "one finite number, in radians or metres a second", kInfinity}, place)[0];
  // Exporters write 0 for "unknown"; a limit of 0 would make every motion impossible.
  joint.max_velocity = velocity > 0.0 ? velocity : kInfinity;
  if (!(velocity > 0.0)) {
    place.note(Oddity::no_speed_limit);
  }
}

void readMimic(const XMLElement& element, const Place& place, UrdfJoint& joint) {
  const XMLElement* mimic = element.FirstChildElement("mimic");
  if (mimic == nullptr) {
    return;
  }
  if (joint.joint.type == JointType::fixed) {
    place.note(Oddity::mimic_on_fixed_joint);
    return;
  }
  onlyChild(element, "mimic", place);
  if (!hasRange(joint.joint.type) && joint.joint.type != JointType::continuous) {
    place.addError(mimic->GetLineNum(), "mimic on a joint with several variables",
                   "mimic on a revolute, continuous or prismatic joint");
    return;
  }
  const auto source = readName(*mimic, "joint", place);
  const char* const accepted = "one finite number";
  UrdfMimic read;
  read.multiplier = readNumbersOr<1>(Numbers<1>(1.0), *mimic, {"multiplier", accepted}, place)[0];
  read.offset = readNumbersOr<1>(Numbers<1>(0.0), *mimic, {"offset", accepted}, place)[0];
  if (source) {
    read.source = *source;
    joint.mimic = read;
  }
}

}  // namespace

std::optional<UrdfJoint> readUrdfJoint(const XMLElement& element, const Place& place) {
  const auto name = readName(element, "name", place);
  const Place here = place.within("joint " + quoted(name.value_or("?")));
  UrdfJoint read;
  read.line = element.GetLineNum();
  read.joint.type = readType(element, here);
  read.joint.parent_from_joint = readOrigin(element, here);
  read.parent = readEnd(element, "parent", here);
  read.child = readEnd(element, "child", here);
  readAxis(element, here, read.joint);
  readLimit(element, here, read.joint);
  readMimic(element, here, read);
  if (!name) {
    return std::nullopt;
  }
  read.joint.name = *name;
  return read;
}

}  // namespace collision_monitor
