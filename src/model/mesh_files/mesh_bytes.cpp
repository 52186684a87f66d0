// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/mesh_bytes.h"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace collision_monitor {
namespace {

using Vertex = std::remove_reference_t<decltype(TriangleMesh().vertices.front())>;
using Corners = std::remove_reference_t<decltype(TriangleMesh().triangles.front())>;
static_assert(sizeof(Vertex) == 3 * sizeof(double), "no gaps");
static_assert(std::is_trivially_copyable_v<Corners>, "copied as bytes");

[[noreturn]] void refuseAnswer() {
  throw std::runtime_error("the process that reads it answers what is no mesh");
}

void checkCorners(const TriangleMesh& mesh) {
  for (const Corners& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (corner >= mesh.vertices.size()) {
        refuseAnswer();
      }
    }
  }
}

}  // namespace

std::string toBytes(const TriangleMesh& mesh) {
  const std::uint64_t count = mesh.vertices.size();
  std::string bytes;
  bytes.reserve(sizeof count + mesh.vertices.size() * sizeof(Vertex) +
                mesh.triangles.size() * sizeof(Corners));
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(mesh.vertices.data()),
               mesh.vertices.size() * sizeof(Vertex));
  bytes.append(reinterpret_cast<const char*>(mesh.triangles.data()),
               mesh.triangles.size() * sizeof(Corners));
  return bytes;
}

TriangleMesh meshFromBytes(const std::string& bytes) {
  std::uint64_t count = 0;
  if (bytes.size() < sizeof count) {
    refuseAnswer();
  }
  std::memcpy(&count, bytes.data(), sizeof count);
  const std::size_t rest = bytes.size() - sizeof count;
  if (count == 0 || count > rest / sizeof(Vertex) ||
      (rest - count * sizeof(Vertex)) % sizeof(Corners) != 0) {
    refuseAnswer();
  }
  TriangleMesh mesh;
  mesh.vertices.resize(count);
  mesh.triangles.resize((rest - count * sizeof(Vertex)) / sizeof(Corners));
  const char* const vertices = bytes.data() + sizeof count;
  const char* const triangles = vertices + count * sizeof(Vertex);
  std::memcpy(mesh.vertices.data()->data(), vertices, count * sizeof(Vertex));
  if (!mesh.triangles.empty()) {
    std::memcpy(mesh.triangles.data(), triangles, mesh.triangles.size() * sizeof(Corners));
  }
  checkCorners(mesh);
  return mesh;
}

}  // namespace collision_monitor
