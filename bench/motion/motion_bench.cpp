// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Motion between poses: plates that cross at speed, and a whole trajectory checked beside FCL. A
// robot is named by a part of a name in the shared data or urdf/.
//   motion_bench crossings COUNT PASSES LOOKED_THROUGH
//   motion_bench trajectory [ROBOT [PART]]
#include "motion_bench.h"

namespace collision_monitor::test {
namespace {

int runBench(const std::vector<std::string>& arguments) {
  const auto number = [&](std::size_t i) { return std::stoi(arguments[i]); };
  if (arguments.size() == 4 && arguments[0] == "crossings") {
    runCrossings(number(1), number(2), number(3));
    return 0;
  }
  if (!arguments.empty() && arguments.size() <= 3 && arguments[0] == "trajectory") {
    return runTrajectory(arguments.size() > 1 ? arguments[1] : "panda_moveit",
                         arguments.size() > 2 ? static_cast<std::size_t>(number(2)) : 10);
  }
  std::fprintf(stderr,
               "motion_bench crossings COUNT PASSES LOOKED_THROUGH | trajectory [ROBOT [PART]]\n");
  return 2;
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) {
  return collision_monitor::test::runBench({argv + 1, argv + argc});
}
