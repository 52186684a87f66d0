// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/number_text.h"

#include <gtest/gtest.h>

#include <clocale>
#include <limits>

namespace collision_monitor {
namespace {

std::string faultOf(const std::string& text) {
  Eigen::VectorXd numbers = Eigen::VectorXd::Constant(3, 7.0);
  const auto fault = parseNumbers(text, numbers);
  if (fault) {
    EXPECT_EQ(numbers, Eigen::VectorXd::Constant(3, 7.0)) << "written in spite of a fault";
  }
  return fault.value_or("");
}

TEST(NumberText, anyWhiteSpaceSeparates) {
  Eigen::VectorXd numbers(3);
  EXPECT_FALSE(parseNumbers(" \n+1.5\t-2e-3   .25 ", numbers));
  EXPECT_EQ(numbers, Eigen::Vector3d(1.5, -0.002, 0.25));
}

TEST(NumberText, faultsNameTheWordOrTheCount) {
  EXPECT_EQ(faultOf("0.1 abc 0.3"), "'abc' is not a number");
  EXPECT_EQ(faultOf("0.1 1,5 0.3"), "'1,5' is not a number");
  EXPECT_EQ(faultOf("0.1 0x1p3 0.3"), "'0x1p3' is not a number");
  EXPECT_EQ(faultOf("0.1 nan 0.3"), "'nan' is not finite");
  EXPECT_EQ(faultOf("-inf 0 0"), "'-inf' is not finite");
  EXPECT_EQ(faultOf("1e999 0 0"), "'1e999' is out of range");
  EXPECT_EQ(faultOf("+-1 0 0"), "'+-1' is not a number");
  EXPECT_EQ(faultOf("0.1m 0 0"), "'0.1m' is not a number");
  const std::string ascii =
      " is not a number (numbers are written in ASCII, with its spaces between them)";
  EXPECT_EQ(faultOf("1\xC2\xA0"
                    "0 0"),
            "'1<U+00A0>0'" + ascii);
  EXPECT_EQ(faultOf("1 \xE2\x88\x92"
                    "2 0"),
            "'<U+2212>2'" + ascii);
  EXPECT_EQ(faultOf("1 \xE9 0"), "'\\xe9'" + ascii);
  EXPECT_EQ(faultOf("1 2"), "2 numbers");
  EXPECT_EQ(faultOf("1"), "1 number");
  EXPECT_EQ(faultOf(""), "0 numbers");
  EXPECT_EQ(faultOf("1 2 3 4"), "4 numbers");
}

TEST(NumberText, numbersAreWrittenShortlyAndReadBackAsTheSame) {
  EXPECT_EQ(shortText(0.05), "0.05");
  EXPECT_EQ(shortText(-1e17), "-1e+17");
  EXPECT_EQ(shortText(30.0), "30");
  EXPECT_EQ(shortText(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(shortText(-2.2250738585072014e-308), "-2.2250738585072014e-308");
  EXPECT_EQ(shortText(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(shortText(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(NumberText, localeWithDecimalComma_changesNothing) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) {
    GTEST_SKIP() << "the locale de_DE.UTF-8 is not installed";
  }
  Eigen::VectorXd numbers(3);
  EXPECT_FALSE(parseNumbers("0.5 1.5 2.5", numbers));
  EXPECT_EQ(numbers, Eigen::Vector3d(0.5, 1.5, 2.5));
  std::setlocale(LC_ALL, before.c_str());
}

}  // namespace
}  // namespace collision_monitor
