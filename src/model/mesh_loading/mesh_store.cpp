// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/mesh_loading/mesh_store.h"

#include <exception>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

constexpr const char* kFiles =
    "a regular file that can be read, by package://PACKAGE/PATH, file:///PATH or a path";
constexpr const char* kFormats = "a mesh file that can be read: STL, DAE, OBJ or PLY";

bool startsWith(const std::string& text, const char* start) { return text.rfind(start, 0) == 0; }

bool isRelative(const std::string& name) {
  return name.find("://") == std::string::npos && name.front() != '/' &&
         !startsWith(name, "file:/") && !startsWith(name, "package:/");
}

/// Where the path begins in a URI: after "scheme://", whose slashes separate no folders.
std::size_t pathStart(const std::string& name) {
  const auto scheme = name.find("://");
  return scheme == std::string::npos ? 0 : scheme + 3;
}

std::string normalised(const std::string& name) {
  const std::size_t start = pathStart(name);
  return name.substr(0, start) +
         std::filesystem::path(name.substr(start)).lexically_normal().string();
}

UpAxis declaredUpAxis(const std::string& bytes) {
  const auto declares = [&](const char* element) {
    return bytes.find(element) != std::string::npos;
  };
  if (declares("<up_axis>Y_UP")) {
    return UpAxis::y;
  }
  return declares("<up_axis>X_UP") ? UpAxis::x : UpAxis::z;
}

}  // namespace

MeshStore::MeshStore(const ResourceLoader& load_resource, const MeshReading& reading)
    : load_resource_(load_resource), process_(reading) {}

const StoredMesh& MeshStore::find(const std::string& name, const std::string& directory) {
  std::vector<std::string> uris;
  if (!isRelative(name)) {
    uris.push_back(name);
  } else if (directory.empty()) {
    throw MeshFault(
        "a relative mesh name needs a description read from a file, or the monitor's "
        "mesh_directory",
        kFiles);
  } else {
    for (const std::string& folder : foldersOf(directory)) {
      uris.push_back(normalised(std::string(folder).append("/").append(name)));
    }
  }
  for (const std::string& uri : uris) {
    const StoredMesh& stored = load(uri);
    if (stored.fault.empty()) {
      return stored;
    }
  }
  const StoredMesh& first = load(uris.front());
  throw MeshFault(first.fault, first.accepted);
}

const StoredMesh& MeshStore::load(const std::string& uri) {
  const auto [found, is_new] = meshes_.try_emplace(uri);
  StoredMesh& stored = found->second;
  if (is_new) {
    throwIfInterrupted();
    try {
      stored.accepted = kFiles;
      const std::string bytes = load_resource_(uri);
      stored.accepted = kFormats;
      stored.mesh = process_.read(bytes, uri);
      stored.up_axis = declaredUpAxis(bytes);
    } catch (const HelperFault& fault) {
      stored.accepted = "";  // the message names the limit
      stored.fault = fault.what();
    } catch (const std::exception& fault) {
      stored.fault = fault.what();
    }
  }
  return stored;
}

std::vector<std::string> MeshStore::foldersOf(const std::string& directory) {
  const auto [found, is_new] = folders_.try_emplace(directory);
  if (is_new) {
    std::vector<std::string> folders;
    const std::string scheme = directory.substr(0, pathStart(directory));
    for (std::filesystem::path folder = normalised(directory).substr(scheme.size());;
         folder = folder.parent_path()) {
      folders.push_back(scheme + folder.string());
      if (hasPackageXml(folders.back())) {
        break;
      }
      if (!folder.has_relative_path()) {
        // The file is not in a package, so folders above it are not searched.
        folders.resize(1);
        break;
      }
    }
    found->second = std::move(folders);
  }
  return found->second;
}

bool MeshStore::hasPackageXml(const std::string& folder) {
  try {
    load_resource_(normalised(folder + "/package.xml"));
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

TriangleMesh turnedUp(const TriangleMesh& mesh, UpAxis up_axis) {
  TriangleMesh result = mesh;
  for (Eigen::Vector3d& v : result.vertices) {
    if (up_axis == UpAxis::y) {
      v = Eigen::Vector3d(v.x(), -v.z(), v.y());
    } else if (up_axis == UpAxis::x) {
      v = Eigen::Vector3d(-v.y(), -v.z(), v.x());
    }
  }
  return result;
}

TriangleMesh scaled(const TriangleMesh& mesh, const Eigen::Vector3d& scale) {
  TriangleMesh result = mesh;
  for (Eigen::Vector3d& vertex : result.vertices) {
    vertex = vertex.cwiseProduct(scale);
  }
  if (scale.prod() < 0.0) {
    for (auto& triangle : result.triangles) {
      std::swap(triangle[1], triangle[2]);
    }
  }
  return result;
}

}  // namespace collision_monitor
