// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/robots/file_loader.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace collision_monitor::test {
namespace {

namespace fs = std::filesystem;

const std::string kOwnPackage = "package://collision_monitor/";

const char* const kTriangleDae =
    "<COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'><asset/>"
    "<library_geometries><geometry id='g'><mesh><source id='p'><float_array id='a' count='9'>"
    "0 0 0 1 0 0 0 1 0</float_array><technique_common><accessor source='#a' count='3' "
    "stride='3'><param name='X' type='float'/><param name='Y' type='float'/><param name='Z' "
    "type='float'/></accessor></technique_common></source><vertices id='v'><input "
    "semantic='POSITION' source='#p'/></vertices><triangles count='1'><input semantic='VERTEX' "
    "source='#v' offset='0'/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>"
    "<library_visual_scenes><visual_scene id='s'><node><instance_geometry url='#g'/></node>"
    "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene>"
    "</COLLADA>";

std::vector<fs::path> filesBelow(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder)) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file() && entry.path().extension() == extension) {
        files.push_back(entry.path());
      }
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// If a folder holds several robots: the SRDFs with the name of the URDF.
std::vector<fs::path> srdfsFor(const fs::path& urdf, const std::vector<fs::path>& srdfs) {
  std::vector<fs::path> same_name;
  for (const fs::path& srdf : srdfs) {
    if (srdf.stem() == urdf.stem()) {
      same_name.push_back(srdf);
    }
  }
  return same_name;
}

void appendRobots(const fs::path& folder, const fs::path& package_root,
                  std::vector<RobotFile>& robots) {
  const std::vector<fs::path> srdfs = filesBelow(folder, ".srdf");
  const std::vector<fs::path> urdfs = filesBelow(folder, ".urdf");
  for (const fs::path& urdf : urdfs) {
    // If a folder holds one robot, its SRDF may have any name.
    robots.push_back({(folder.filename() / urdf.filename()).string(), urdf, package_root,
                      urdfs.size() == 1 ? srdfs : srdfsFor(urdf, srdfs)});
  }
}

}  // namespace

const char* const kNoSharedData =
    "no folder of test robots: set COLLISION_MONITOR_SHARED_DATA to one that holds robots/";

std::string readFile(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || fs::is_directory(file)) {
    throw std::runtime_error("cannot read file " + file.string());
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

ResourceLoader fileLoader(const fs::path& root) {
  return [root](const std::string& uri) {
    const std::string package = "package://";
    const std::string file = "file://";
    if (uri.compare(0, kOwnPackage.size(), kOwnPackage) == 0) {
      // The folder of a checkout may have any name.
      return readFile(fs::path(COLLISION_MONITOR_SOURCE_DIR) / uri.substr(kOwnPackage.size()));
    }
    if (uri.compare(0, package.size(), package) == 0) {
      return readFile(root / uri.substr(package.size()));
    }
    return readFile(uri.compare(0, file.size(), file) == 0 ? uri.substr(file.size()) : uri);
  };
}

ResourceLoader oneTriangleLoader() {
  return [](const std::string& uri) -> std::string {
    std::string extension = fs::path(uri).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".obj") {
      return "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    }
    if (extension == ".stl") {
      return "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
             "vertex 0 1 0\nendloop\nendfacet\nendsolid s\n";
    }
    if (extension == ".dae") {
      return kTriangleDae;
    }
    throw std::runtime_error("no file " + uri);
  };
}

std::optional<fs::path> sharedDataDir() {
  const char* set = std::getenv("COLLISION_MONITOR_SHARED_DATA");
  const fs::path folder =
      set != nullptr ? fs::path(set) : fs::path(COLLISION_MONITOR_SOURCE_DIR) / "../shared/data";
  return fs::is_directory(folder / "robots") ? std::optional<fs::path>(folder) : std::nullopt;
}

std::vector<RobotFile> allRobotFiles() {
  std::vector<RobotFile> robots;
  const fs::path own = fs::path(COLLISION_MONITOR_SOURCE_DIR) / "urdf";
  appendRobots(own, own, robots);
  if (const auto shared = sharedDataDir()) {
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(*shared / "robots")) {
      folders.push_back(entry.path());
    }
    std::sort(folders.begin(), folders.end());
    for (const fs::path& folder : folders) {
      appendRobots(folder, folder, robots);
    }
  }
  return robots;
}

RobotDescription describe(const RobotFile& robot) {
  RobotDescription description;
  description.source = robot.name;
  description.urdf_xml = readFile(robot.urdf);
  description.directory = robot.urdf.parent_path().string();
  if (!robot.srdfs.empty()) {
    description.srdf_xml = readFile(robot.srdfs.front());
  }
  return description;
}

void forAllMeshes(
    const std::function<void(const TriangleMesh& mesh, const std::string& name)>& visit) {
  for (const RobotFile& robot : allRobotFiles()) {
    SetupReport report;
    const RobotModel model = readRobots({describe(robot)}, fileLoader(robot.package_root), report);
    for (const Link& link : model.links) {
      for (const CollisionElement& element : link.collisions) {
        const auto* mesh = std::get_if<TriangleMesh>(&element.geometry);
        if (mesh != nullptr && !mesh->vertices.empty()) {
          visit(*mesh, robot.name + " " + link.name);
        }
      }
    }
  }
}

}  // namespace collision_monitor::test
