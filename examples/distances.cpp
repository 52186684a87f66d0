// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
// The distances of all pairs of links in one state:
//   distances ROBOT.urdf [JOINT POSITION]...
#include <iostream>

#include "collision_monitor/robot_query.h"

int main(int argc, char** argv) try {
  namespace cm = collision_monitor;
  const auto monitor = cm::RobotMonitor::fromFiles({{argc > 1 ? argv[1] : ""}});
  std::vector<std::string> joints;
  std::vector<double> positions;
  for (int i = 2; i + 1 < argc; i += 2) {
    joints.emplace_back(argv[i]);
    positions.push_back(std::stod(argv[i + 1]));
  }
  cm::RobotQuery query(monitor);
  for (const auto& pair : query.distances(monitor.stateOf(joints, positions)).pairs) {
    const auto& links = monitor.pairs()[pair.pair];
    std::cout << monitor.model().link(links.a).name << " - " << monitor.model().link(links.b).name
              << ": " << pair.measured.distance << " m\n";
  }
} catch (const std::exception& fault) {
  std::cerr << fault.what() << '\n';
  return 1;
}
