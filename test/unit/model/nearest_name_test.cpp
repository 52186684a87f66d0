// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/nearest_name.h"

#include <gtest/gtest.h>

namespace collision_monitor::test {
namespace {

TEST(NearestName, fewestEditsWin) {
  EXPECT_EQ(nearestName("warning_dist", {"rate", "warning_distance", "contact_distance"}),
            "warning_distance");
  EXPECT_EQ(nearestName("rat", {"rate", "max_age"}), "rate");
}

TEST(NearestName, capitalsAreNoEdits) {
  EXPECT_EQ(nearestName("ELBOW_JOINT", {"wrist_joint", "elbow_joint"}), "elbow_joint");
  EXPECT_EQ(nearestName("elbow[1]", {"Elbow[1]"}), "Elbow[1]");
}

TEST(NearestName, nothingNear_isEmpty) {
  EXPECT_EQ(nearestName("colour", {"rate", "max_age"}), "");
  EXPECT_EQ(nearestName("colour", {}), "");
  EXPECT_EQ(suggestion("colour", {"rate"}), "");
}

TEST(NearestName, suggestionIsASentence) {
  EXPECT_EQ(suggestion("elbo", {"elbow"}), ", did you mean 'elbow'?");
  EXPECT_EQ(suggestion("elbow", {"elbow"}), "");  // known as something else, as a frame is
}

}  // namespace
}  // namespace collision_monitor::test
