// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/fits/fit_text.h"

#include <charconv>
#include <sstream>
#include <string_view>

#include "model/number_text.h"
#include "pipeline/fits/sha256.h"

namespace collision_monitor {
namespace {

const std::string kHeader = "collision_monitor fits 3\n";
const std::string kHashLine = "sha256 ";
constexpr double kNotMeasured = -1.0;

// ---- writing

void append(double value, std::string& text) { text += ' ' + shortText(value); }

void append(const Eigen::Vector3d& vector, std::string& text) {
  append(vector.x(), text);
  append(vector.y(), text);
  append(vector.z(), text);
}

void append(const Pose& pose, std::string& text) {
  for (Eigen::Index row = 0; row < 3; ++row) {
    append(Eigen::Vector3d(pose.rotation.row(row)), text);
  }
  append(pose.translation, text);
}

void append(const Overshoot& overshoot, std::string& text) {
  append(overshoot.max, text);
  append(overshoot.mean, text);
  append(overshoot.fourth_power_mean, text);
}

void append(const Enclosure& enclosure, std::string& text) {
  text += std::string("shape ") + kindName(enclosure.shape);
  append(coreHalfExtents(enclosure.shape), text);
  append(radiusOf(enclosure.shape), text);
  append(enclosure.geometry_from_body, text);
  append(enclosure.overshoot, text);
  append(enclosure.widening, text);
  text += enclosure.is_exact ? " exact\n" : " enclosing\n";
}

void append(const std::optional<PosedShape>& inner, std::string& text) {
  if (!inner) {
    text += "none\n";
    return;
  }
  text += kindName(inner->shape);
  append(coreHalfExtents(inner->shape), text);
  append(radiusOf(inner->shape), text);
  append(inner->geometry_from_body, text);
  text += "\n";
}

// ---- reading; a stream that has failed stays so, and what is read from it then is not used

/// operator>> depends on the locale of the program.
void read(std::istream& in, double& value) {
  std::string word;
  in >> word;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) {
    in.setstate(std::ios::failbit);
  }
}

void read(std::istream& in, std::size_t& count) {
  std::string word;
  in >> word;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  constexpr std::size_t kMost = 100000;
  if (error != std::errc() || end != word.data() + word.size() || count > kMost) {
    count = 0;
    in.setstate(std::ios::failbit);
  }
}

void read(std::istream& in, Eigen::Vector3d& vector) {
  for (Eigen::Index i = 0; i < 3; ++i) {
    read(in, vector[i]);
  }
}

void read(std::istream& in, Overshoot& overshoot) {
  read(in, overshoot.max);
  read(in, overshoot.mean);
  read(in, overshoot.fourth_power_mean);
}

void expect(std::istream& in, const char* expected) {
  std::string word;
  in >> word;
  if (word != expected) {
    in.setstate(std::ios::failbit);
  }
}

std::optional<Shape> makeShape(const std::string& kind, const Eigen::Vector3d& core,
                               double radius) {
  for (const Shape& shape : {Shape(Sphere{radius}), Shape(Capsule{core.z(), radius}),
                             Shape(Box{core}), Shape(RoundedBox{core, radius})}) {
    if (kind == kindName(shape)) {
      return shape;
    }
  }
  return std::nullopt;
}

void read(std::istream& in, Pose& pose) {
  for (Eigen::Index row = 0; row < 3; ++row) {
    Eigen::Vector3d numbers = Eigen::Vector3d::Zero();
    read(in, numbers);
    pose.rotation.row(row) = numbers;
  }
  read(in, pose.translation);
}

/// Reads a shape after the name of its kind, and its pose.
std::optional<Shape> readShape(const std::string& kind, std::istream& in, Pose& pose) {
  Eigen::Vector3d core = Eigen::Vector3d::Zero();
  double radius = 0.0;
  read(in, core);
  read(in, radius);
  read(in, pose);
  std::optional<Shape> shape = makeShape(kind, core, radius);
  if (!shape) {
    in.setstate(std::ios::failbit);
  }
  return shape;
}

void read(std::istream& in, std::optional<PosedShape>& inner) {
  std::string kind;
  in >> kind;
  if (kind == "none") {
    return;
  }
  Pose pose;
  if (const std::optional<Shape> shape = readShape(kind, in, pose)) {
    inner = PosedShape{*shape, pose};
  }
}

void read(std::istream& in, Enclosure& enclosure) {
  expect(in, "shape");
  std::string kind;
  in >> kind;
  const std::optional<Shape> shape = readShape(kind, in, enclosure.geometry_from_body);
  read(in, enclosure.overshoot);
  read(in, enclosure.widening);
  std::string exactness;
  in >> exactness;
  enclosure.is_exact = exactness == "exact";
  if (!shape || (!enclosure.is_exact && exactness != "enclosing")) {
    in.setstate(std::ios::failbit);
    return;
  }
  enclosure.shape = *shape;
}

void read(std::istream& in, PartCut& cut) {
  expect(in, "cut");
  std::size_t part = 0;
  read(in, part);
  cut.part = static_cast<std::uint32_t>(part);
  read(in, cut.normal);
  read(in, cut.offset);
}

void read(std::istream& in, Fit& fit) {
  expect(in, "geometry");
  std::size_t shape_count = 0;
  std::size_t cut_count = 0;
  std::size_t joined_count = 0;
  read(in, shape_count);
  read(in, cut_count);
  read(in, joined_count);
  read(in, fit.overshoot);
  for (std::size_t i = 0; i < shape_count && in; ++i) {
    read(in, fit.shapes.emplace_back());
  }
  for (std::size_t i = 0; i < cut_count && in; ++i) {
    read(in, fit.cuts.emplace_back());
  }
  for (std::size_t i = 0; i < joined_count && in; ++i) {
    std::size_t shape = 0;
    read(in, shape);
    fit.shape_of.push_back(static_cast<std::uint32_t>(shape));
  }
  expect(in, "inner");
  read(in, fit.inner.sphere);
  read(in, fit.inner.capsule);
  expect(in, "openness");
  double openness = kNotMeasured;
  read(in, openness);
  fit.openness = openness == kNotMeasured ? std::nullopt : std::optional<double>(openness);
}

}  // namespace

