// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/mesh_bytes.h"
#include "model/mesh_files/mesh_reader.h"
#include "model/mesh_loading/helper_main.h"

/// Reads meshes for MeshProcess.
int main() {
  using namespace collision_monitor;
  const auto read = [](const std::string& name, const std::string& bytes) {
    return toBytes(readMesh(bytes, name));
  };
  const auto tell = [](const std::string& /*bytes*/, std::uint64_t limit) {
    return "needs more memory than the limit of " + std::to_string(limit / 1000000) +
           " MB (parameter files/mesh_memory)";
  };
  return answerQuestions(read, tell);
}
