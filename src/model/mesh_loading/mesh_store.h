// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "collision_monitor/geometry/triangle_mesh.h"
#include "collision_monitor/model/urdf_reader.h"
#include "model/mesh_loading/mesh_process.h"

namespace collision_monitor {

/// The up axis that a DAE file declares. Other formats declare none and count as z.
enum class UpAxis : unsigned char { x, y, z };

struct StoredMesh {
  TriangleMesh mesh;  ///< in the axes of the file
  UpAxis up_axis{UpAxis::z};
  std::string fault;         ///< why there is no mesh, empty if there is one
  const char* accepted{""};  ///< for the fault, as in Problem
};

/// Why there is no mesh.
struct MeshFault : std::runtime_error {
  MeshFault(const std::string& reason, const char* what_is_accepted)
      : std::runtime_error(reason), accepted(what_is_accepted) {}
  const char* accepted;  ///< as in StoredMesh
};

/// The meshes of a set of robots. Finds the file for a name. Reads each file once, even if many
/// links use it.
class MeshStore {
 public:
  explicit MeshStore(const ResourceLoader& load_resource, const MeshReading& reading = {});

  /// The mesh that `name` means in a URDF of `directory`.
  ///
  /// A name with a scheme (package://, file://) or an absolute path goes to the loader unchanged.
  /// So does file: or package: with a single slash, so that the loader reports it. A relative name
  /// is looked up in `directory`, then in the folders above it, up to the first with a package.xml:
  /// published robots use both conventions.
  /// @throws MeshFault with a sentence if there is none, or it cannot be read.
  const StoredMesh& find(const std::string& name, const std::string& directory);

 private:
  const StoredMesh& load(const std::string& uri);
  std::vector<std::string> foldersOf(const std::string& directory);
  bool hasPackageXml(const std::string& folder);

  const ResourceLoader& load_resource_;
  MeshProcess process_;
  std::map<std::string, StoredMesh> meshes_;                 ///< by URI
  std::map<std::string, std::vector<std::string>> folders_;  ///< by directory
};

/// The mesh rotated so that its up axis becomes z and its right axis x.
/// Source: COLLADA 1.4.1 specification, `<up_axis>`: the right, up and inward axes of each kind.
TriangleMesh turnedUp(const TriangleMesh& mesh, UpAxis up_axis);

/// Every vertex times `scale`, axis by axis. If the scale mirrors, the triangles' winding is
/// reversed, so that they still face outward.
TriangleMesh scaled(const TriangleMesh& mesh, const Eigen::Vector3d& scale);

}  // namespace collision_monitor
