// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/setup/memory_need.h"

#include <gtest/gtest.h>
#include <malloc.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/urdf_text.h"
#include "support/sanitizer.h"

namespace collision_monitor {
namespace {

/// A tree of links that turn, every third a ball, a box and a rod.
RobotDescription treeOf(std::size_t link_count) {
  const std::string shapes[] = {"<sphere radius='0.02'/>", "<box size='0.03 0.02 0.05'/>",
                                "<cylinder radius='0.02' length='0.05'/>"};
  std::string elements;
  for (std::size_t i = 0; i < link_count; ++i) {
    const std::string name = "l" + std::to_string(i);
    elements += test::linkXml(name, shapes[i % 3]);
    if (i > 0) {
      const std::string at = std::to_string(0.1 * static_cast<double>(i % 7) - 0.3) + " " +
                             std::to_string(0.1 * static_cast<double>(i % 5) + 0.1) + " 0.2";
      elements +=
          test::jointXml("j" + std::to_string(i), "continuous", "l" + std::to_string((i - 1) / 2),
                         name, "<origin xyz='" + at + "'/>");
    }
  }
  return test::describeText(test::robotXml(elements));
}

/// [bytes] Pages of this process that are in memory.
std::size_t residentBytes() {
  std::ifstream file("/proc/self/statm");
  std::size_t all = 0;
  std::size_t resident = 0;
  file >> all >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

std::size_t allocatedBytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

LinkPoses firstPoses(const RobotModel& model) {
  LinkPoses poses = makeLinkPoses(model);
  std::fill(poses.status.begin(), poses.status.end(), LinkStatus::known);
  poses.stamp_ns = 1;
  return poses;
}

// 278 MB once, of which 1.8 kB for each pair of elements that may be refined. Nothing is known of
// the links' velocities, so every pair is measured.
TEST(MemoryNeed, fiveHundredLinks_takeTensOfMegabytes) {
  if (test::isSanitized()) {
    GTEST_SKIP() << "a sanitizer's memory";
  }
  const auto setUp = [](std::size_t links) {
    return buildSetup({treeOf(links)}, test::textLoader({}), SetupOptions());
  };
  {
    // Code and tables that the first cycle of a program brings into memory do not count.
    const CycleSetup small = setUp(20);
    CycleBuffers buffers = makeBuffers(small, BroadPhaseKind::automatic);
    runCycle(small, firstPoses(small.model), buffers);
  }
  malloc_trim(0);  // what tests before left free would hide what this one takes
  const std::size_t before = residentBytes();
  const CycleSetup setup = setUp(500);
  CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::automatic);
  EXPECT_LT(residentBytes() - before, 45'000'000U);
  runCycle(setup, firstPoses(setup.model), buffers);
  EXPECT_EQ(buffers.counters.measured, setup.table.size());
  EXPECT_LT(residentBytes() - before, 80'000'000U);
}

TEST(MemoryNeed, foretold_isAllThatIsTaken) {
  if (test::isSanitized()) {
    GTEST_SKIP() << "a sanitizer's memory";
  }
  for (const std::size_t links : {200U, 600U}) {
    const CycleSetup none = buildSetup({treeOf(2)}, test::textLoader({}), SetupOptions());
    const std::size_t before = allocatedBytes();
    const CycleSetup setup = buildSetup({treeOf(links)}, test::textLoader({}), SetupOptions());
    const CycleBuffers buffers = makeBuffers(setup, BroadPhaseKind::automatic);
    const std::size_t taken = allocatedBytes() - before;
    const std::uint64_t foretold = memoryNeedOf(countPairs(setup));
    EXPECT_GT(foretold + 3'000'000, taken) << links;  // links themselves take some, too
    // These have no meshes, whose memories are foretold.
    EXPECT_LT(foretold, taken + taken / 2 + 65'000'000) << links;
  }
}

std::string faultOf(const SetupOptions& options) {
  try {
    buildSetup({treeOf(200)}, test::textLoader({}), options);
  } catch (const SetupError& error) {
    EXPECT_EQ(error.problems().size(), 1U);
    return toString(error.problems().front());
  }
  return "";
}

TEST(MemoryNeed, moreThanTheLimit_isAnErrorThatCountsLinksPairsAndBytes) {
  SetupOptions options;
  options.memory_limit = 5'000'000;
  const std::string fault = faultOf(options);
  EXPECT_NE(
      fault.find(" MB: its 200 links with shapes make 19900 pairs, of which 19701 are checked; "
                 "these have 19701 pairs of shapes; accepted: at most 5 MB (parameter "
                 "memory_limit); to need less, leave out pairs ("),
      std::string::npos)
      << fault;
  EXPECT_EQ(fault.find("memory: the set-up needs "), 0U) << fault;
  EXPECT_NE(fault.find("ignore_pairs"), std::string::npos) << fault;
  options.memory_limit = 100'000'000;
  EXPECT_EQ(faultOf(options), "");
  options.memory_limit = 0;
  EXPECT_EQ(faultOf(options), "");
}

TEST(MemoryNeed, listOfPairsBeyondTheLimit_isRefusedBeforeItIsMade) {
  SetupOptions options;
  options.memory_limit = 100'000;
  const std::string fault = faultOf(options);
  EXPECT_EQ(fault.find("memory: the set-up needs more than "), 0U) << fault;
  EXPECT_NE(fault.find(": its 200 links with shapes make 19900 pairs; accepted: "),
            std::string::npos)
      << fault;
}

TEST(MemoryNeed, morePairsThanIds_isAnError) {
  PairCounts counts;
  counts.links = 100'000;
  counts.checked = counts.link_pairs = counts.body_pairs = counts.element_pairs = 4'999'950'000;
  SetupReport report;
  checkMemory(counts, 1'000'000'000'000'000, report);
  ASSERT_EQ(report.errors.size(), 1U);
  EXPECT_NE(report.errors[0].accepted.find("at most 4294967280 pairs"), std::string::npos);
}

TEST(MemoryNeed, available_isSomeAndNoMoreThanTheMachineHas) {
  const auto pages = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES));
  EXPECT_GT(availableMemory(), 0U);
  EXPECT_LE(availableMemory(), pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)));
}

}  // namespace
}  // namespace collision_monitor
