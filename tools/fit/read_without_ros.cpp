// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/resources/file_loader.h"
#include "read_robot.h"

namespace collision_monitor::fit_tool {

ResourceLoader makeLoader(const RobotSource& source) {
  FileSources sources;
  sources.package_roots.assign(source.package_roots.begin(), source.package_roots.end());
  sources.package_places =
      "below --package-root, or where ROS_PACKAGE_PATH and AMENT_PREFIX_PATH lead to";
  return makeFileLoader(sources);
}

}  // namespace collision_monitor::fit_tool
