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

TEST(PairsOptions, severalRobots) {
  const Parsed parsed = parse({"cell.urdf", "--with", "left=arm.urdf", "--with", "right/=arm.urdf",
                               "--place", "left=0,0.5,1", "--place", "=1,0,0,0,0,-1.5",
                               "--write-yaml", "out.yaml", "--time-limit", "5", "--no-cache"});
  ASSERT_TRUE(parsed.is_to_run);
  const SeveralRobots& robots = parsed.options.robots;
  ASSERT_EQ(robots.others.size(), 2U);
  EXPECT_EQ(robots.others[0].prefix, "left");
  EXPECT_EQ(robots.others[1].prefix, "right");
  EXPECT_EQ(robots.others[1].urdf, "arm.urdf");
  ASSERT_EQ(robots.places.size(), 2U);
  EXPECT_EQ(robots.places[0].xyz, Eigen::Vector3d(0.0, 0.5, 1.0));
  EXPECT_EQ(robots.places[1].prefix, "");
  EXPECT_EQ(robots.places[1].rpy, Eigen::Vector3d(0.0, 0.0, -1.5));
  EXPECT_EQ(parsed.options.write_yaml, "out.yaml");
  EXPECT_EQ(parsed.options.search.time_limit, 5.0);
}

TEST(PairsOptions, whatDoesNotGoTogether_isRefusedWithTheReason) {
  const std::vector<std::pair<std::vector<const char*>, const char*>> cases{
      {{"a.urdf", "--with", "b.urdf"}, "PREFIX=FILE"},
      {{"a.urdf", "--with", "l=b.urdf", "--with", "l=c.urdf"}, "prefix 'l'"},
      {{"a.urdf", "--place", "l=0,0,0"}, "prefix 'l'"},
      {{"a.urdf", "--place", "=0,0,0", "--place", "=1,0,0"}, "two places"},
      {{"a.urdf", "--place", "=0,0"}, "X,Y,Z"},
      {{"a.urdf", "--place", "=0,0,nan"}, "X,Y,Z"},
      {{"a.urdf", "--place", "=0,0,0,1"}, "X,Y,Z"},
      {{"a.urdf", "--place", "=0,0,0,0,0,0,0"}, "X,Y,Z"},
      {{"a.urdf", "--with", "l=b.urdf", "--check", "a.srdf"}, "one robot"},
      {{"a.urdf", "--prefix", "l", "--write-srdf", "a.srdf"}, "one robot"},
      {{"a.urdf", "--force"}, "--write-yaml"},
      {{"a.urdf", "--write-srdf", "f", "--write-yaml", "f"}, "same file"},
      {{"a.urdf", "--check", "a.srdf", "--write-yaml", "a.srdf"}, "would replace"},
      {{"a.urdf", "--with", "l=b.urdf", "--write-yaml", "b.urdf"}, "would replace"},
      {{"a.urdf", "--time-limit", "nan"}, "accepted: 0 to 1000000 s"},
      {{"a.urdf", "--time-limit", "-1"}, "--time-limit"}};
  for (const auto& [arguments, reason] : cases) {
    std::string said;
    EXPECT_EQ(parse(arguments, &said).exit_code, 2);
    EXPECT_NE(said.find(reason), std::string::npos) << said;
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