std::string toText(const std::vector<Fit>& fits) {
  std::string text = kHeader + "geometries " + std::to_string(fits.size()) + "\n";
  for (const Fit& fit : fits) {
    text += "geometry";
    for (const std::size_t count : {fit.shapes.size(), fit.cuts.size(), fit.shape_of.size()}) {
      text += " " + std::to_string(count);
    }
    append(fit.overshoot, text);
    text += "\n";
    for (const Enclosure& enclosure : fit.shapes) {
      append(enclosure, text);
    }
    for (const PartCut& cut : fit.cuts) {
      text += "cut " + std::to_string(cut.part);
      append(cut.normal, text);
      append(cut.offset, text);
      text += "\n";
    }
    for (const std::uint32_t shape : fit.shape_of) {
      text += std::to_string(shape) + "\n";
    }
    text += "inner\n";
    append(fit.inner.sphere, text);
    append(fit.inner.capsule, text);
    text += "openness";
    append(fit.openness.value_or(kNotMeasured), text);
    text += "\n";
  }
  return text + kHashLine + sha256(text) + "\n";
}

std::optional<std::vector<Fit>> fitsFromText(const std::string& text) {
  const std::size_t hash_line = text.rfind(kHashLine);
  if (text.compare(0, kHeader.size(), kHeader) != 0 || hash_line == std::string::npos ||
      text.substr(hash_line) != kHashLine + sha256(text.substr(0, hash_line)) + "\n") {
    return std::nullopt;
  }
  std::istringstream in(text.substr(kHeader.size(), hash_line - kHeader.size()));
  expect(in, "geometries");
  std::size_t fit_count = 0;
  read(in, fit_count);
  std::vector<Fit> fits;
  for (std::size_t i = 0; i < fit_count && in; ++i) {
    read(in, fits.emplace_back());
  }
  std::string rest;
  if (!in || in >> rest) {
    return std::nullopt;
  }
  return fits;
}

}  // namespace collision_monitor
