// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_loading/mesh_process.h"

#include <utility>

#include "model/mesh_files/mesh_bytes.h"
#include "model/mesh_files/mesh_reader.h"

namespace collision_monitor {

MeshProcess::MeshProcess(MeshReading options) : options_(std::move(options)) {}

TriangleMesh MeshProcess::read(const std::string& bytes, const std::string& file_name) {
  if (options_.is_in_process || isReadWithoutAssimp(bytes, file_name)) {
    return readMesh(bytes, file_name);
  }
  if (!helper_) {
    helper_ = std::make_unique<HelperProcess>(options_.program.empty() ? findHelper("read_meshes")
                                                                       : options_.program);
  }
  return meshFromBytes(
      helper_->ask(file_name, bytes, {options_.seconds, options_.memory, "files/mesh_time"}));
}

}  // namespace collision_monitor
