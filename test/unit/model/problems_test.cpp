// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/problems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <new>
#include <stdexcept>

#include "model/place.h"

namespace collision_monitor {
namespace {

TEST(Problems, toString_namesPlaceFoundAndAccepted) {
  EXPECT_EQ(toString({"robot.urdf line 42, link 'arm'", "box size '0.1 -0.2 0.3'",
                      "three numbers greater than 0, in metres"}),
            "robot.urdf line 42, link 'arm': box size '0.1 -0.2 0.3'; accepted: three numbers "
            "greater than 0, in metres");
}

TEST(Problems, toString_adviceIsNoInputThatIsAccepted) {
  EXPECT_EQ(toString({"r.urdf", "no limits: joint 'j'", "", "they are taken as unlimited"}),
            "r.urdf: no limits: joint 'j'; they are taken as unlimited");
}

TEST(Problems, quoted_letsNoTextRewriteATerminalOrFillAMessage) {
  EXPECT_EQ(quoted("\x1b[2J\n\x7f\xC2\x9b"), "'\\x1b[2J\\x0a\\x7f\\x9b'");
  EXPECT_EQ(quoted("gr\u00fcn"), "'gr\u00fcn'");
  const std::string cut = quoted("a" + std::string(30'000'000, 'b') + "c");
  EXPECT_EQ(cut, "'a" + std::string(59, 'b') + "[... of 30000002 bytes ...]" +
                     std::string(89, 'b') + "c'");
  std::string letters;
  for (int i = 0; i < 100; ++i) {
    letters += "\u00fc";
  }
  // No letter is cut in two: what reads messages wants UTF-8.
  EXPECT_EQ(legible(letters).size(), 60 + std::string("[... of 200 bytes ...]").size() + 90);
  EXPECT_EQ(legible("x" + letters).size(), 59 + std::string("[... of 201 bytes ...]").size() + 90);
}

TEST(Problems, toString_leavesOutWhatIsEmpty) {
  EXPECT_EQ(toString({"", "no links", ""}), "no links");
  EXPECT_EQ(toString({"r.urdf", "no links", ""}), "r.urdf: no links");
}

TEST(Problems, setupError_listsAllProblemsOneALine) {
  const SetupError error({{"a", "b", "c"}, {"d", "e", "f"}});
  EXPECT_STREQ(error.what(), "2 problems in the set-up:\n  a: b; accepted: c\n  d: e; accepted: f");
  EXPECT_EQ(error.problems().size(), 2u);
}

TEST(Problems, setupError_listsAFewOfManyAndHowManyMore) {
  const SetupError error(std::vector<Problem>(100'000, Problem{"a", "b", "c"}));
  const std::string text = error.what();
  EXPECT_EQ(text.substr(text.size() - 14), "and 99950 more");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 51);
  EXPECT_EQ(error.problems().size(), 100'000U);
}

TEST(Problems, failureText_saysInWordsThatMemoryIsMissing) {
  EXPECT_EQ(failureText(std::bad_alloc()).substr(0, 29), "there is not enough memory; f");
  EXPECT_EQ(failureText(std::runtime_error("as it is")), "as it is");
}

TEST(Problems, throwIfErrors_throwsForErrorsOnly) {
  SetupReport report;
  report.warnings.push_back({"a", "b", "c"});
  EXPECT_NO_THROW(throwIfErrors(report));
  report.errors.push_back({"a", "b", "c"});
  EXPECT_THROW(throwIfErrors(report), SetupError);
}

}  // namespace
}  // namespace collision_monitor
