// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "read_robot.h"

#include <ros/init.h>
#include <ros/param.h>
#include <tinyxml2.h>

#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "model/mesh_files/regular_file.h"
#include "ros_edge/parameters/resource_loader.h"

namespace collision_monitor::fit_tool {
namespace {

namespace fs = std::filesystem;

/// Reads up to the size limit of files.
std::string readStandardInput(SetupReport& report) {
  std::string text;
  std::string part(1 << 20, '\0');
  while (std::cin.read(part.data(), static_cast<std::streamsize>(part.size())) ||
         std::cin.gcount() > 0) {
    text.append(part, 0, static_cast<std::size_t>(std::cin.gcount()));
    if (text.size() > kUsualFileSize) {
      report.errors.push_back({"robot",
                               "standard input is larger than the limit of " +
                                   std::to_string(kUsualFileSize) +
                                   " bytes, as a monitor's parameter files/max_size",
                               "the text of a URDF"});
      return "";
    }
  }
  return text;
}

std::string readParameter(const std::string& name, SetupReport& report) {
  // Subscribes to nothing, and leaves Ctrl-C unchanged.
  ros::init(ros::M_string(), "robot_reader",
            ros::init_options::AnonymousName | ros::init_options::NoSigintHandler);
  std::string text;
  if (!ros::param::get(name, text)) {
    report.errors.push_back({"option --param", "no parameter '" + name + "', or no roscore",
                             "a parameter that holds the text of a URDF"});
  }
  return text;
}

/// Recognizes the package by its package.xml: a checkout may have any folder name.
bool isPackage(const fs::path& folder, const std::string& name) try {
  tinyxml2::XMLDocument document;
  if (document.Parse(readRegularFile(folder / "package.xml").c_str()) != tinyxml2::XML_SUCCESS ||
      document.RootElement() == nullptr) {
    return false;
  }
  const tinyxml2::XMLElement* element = document.RootElement()->FirstChildElement("name");
  return element != nullptr && element->GetText() != nullptr && element->GetText() == name;
} catch (const std::runtime_error&) {
  return false;  // no such file
}

/// Path of `uri` in the first root with that package. A root where the file exists goes before one
/// where it does not.
std::optional<std::string> findInRoots(const std::string& uri,
                                       const std::vector<std::string>& package_roots) {
  const std::string scheme = "package://";
  if (uri.compare(0, scheme.size(), scheme) != 0) {
    return std::nullopt;
  }
  const std::string path = uri.substr(scheme.size());
  const std::size_t slash = path.find('/');
  if (slash == std::string::npos) {
    return std::nullopt;
  }
  const std::string package = path.substr(0, slash);
  std::optional<std::string> missing;
  for (const fs::path root : package_roots) {
    const bool is_it = isPackage(root, package);
    const fs::path file = is_it ? root / path.substr(slash + 1) : root / path;
    if (fs::exists(file)) {
      return file.string();
    }
    if (!missing && (is_it || fs::is_directory(root / package))) {
      missing = file.string();
    }
  }
  return missing;
}

}  // namespace

std::string readInput(const std::string& what, const std::string& path, SetupReport& report) {
  if (path.empty()) {
    return "";
  }
  try {
    return readRegularFile(path);
  } catch (const std::runtime_error& fault) {
    report.errors.push_back({what, fault.what(), "a file that can be read"});
    return "";
  }
}

RobotDescription readDescription(const RobotSource& source, SetupReport& report) {
  RobotDescription description;
  if (!source.parameter.empty()) {
    description.source = "parameter " + source.parameter;
    description.urdf_xml = readParameter(source.parameter, report);
  } else if (source.urdf == "-") {
    description.source = "standard input";
    description.urdf_xml = readStandardInput(report);
    description.directory = fs::current_path().string();
  } else {
    description.source = source.urdf;
    description.urdf_xml = readInput("robot", source.urdf, report);
    description.directory = fs::absolute(source.urdf).parent_path().string();
  }
  return description;
}

ShapeRulesText readRules(const std::string& path, SetupReport& report) {
  return {path, readInput("option --rules", path, report)};
}

ResourceLoader makeLoader(const RobotSource& source) {
  LoadRules rules;
  rules.schemes = source.schemes;
  return [package_roots = source.package_roots,
          load = makeResourceLoader(rules)](const std::string& uri) {
    const std::optional<std::string> found = findInRoots(uri, package_roots);
    if (found && !fs::exists(*found)) {
      throw std::runtime_error("no file '" + *found + "'");
    }
    return found ? readRegularFile(*found) : load(uri);
  };
}

}  // namespace collision_monitor::fit_tool
