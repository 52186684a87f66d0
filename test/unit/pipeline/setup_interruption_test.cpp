// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cerrno>

#include "collision_monitor/geometry/interruption.h"
#include "collision_monitor/pipeline/setup.h"
#include "support/file_loader.h"
#include "support/urdf_text.h"

namespace collision_monitor::test {
namespace {

/// Two angles of meshes and a box that overlaps one of them.
std::string threeLinks() {
  const std::string mesh =
      "<mesh filename='package://collision_monitor/test/data/angle.stl' scale='1 1 1'/>";
  return robotXml(linkXml("a", mesh) + linkXml("b", mesh) + linkXml("c", "<box size='1 1 1'/>") +
                  jointXml("j", "floating", "a", "b") + jointXml("k", "floating", "b", "c"));
}

/// @return how often it was asked whether to go on.
int build(int most) {
  const RobotDescription robot = describeText(threeLinks());
  int asked = 0;
  const Interruptible interruptible([&] { return ++asked <= most; });
  buildSetup({robot}, fileLoader("/"), {});
  return asked;
}

/// Wherever that is: reading, fitting, making elements, ruling and listing pairs.
TEST(BuildSetup, isInterruptedWhereverItIsAsked_andLeavesNoProcess) {
  const int all = build(1000000000);
  EXPECT_GT(all, 1000);
  for (int most = 0; most < all; most += most < 50 ? 1 : all / 50) {
    EXPECT_THROW(build(most), Interrupted) << "after " << most << " of " << all;
    EXPECT_TRUE(waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD) << most;
  }
  EXPECT_THROW(build(all - 1), Interrupted);
}

}  // namespace
}  // namespace collision_monitor::test
