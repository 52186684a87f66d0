// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/mesh_reader.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <Eigen/LU>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <stdexcept>
#include <vector>

#include "model/mesh_builder.h"
#include "model/stl_check.h"

namespace collision_monitor {
namespace {

using Polygon = std::vector<unsigned>;

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

/// The polygons of a mesh; points and lines have no surface and are left out.
std::vector<Polygon> polygonsOf(const aiMesh& mesh) {
  std::vector<Polygon> polygons;
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices < 3) {
      continue;
    }
    polygons.emplace_back(face.mIndices, face.mIndices + face.mNumIndices);
    for (const unsigned corner : polygons.back()) {
      if (corner >= mesh.mNumVertices) {
        throw std::runtime_error("a face names vertex " + std::to_string(corner) + " of " +
                                 std::to_string(mesh.mNumVertices));
      }
    }
  }
  return polygons;
}

std::size_t triangleCount(const std::vector<Polygon>& polygons) {
  std::size_t count = 0;
  for (const Polygon& polygon : polygons) {
    count += polygon.size() - 2;
  }
  return count;
}

/// What assimp made of the polygons, unless it gave some up, as it does with those
/// that cross themselves. Then fans: a fan covers every point that its polygon
/// winds around and stays in the polygon's hull, so nothing is missed.
std::vector<Polygon> trianglesOf(const aiMesh& mesh, const std::vector<Polygon>& polygons) {
  std::vector<Polygon> triangles = polygonsOf(mesh);
  if (triangles.size() == triangleCount(polygons)) {
    return triangles;
  }
  triangles.clear();
  for (const Polygon& polygon : polygons) {
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
    }
  }
  return triangles;
}

Eigen::Matrix4d toMatrix(const aiMatrix4x4& m) {
  Eigen::Matrix4d matrix;
  matrix << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2,
      m.d3, m.d4;
  return matrix;
}

/// One mesh of a scene: its polygons before, and its triangles after triangulation.
struct ScenePart {
  std::vector<Polygon> polygons;
  std::vector<Polygon> triangles;
};

void addPart(const aiMesh& mesh, const ScenePart& part, const Eigen::Matrix4d& scene_from_part,
             MeshBuilder& builder) {
  const bool is_mirrored = scene_from_part.topLeftCorner<3, 3>().determinant() < 0.0;
  std::vector<std::uint32_t> index_of(mesh.mNumVertices, 0);
  // Corners of polygons, not all vertices of the file: one that no face uses is on no
  // surface. And not corners of triangles: triangulation may drop degenerate polygons.
  for (const Polygon& polygon : part.polygons) {
    for (const unsigned corner : polygon) {
      const aiVector3D& v = mesh.mVertices[corner];
      const Eigen::Vector4d placed = scene_from_part * Eigen::Vector4d(v.x, v.y, v.z, 1.0);
      index_of[corner] = builder.addVertex(placed.head<3>());
    }
  }
  for (const Polygon& triangle : part.triangles) {
    const std::uint32_t a = index_of[triangle[0]];
    const std::uint32_t b = index_of[triangle[1]];
    const std::uint32_t c = index_of[triangle[2]];
    builder.addTriangle(is_mirrored ? std::array{a, c, b} : std::array{a, b, c});
  }
}

TriangleMesh collect(const aiScene& scene, const std::vector<ScenePart>& parts) {
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
      const unsigned part = visit.node->mMeshes[i];
      addPart(*scene.mMeshes[part], parts[part], scene_from_node, builder);
    }
    for (unsigned i = visit.node->mNumChildren; i > 0; --i) {
      open.push_back({visit.node->mChildren[i - 1], scene_from_node});
    }
  }
  return builder.mesh();
}

std::vector<ScenePart> readParts(Assimp::Importer& importer) {
  const aiScene& scene = *importer.GetScene();
  std::vector<ScenePart> parts(scene.mNumMeshes);
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    parts[i].polygons = polygonsOf(*scene.mMeshes[i]);
  }
  const aiScene* triangulated = importer.ApplyPostProcessing(aiProcess_Triangulate);
  if (triangulated == nullptr) {
    throw std::runtime_error("its polygons cannot be made triangles");
  }
  for (unsigned i = 0; i < triangulated->mNumMeshes; ++i) {
    parts[i].triangles = trianglesOf(*triangulated->mMeshes[i], parts[i].polygons);
  }
  return parts;
}

}  // namespace

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
    const std::string content = format == "stl" ? completeStl(bytes) : bytes;
    Assimp::Importer importer;
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
    if (importer.ReadFileFromMemory(content.data(), content.size(), 0, format.c_str()) == nullptr) {
      throw std::runtime_error(importer.GetErrorString());
    }
    const std::vector<ScenePart> parts = readParts(importer);
    TriangleMesh mesh = collect(*importer.GetScene(), parts);
    if (mesh.vertices.empty()) {
      throw std::runtime_error("no triangles");
    }
    return mesh;
  } catch (const std::exception& error) {
    throw std::runtime_error(file_name + ": " + error.what());
  }
}

}  // namespace collision_monitor
