// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "collision_monitor/geometry/triangle_mesh.h"
#include "collision_monitor/model/mesh_reading.h"
#include "model/mesh_loading/helper_process.h"

namespace collision_monitor {

/// Reads mesh files in a separate process, or in this one if the options say so. The first mesh
/// starts the process. It reads all further ones; if a mesh kills it, the next mesh starts it
/// again. Binary STLs are always read in this process.
class MeshProcess {
 public:
  explicit MeshProcess(MeshReading options);

  /// As readMesh, with identical results.
  /// @throws HelperFault with a sentence that names the file and the limit exceeded, or if the
  /// program is not found; std::runtime_error as readMesh, or how the process died.
  /// @throws Interrupted
  TriangleMesh read(const std::string& bytes, const std::string& file_name);

 private:
  MeshReading options_;
  std::unique_ptr<HelperProcess> helper_;
};

}  // namespace collision_monitor
