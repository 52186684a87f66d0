// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/sphere_trees/export_spheres.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace collision_monitor {
namespace {

constexpr int kDigits = 9;
// Readers treat spheres up to 2.2e-16 m as spheres without radius.
constexpr double kLeastRadius = 1e-12;  // [m]

std::string textOf(double value) {
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::general, kDigits);
  std::string text(buffer.data(), end.ptr);
  // Without a point, YAML 1.1 reads 1e-05 as a word and 1 as an integer.
  if (text.find('.') == std::string::npos) {
    text.insert(std::min(text.find('e'), text.size()), ".0");
  }
  return text;
}

double readAgain(const std::string& text) {
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// The text of a number that is read as not less than `value`.
std::string textNotBelow(double value) {
  std::string text = textOf(value);
  for (double larger = value; readAgain(text) < value; text = textOf(larger)) {
    larger *= 1.0 + 1e-9;
  }
  return text;
}

/// A sphere as text.
struct SphereText {
  std::array<std::string, 3> center;
  std::string radius;
};

SphereText textOf(const SphereNode& sphere) {
  SphereText text;
  Eigen::Vector3d center;
  for (Eigen::Index i = 0; i < 3; ++i) {
    text.center[static_cast<std::size_t>(i)] = textOf(sphere.center[i]);
    center[i] = readAgain(text.center[static_cast<std::size_t>(i)]);
  }
  // The sum and the length are rounded, by a few units of 1e-16.
  const double radius = (sphere.radius + (center - sphere.center).norm()) * (1.0 + 1e-15);
  text.radius = textNotBelow(std::max(radius, kLeastRadius));
  return text;
}

void check(const LinkSpheres& link) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20; };
  if (link.link.empty() || std::any_of(link.link.begin(), link.link.end(), is_control)) {
    throw std::invalid_argument("link '" + link.link +
                                "': a name of printable characters is accepted");
  }
  for (const auto& tree : link.trees) {
    for (const auto& node : tree.nodes) {
      if (!node.center.allFinite() || !std::isfinite(node.radius) || node.radius < 0.0) {
        throw std::invalid_argument("link '" + link.link +
                                    "': a sphere is not finite or has a negative radius");
      }
    }
  }
}

std::vector<SphereText> spheresOf(const LinkSpheres& link, std::uint32_t level) {
  std::vector<SphereText> spheres;
  for (const auto& tree : link.trees) {
    for (const auto& node : spheresOfLevel(tree, level)) {
      spheres.push_back(textOf(node));
    }
  }
  return spheres;
}

std::uint32_t levelCount(const LinkSpheres& link) {
  std::uint32_t count = 0;
  for (const auto& tree : link.trees) {
    count = std::max(count, levelCount(tree));
  }
  return count;
}

std::string quotedForYaml(const std::string& name) {
  std::string quoted = "\"";
  for (const char c : name) {
    quoted += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  }
  return quoted + "\"";
}

std::string quotedForXml(const std::string& name) {
  std::string quoted = "\"";
  for (const char c : name) {
    switch (c) {
      case '&':
        quoted += "&amp;";
        break;
      case '<':
        quoted += "&lt;";
        break;
      case '"':
        quoted += "&quot;";
        break;
      default:
        quoted += c;
    }
  }
  return quoted + "\"";
}

}  // namespace

std::string toYaml(const std::vector<LinkSpheres>& links) {
  std::string entries;
  for (const auto& link : links) {
    check(link);
    const std::uint32_t levels = levelCount(link);
    if (levels > 0) {
      entries += "  - link: " + quotedForYaml(link.link) + "\n    levels:\n";
    }
    for (std::uint32_t level = 0; level < levels; ++level) {
      entries += "      - level: " + std::to_string(level) + "\n        spheres:\n";
      for (const auto& sphere : spheresOf(link, level)) {
        entries += "          - {center: [" + sphere.center[0] + ", " + sphere.center[1] + ", " +
                   sphere.center[2] + "], radius: " + sphere.radius + "}\n";
      }
    }
  }
  return entries.empty() ? "links: []\n" : "links:\n" + entries;
}

std::string toSrdf(const std::vector<LinkSpheres>& links, std::uint32_t level) {
  std::string text;
  for (const auto& link : links) {
    check(link);
    const std::vector<SphereText> spheres = spheresOf(link, level);
    if (spheres.empty()) {
      continue;
    }
    text += "<link_sphere_approximation link=" + quotedForXml(link.link) + ">\n";
    for (const auto& sphere : spheres) {
      text += "  <sphere center=\"" + sphere.center[0] + " " + sphere.center[1] + " " +
              sphere.center[2] + "\" radius=\"" + sphere.radius + "\"/>\n";
    }
    text += "</link_sphere_approximation>\n";
  }
  return text;
}

}  // namespace collision_monitor
