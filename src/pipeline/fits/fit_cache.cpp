// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/fits/fit_cache.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <random>
#include <stdexcept>
#include <system_error>
#include <type_traits>
#include <utility>

#include "model/mesh_files/regular_file.h"
#include "pipeline/fits/fit_text.h"
#include "pipeline/fits/sha256.h"

namespace collision_monitor {
namespace {

namespace fs = std::filesystem;

// Part of every key. Change it with every change of fitting that gives other shapes.
const std::string kMethod = "collision_monitor fits, method 8";

/// Appends plain values as bytes, so that different lists give different bytes.
struct Bytes {
  template <class T>
  void add(const T& value) {
    static_assert(std::is_arithmetic_v<T>, "of a plain value");
    text.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void add(const Eigen::Vector3d& vector) {
    add(vector.x());
    add(vector.y());
    add(vector.z());
  }
  /// For elements that are three numbers without gaps.
  template <class Element>
  void addAll(const std::vector<Element>& list) {
    using Number = std::decay_t<decltype(list[0][0])>;
    static_assert(sizeof(Element) == 3 * sizeof(Number), "no gaps");
    text.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(Element));
  }
  void operator()(const Sphere& sphere) { add(sphere.radius); }
  void operator()(const Capsule& capsule) {
    add(capsule.half_length);
    add(capsule.radius);
  }
  void operator()(const Box& box) { add(box.half_extents); }
  void operator()(const Cylinder& cylinder) {
    add(cylinder.half_length);
    add(cylinder.radius);
  }
  void operator()(const TriangleMesh& mesh) {
    add(mesh.vertices.size());
    add(mesh.triangles.size());
    addAll(mesh.vertices);
    addAll(mesh.triangles);
  }

  std::string text;
};

/// Whether the shape equals the geometry, so that distances to it are exact.
bool isItself(const Geometry& geometry, const Enclosure& enclosure) {
  if (!enclosure.geometry_from_body.rotation.isIdentity(0.0) ||
      !enclosure.geometry_from_body.translation.isZero(0.0)) {
    return false;
  }
  const auto* sphere = std::get_if<Sphere>(&geometry);
  const auto* capsule = std::get_if<Capsule>(&geometry);
  const auto* box = std::get_if<Box>(&geometry);
  const auto* as_sphere = std::get_if<Sphere>(&enclosure.shape);
  const auto* as_capsule = std::get_if<Capsule>(&enclosure.shape);
  const auto* as_box = std::get_if<Box>(&enclosure.shape);
  return (sphere != nullptr && as_sphere != nullptr && sphere->radius == as_sphere->radius) ||
         (capsule != nullptr && as_capsule != nullptr &&
          capsule->half_length == as_capsule->half_length &&
          capsule->radius == as_capsule->radius) ||
         (box != nullptr && as_box != nullptr && box->half_extents == as_box->half_extents);
}

bool holdsFor(const Geometry& geometry, const Fit& fit) {
  return provenExcess(geometry, fit) <= 0.0 &&
         std::all_of(fit.shapes.begin(), fit.shapes.end(), [&](const Enclosure& enclosure) {
           return !enclosure.is_exact || isItself(geometry, enclosure);
         });
}

bool holdFor(const std::vector<Fit>& fits, const std::vector<Geometry>& geometries) {
  if (fits.size() != geometries.size()) {
    return false;
  }
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (!holdsFor(geometries[i], fits[i])) {
      return false;
    }
  }
  return true;
}

/// A name that no other program or thread uses at this time.
std::string temporaryName(const std::string& key) {
  std::random_device random;
  return key + "." + std::to_string(random()) + std::to_string(random()) + ".tmp";
}

}  // namespace

std::string fitKey(const std::vector<Geometry>& geometries, const FitLimits& limits) {
  Bytes bytes;
  bytes.text = kMethod;
  bytes.add(limits.max_shapes);
  bytes.add(limits.target_overshoot);
  for (const bool kind :
       {limits.kinds.sphere, limits.kinds.capsule, limits.kinds.box, limits.kinds.rounded_box}) {
    bytes.add(kind);
  }
  for (const Geometry& geometry : geometries) {
    bytes.add(geometry.index());
    std::visit(bytes, geometry);
  }
  return sha256(bytes.text);
}

FitCache::FitCache(fs::path directory) : directory_(std::move(directory)) {}

std::optional<std::vector<Fit>> FitCache::load(const std::string& key,
                                               const std::vector<Geometry>& geometries) {
  std::error_code ignored;
  if (directory_.empty() || !fs::exists(fileOf(key), ignored)) {
    return std::nullopt;
  }
  std::optional<std::vector<Fit>> fits;
  try {
    fits = fitsFromText(readRegularFile(fileOf(key)));
  } catch (const std::runtime_error&) {
    // The file is missing or cannot be read: treated as a damaged one.
  }
  if (!fits || !holdFor(*fits, geometries)) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++rejected_count_;
    return std::nullopt;
  }
  return fits;
}

void FitCache::keep(const std::string& key, const std::vector<Fit>& fits, bool is_from_file) {
  bool can_write = !directory_.empty() && !is_from_file;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    // After one failure others would fail, too, each perhaps after a network time-out.
    can_write = can_write && write_fault_.empty();
  }
  if (can_write) {
    write(key, fits);
  }
}

void FitCache::noteFault(const std::string& fault) {
  const std::lock_guard<std::mutex> lock(mutex_);
  write_fault_ = fault;
}

fs::path FitCache::fileOf(const std::string& key) const { return directory_ / (key + ".fit"); }

void FitCache::write(const std::string& key, const std::vector<Fit>& fits) {
  std::error_code fault;
  fs::create_directories(directory_, fault);
  const fs::path temporary = directory_ / temporaryName(key);
  if (!fault) {
    std::ofstream stream(temporary, std::ios::binary);
    stream << toText(fits);
    stream.close();
    if (stream.fail()) {
      fault = std::make_error_code(std::errc::io_error);
    } else {
      fs::rename(temporary, fileOf(key), fault);
    }
  }
  if (fault) {
    noteFault(fault.message());
    std::error_code ignored;
    fs::remove(temporary, ignored);
  }
}

}  // namespace collision_monitor
