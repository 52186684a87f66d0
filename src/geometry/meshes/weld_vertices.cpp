// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/meshes/weld_vertices.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace collision_monitor {
namespace {

constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kFirst = 64;  // slots; this and every later size is a power of two

/// Adding 0 turns -0 into 0: they are equal, so their hashes must be.
std::size_t hashOf(const Eigen::Vector3d& vertex) noexcept {
  std::uint64_t hash = 0;
  for (const double coordinate : {vertex.x() + 0.0, vertex.y() + 0.0, vertex.z() + 0.0}) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof bits);
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 32U;
  }
  return hash;
}

}  // namespace

std::uint32_t VertexTable::firstEqual(const Eigen::Vector3d& vertex, std::uint32_t own,
                                      const std::vector<Eigen::Vector3d>& vertices) {
  if (2 * count_ >= slots_.size()) {
    growTo(std::max(kFirst, 4 * slots_.size()), vertices);
  }
  const std::size_t last = slots_.size() - 1;
  std::size_t slot = hashOf(vertex) & last;
  while (slots_[slot] != kFree && vertices[slots_[slot]] != vertex) {
    slot = (slot + 1) & last;
  }
  if (slots_[slot] == kFree) {
    slots_[slot] = own;
    ++count_;
  }
  return slots_[slot];
}

void VertexTable::reserve(std::size_t count) {
  std::size_t size = kFirst;
  while (size < 2 * count + 2) {
    size *= 2;
  }
  slots_.assign(size, kFree);
}

void VertexTable::growTo(std::size_t size, const std::vector<Eigen::Vector3d>& vertices) {
  const std::vector<std::uint32_t> old = std::move(slots_);
  slots_.assign(size, kFree);
  const std::size_t last = slots_.size() - 1;
  for (const std::uint32_t number : old) {
    if (number != kFree) {
      std::size_t slot = hashOf(vertices[number]) & last;
      while (slots_[slot] != kFree) {
        slot = (slot + 1) & last;
      }
      slots_[slot] = number;
    }
  }
}

std::vector<std::uint32_t> firstEquals(const std::vector<Eigen::Vector3d>& vertices) {
  VertexTable table;
  std::vector<std::uint32_t> first(vertices.size());
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    first[i] = table.firstEqual(vertices[i], i, vertices);
  }
  return first;
}

}  // namespace collision_monitor
