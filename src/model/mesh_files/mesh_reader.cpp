// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_files/mesh_reader.h"

#include <assimp/config.h>
#include <assimp/scene.h>

#include <Eigen/LU>
#include <algorithm>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cctype>
#include <stdexcept>
#include <vector>

#include "model/mesh_files/binary_stl.h"
#include "model/mesh_files/dae_check.h"
#include "model/mesh_files/mesh_builder.h"
#include "model/mesh_files/obj_text.h"
#include "model/mesh_files/ply_check.h"
#include "model/mesh_files/stl_check.h"
#include "model/mesh_files/triangulate.h"

namespace collision_monitor {
namespace {

std::string extensionOf(const std::string& file_name) {
  const std::size_t dot = file_name.find_last_of("./");
  if (dot == std::string::npos || file_name[dot] == '/') {
    return "";
  }
  std::string extension = file_name.substr(dot + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

Eigen::Matrix4d toMatrix(const aiMatrix4x4& m) {
  Eigen::Matrix4d matrix;
  matrix << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2,
      m.d3, m.d4;
  return matrix;
}

/// Opens no other file. A mesh file may name others, such as the materials of an OBJ. None is
/// needed, and the name may be that of a pipe or a device.
class NoOtherFiles : public Assimp::IOSystem {
 public:
  bool Exists(const char* /*name*/) const override { return false; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* /*name*/, const char* /*mode*/) override { return nullptr; }
  void Close(Assimp::IOStream* /*file*/) override {}
};

/// Places one mesh of a scene and adds it.
class PartPlacer {
 public:
  PartPlacer(const aiMesh& mesh, const Eigen::Matrix4d& scene_from_part, MeshBuilder& builder)
      : mesh_(mesh),
        scene_from_part_(scene_from_part),
        is_mirrored_(scene_from_part.topLeftCorner<3, 3>().determinant() < 0.0),
        builder_(builder) {}

  void addPolygon(const aiFace& face) {
    corners_.clear();
    positions_.clear();
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
      positions_.push_back(positionOf(face.mIndices[i]));
      corners_.push_back(builder_.addVertex(positions_.back()));
    }
    for (const auto& [a, b, c] : triangulate(positions_)) {
      builder_.addTriangle(is_mirrored_ ? std::array{corners_[a], corners_[c], corners_[b]}
                                        : std::array{corners_[a], corners_[b], corners_[c]});
    }
  }

 private:
  Eigen::Vector3d positionOf(unsigned corner) const {
    if (corner >= mesh_.mNumVertices) {
      throw std::runtime_error("a face names vertex " + std::to_string(corner) + " of " +
                               std::to_string(mesh_.mNumVertices));
    }
    const aiVector3D& v = mesh_.mVertices[corner];
    return (scene_from_part_ * Eigen::Vector4d(v.x, v.y, v.z, 1.0)).head<3>();
  }

  const aiMesh& mesh_;
  Eigen::Matrix4d scene_from_part_;
  bool is_mirrored_;
  MeshBuilder& builder_;
  std::vector<std::uint32_t> corners_;
  std::vector<Eigen::Vector3d> positions_;
};

TriangleMesh collect(const aiScene& scene) {
  if (scene.mRootNode->mTransformation.Determinant() == 0.0f) {
    throw std::runtime_error("its <unit> is 0 metres");
  }
  MeshBuilder builder;
  struct Visit {
    const aiNode* node;
    Eigen::Matrix4d scene_from_parent;
  };
  std::vector<Visit> open{{scene.mRootNode, Eigen::Matrix4d::Identity()}};
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    const Eigen::Matrix4d scene_from_node =
        visit.scene_from_parent * toMatrix(visit.node->mTransformation);
    for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) {
      const aiMesh& mesh = *scene.mMeshes[visit.node->mMeshes[i]];
      PartPlacer placer(mesh, scene_from_node, builder);
      for (unsigned face = 0; face < mesh.mNumFaces; ++face) {
        // Points and lines have no surface.
        if (mesh.mFaces[face].mNumIndices >= 3) {
          placer.addPolygon(mesh.mFaces[face]);
        }
      }
    }
    for (unsigned i = visit.node->mNumChildren; i > 0; --i) {
      open.push_back({visit.node->mChildren[i - 1], scene_from_node});
    }
  }
  return builder.takeMesh();
}

/// Shortens a message of assimp, which may quote the rest of the file.
std::string shortened(const std::string& reason) {
  constexpr std::size_t kLongest = 120;
  return reason.size() <= kLongest ? reason : reason.substr(0, kLongest) + "...";
}

/// The bytes in a form that assimp reads completely.
std::string prepared(const std::string& bytes, const std::string& format) {
  if (format == "stl") {
    return completeTextStl(bytes);
  }
  if (format == "obj") {
    return plainObj(bytes);
  }
  if (format == "dae") {
    checkDae(bytes);
  } else if (format == "ply") {
    checkPlyIsComplete(bytes);
  }
  return bytes;
}

TriangleMesh readByAssimp(const std::string& bytes, const std::string& format) {
  const std::string content = prepared(bytes, format);
  Assimp::Importer importer;
  importer.SetIOHandler(new NoOtherFiles);  // the importer owns it
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  // Otherwise assimp makes meshes from the nodes of a DAE whose meshes it does not find.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  if (importer.ReadFileFromMemory(content.data(), content.size(), 0, format.c_str()) == nullptr) {
    throw std::runtime_error(shortened(importer.GetErrorString()));
  }
  return collect(*importer.GetScene());
}

}  // namespace

bool isReadWithoutAssimp(const std::string& bytes, const std::string& file_name) {
  return extensionOf(file_name) == "stl" && !bytes.empty() && !isTextStl(bytes);
}

TriangleMesh readMesh(const std::string& bytes, const std::string& file_name) {
  const std::string format = extensionOf(file_name);
  if (format != "stl" && format != "dae" && format != "obj" && format != "ply") {
    throw std::runtime_error(file_name + ": '" + format +
                             "' is not a mesh format that is read (stl, dae, obj, ply)");
  }
  if (bytes.empty()) {
    throw std::runtime_error(file_name + ": the file is empty");
  }
  try {
    TriangleMesh mesh =
        isReadWithoutAssimp(bytes, file_name) ? readBinaryStl(bytes) : readByAssimp(bytes, format);
    if (mesh.vertices.empty()) {
      throw std::runtime_error("no triangles");
    }
    return mesh;
  } catch (const std::exception& error) {
    throw std::runtime_error(file_name + ": " + error.what());
  }
}

}  // namespace collision_monitor
