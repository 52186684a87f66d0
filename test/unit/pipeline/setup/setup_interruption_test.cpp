// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cerrno>

#include "collision_monitor/pipeline/setup.h"
#include "geometry/interruption.h"
#include "support/robots/file_loader.h"
#include "support/robots/urdf_text.h"

namespace collision_monitor::test {
namespace {

/// Two angles of meshes and a box that overlaps one of them.
std::string threeLinks() {
  const std::string mesh =
      "<mesh filename='package://collision_monitor/test/data/angle.stl' scale='1 1 1'/>";
  return robotXml(linkXml("a", mesh) + linkXml("b", mesh) + linkXml("c", "<box size='1 1 1'/>") +
                  jointXml("j", "floating", "a", "b") + jointXml("k", "floating", "b", "c"));
}

/// @param is_in_process else a process reads the meshes, and how often is asked depends on its time
/// @return how often it was asked whether to go on.
int build(int most, bool is_in_process) {
  const RobotDescription robot = describeText(threeLinks());
  SetupOptions options;
  options.meshes.is_in_process = is_in_process;
  int asked = 0;
  const Interruptible interruptible([&] { return ++asked <= most; });
  buildSetup({robot}, fileLoader("/"), options);
  return asked;
}

bool hasChild() { return waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD; }

/// Wherever that is: reading, fitting, making elements, ruling and listing pairs.
TEST(BuildSetup, isInterruptedWhereverItIsAsked) {
  const int all = build(1000000000, true);
  EXPECT_GT(all, 1000);
  for (int most = 0; most < all; most += most < 50 ? 1 : all / 50) {
    EXPECT_THROW(build(most, true), Interrupted) << "after " << most << " of " << all;
  }
  EXPECT_THROW(build(all - 1, true), Interrupted);
}

TEST(BuildSetup, isInterrupted_leavesNoProcess) {
  for (int most = 0; most < 50; ++most) {
    EXPECT_THROW(build(most, false), Interrupted) << most;
    EXPECT_FALSE(hasChild()) << most;
  }
}

}  // namespace
}  // namespace collision_monitor::test
