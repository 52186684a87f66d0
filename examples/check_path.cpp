// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
// Proves whether a robot touches itself on the straight way from its default state to another:
//   check_path ROBOT.urdf POSITION...      one for each variable
#include <iostream>

#include "collision_monitor/robot_query.h"

int main(int argc, char** argv) try {
  namespace cm = collision_monitor;
  const auto monitor = cm::RobotMonitor::fromFiles({{argc > 1 ? argv[1] : ""}});
  std::vector<double> way_points = monitor.defaultState();
  for (int i = 2; i < argc; ++i) {
    way_points.push_back(std::stod(argv[i]));
  }
  const cm::PathAnswer answer = cm::RobotQuery(monitor).checkPath({way_points});
  if (answer.verdict != cm::Verdict::contact) {
    std::cout << (answer.verdict == cm::Verdict::unknown ? "unknown\n" : "no contact\n");
    return 0;
  }
  const auto& links = monitor.pairs()[answer.first_contact];
  std::cout << monitor.model().link(links.a).name << " touches "
            << monitor.model().link(links.b).name << " after "
            << 100.0 * answer.pairs[answer.first_contact].time << " % of the way\n";
} catch (const std::exception& fault) {
  std::cerr << fault.what() << '\n';
  return 1;
}
