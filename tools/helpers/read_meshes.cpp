// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/mesh_reader.h"
#include "model/helper_main.h"
#include "model/mesh_bytes.h"

/// Reads meshes for MeshProcess.
int main() {
  using namespace collision_monitor;
  const auto read = [](const std::string& name, const std::string& bytes) {
    return toBytes(readMesh(bytes, name));
  };
  return answerQuestions(read, "needs more memory than its limit");
}
