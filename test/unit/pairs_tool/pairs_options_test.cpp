// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pairs_options.h"

#include <gtest/gtest.h>

#include "support/parse_arguments.h"

namespace collision_monitor::pairs_tool {
namespace {

Parsed parse(const std::vector<const char*>& arguments, std::string* said = nullptr) {
  return test::parseArguments(parseOptions, arguments, said);
}

TEST(PairsOptions, defaultsAndAllThatIsSaid) {
  EXPECT_EQ(parse({"robot.urdf"}).options.search.states, PairSearchOptions().states);
  const Parsed parsed =
      parse({"robot.urdf", "--states", "50", "--seed", "7", "--cells", "9", "--write-srdf",
             "out.srdf", "--trust-samples", "--force", "--no-cache"});
  ASSERT_TRUE(parsed.is_to_run);
  EXPECT_EQ(parsed.options.source.urdf, "robot.urdf");
  EXPECT_EQ(parsed.options.search.states, 50U);
  EXPECT_EQ(parsed.options.search.seed, 7U);
  EXPECT_EQ(parsed.options.search.most_cells, 9U);
  EXPECT_EQ(parsed.options.write_srdf, "out.srdf");
  EXPECT_TRUE(parsed.options.may_replace);
  EXPECT_TRUE(parsed.options.trusts_samples);
  EXPECT_EQ(parsed.options.cache, "none");
}

TEST(PairsOptions, help_endsWell) {
  std::string said;
  const Parsed parsed = parse({"--help"}, &said);
  EXPECT_FALSE(parsed.is_to_run);
  EXPECT_EQ(parsed.exit_code, 0);
  for (const char* option : {"--states", "--seed", "--write-srdf", "--force", "--trust-samples"}) {
    EXPECT_NE(said.find(option), std::string::npos) << option;
  }
  EXPECT_EQ(said.find("--param") != std::string::npos, fit_tool::kHasRos);
}

TEST(PairsOptions, faults) {
  for (const std::vector<const char*>& arguments :
       std::vector<std::vector<const char*>>{{},
                                             {"a.urdf", "--param", "b"},
                                             {"a.urdf", "--states", "0"},
                                             {"a.urdf", "--states", "-3"},
                                             {"a.urdf", "--seed", "x"},
                                             {"a.urdf", "--trust-samples"},
                                             {"a.urdf", "--force"},
                                             {"a.urdf", "--write-srdf", "a.urdf"},
                                             {"a.urdf", "--unknown"}}) {
    const Parsed parsed = parse(arguments);
    EXPECT_FALSE(parsed.is_to_run);
    EXPECT_EQ(parsed.exit_code, 2);
  }
}

/// The word reads an SRDF in every other tool, and once wrote one here.
TEST(PairsOptions, srdf_isRefused_withTheWordThatWrites) {
  for (const std::vector<const char*>& arguments : std::vector<std::vector<const char*>>{
           {"a.urdf", "--srdf", "out.srdf"}, {"a.urdf", "--srdf=out.srdf", "--states", "5"}}) {
    std::string said;
    const Parsed parsed = parse(arguments, &said);
    EXPECT_FALSE(parsed.is_to_run);
    EXPECT_EQ(parsed.exit_code, 2);
    EXPECT_NE(said.find("--write-srdf out.srdf"), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace collision_monitor::pairs_tool
