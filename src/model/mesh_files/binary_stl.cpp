// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/binary_stl.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "model/mesh_files/mesh_builder.h"

namespace collision_monitor {
namespace {

// Source: the STL format as published by 3D Systems (StereoLithography Interface Specification,
// 1989): a header of 80 bytes, a little-endian count, then 50 bytes per triangle: its normal, three
// corners, and two unused bytes.
constexpr std::size_t kCountAt = 80;
constexpr std::size_t kHeaderSize = 84;
constexpr std::size_t kTriangleSize = 50;
constexpr std::size_t kNumberSize = 4;
constexpr std::size_t kCornerSize = 3 * kNumberSize;

std::uint32_t wordAt(const char* bytes) noexcept {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < kNumberSize; ++i) {
    word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return word;
}

double numberAt(const char* bytes) noexcept {
  static_assert(sizeof(float) == kNumberSize, "as in the file");
  const std::uint32_t word = wordAt(bytes);
  float number = 0.0F;
  std::memcpy(&number, &word, kNumberSize);
  return static_cast<double>(number);
}

Eigen::Vector3d cornerAt(const char* bytes) noexcept {
  return {numberAt(bytes), numberAt(bytes + kNumberSize), numberAt(bytes + 2 * kNumberSize)};
}

}  // namespace

TriangleMesh readBinaryStl(const std::string& bytes) {
  if (bytes.size() < kHeaderSize) {
    throw std::runtime_error("too short for an STL file: " + std::to_string(bytes.size()) +
                             " bytes");
  }
  const std::size_t count = wordAt(bytes.data() + kCountAt);
  const std::size_t present = (bytes.size() - kHeaderSize) / kTriangleSize;
  if (count > present) {
    throw std::runtime_error("the binary STL is cut short: it announces " + std::to_string(count) +
                             " triangles and holds " + std::to_string(present));
  }
  MeshBuilder builder(count);
  for (std::size_t i = 0; i < count; ++i) {
    const char* corner = bytes.data() + kHeaderSize + i * kTriangleSize + kCornerSize;
    std::array<std::uint32_t, 3> corners{};
    for (std::uint32_t& vertex : corners) {
      vertex = builder.addVertex(cornerAt(corner));
      corner += kCornerSize;
    }
    builder.addTriangle(corners);
  }
  return builder.takeMesh();
}

}  // namespace collision_monitor
