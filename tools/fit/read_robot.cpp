// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "read_robot.h"

#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "model/mesh_files/regular_file.h"

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
    if constexpr (kHasRos) {
      description.urdf_xml = readParameter(source.parameter, report);
    }
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

DocumentText readRules(const std::string& path, SetupReport& report) {
  return {path, readInput("option --rules", path, report)};
}

}  // namespace collision_monitor::fit_tool
