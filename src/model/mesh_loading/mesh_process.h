// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "collision_monitor/geometry/triangle_mesh.h"
#include "collision_monitor/model/mesh_reading.h"
#include "model/mesh_loading/helper_process.h"

namespace collision_monitor {

/// Reads mesh files in a process of its own, which is started for the first of them and serves
/// all, unless one kills it; or in this one, as the options say. Binary STLs are always read in
/// this one.
class MeshProcess {
 public:
  explicit MeshProcess(MeshReading options);

  /// As readMesh, to the last bit.
  /// @throws HelperFault with a sentence that names the file and which limit it met, or where the
  /// program of that process is not found; std::runtime_error as readMesh, and how the process
  /// died.
  /// @throws Interrupted
  TriangleMesh read(const std::string& bytes, const std::string& file_name);

 private:
  MeshReading options_;
  std::unique_ptr<HelperProcess> helper_;
};

}  // namespace collision_monitor
