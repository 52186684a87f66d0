// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pose_reader_scene.h"

// Links that are known beside each other, wherever they are in the world.
namespace collision_monitor::test {
namespace {

class PoseReaderParts : public PoseReaderTest {
 protected:
  PartId part(const std::string& link) const { return poses_.part[at(link)]; }
  PartId topAt(const std::string& link) const { return static_cast<PartId>(at(link)); }
  bool isJoined(const std::string& one, const std::string& other) const {
    return collision_monitor::isJoined(poses_, *model_.findLink(one), *model_.findLink(other));
  }
};

TEST_F(PoseReaderParts, everythingIsKnown_oneWorld) {
  sendArm(10.0, 0.25);
  read(10.0);
  for (const char* link : {"base", "arm", "wrist", "hand"}) {
    EXPECT_EQ(part(link), kWorldPart) << link;
    EXPECT_EQ(poses_.part_status[at(link)], LinkStatus::known) << link;
  }
}

TEST_F(PoseReaderParts, rootThatNothingPlaces_theRobotFloatsAsOnePart) {
  options_.world_frame = "map";
  sendArm(10.0, 0.25);
  EXPECT_TRUE(read(10.1));
  for (const char* link : {"base", "arm", "wrist", "hand"}) {
    EXPECT_EQ(part(link), topAt("base")) << link;
    EXPECT_EQ(poses_.status[at(link)], LinkStatus::known) << link;
    EXPECT_EQ(poses_.part_status[at(link)], LinkStatus::missing) << link;
  }
  EXPECT_EQ(x("base"), 0.0);
  EXPECT_DOUBLE_EQ(x("hand"), 0.75);
  EXPECT_EQ(age("base"), 0.0) << "the part's own frame";
  EXPECT_NEAR(age("hand"), 0.1, 1e-9);
  EXPECT_EQ(poses_.stamp_ns, 10'000'000'000);
  EXPECT_EQ(explain("hand"), "no transform from 'map' to 'base' yet");
  EXPECT_FALSE(read(10.1)) << "no news";
  sendStatic("map", "base", 3.0);
  EXPECT_TRUE(read(10.1)) << "it is placed";
  EXPECT_EQ(part("hand"), kWorldPart);
  EXPECT_DOUBLE_EQ(x("hand"), 3.75);
}

TEST_F(PoseReaderParts, rootThatIsOld_holdsNobodyBack) {
  options_.world_frame = "map";
  send("map", "base", 10.0, 3.0);
  sendArm(10.0, 0.25);
  read(10.0);
  ASSERT_EQ(part("hand"), kWorldPart);
  sendArm(10.6, 0.5);
  read(10.6);
  EXPECT_EQ(poses_.stamp_ns, 10'600'000'000);
  EXPECT_EQ(part("hand"), topAt("base"));
  EXPECT_EQ(status("hand"), LinkStatus::stale);
  EXPECT_DOUBLE_EQ(x("hand"), 1.5);
  EXPECT_EQ(explain("hand"), "no transform to 'base' for 0.60 s");
}

TEST_F(PoseReaderParts, partThatComesToFloatByAgeAlone_isNews) {
  options_.world_frame = "map";
  send("map", "base", 10.0, 3.0);
  sendStatic("base", "arm", 1.0);
  sendStatic("arm", "wrist", 1.0);
  sendStatic("wrist", "hand", 1.0);
  read(10.1);
  EXPECT_FALSE(read(10.2));
  EXPECT_TRUE(read(10.6));
  EXPECT_EQ(part("hand"), topAt("base"));
  EXPECT_FALSE(read(10.7));
}

TEST_F(PoseReaderParts, brokenInTheMiddle_whatIsBehindFloats) {
  sendArm(10.0, 0.25);
  send("base", "arm", 10.1, std::nan(""));
  send("arm", "wrist", 10.1, 0.5);
  send("wrist", "hand", 10.1, 0.5);
  read(10.1);
  EXPECT_EQ(part("base"), kWorldPart);
  EXPECT_EQ(part("arm"), topAt("arm"));
  EXPECT_EQ(poses_.part_status[at("hand")], LinkStatus::not_finite);
  EXPECT_TRUE(isJoined("arm", "hand"));
  EXPECT_FALSE(isJoined("base", "hand"));
  EXPECT_DOUBLE_EQ(x("hand"), 1.0) << "as seen from the arm";
}

TEST_F(PoseReaderParts, twoFaults_eachPartHasItsReason) {
  options_.world_frame = "map";
  send("base", "arm", 10.0, 0.25);
  send("wrist", "hand", 10.0, 0.25);
  read(10.0);
  EXPECT_TRUE(isJoined("base", "arm"));
  EXPECT_TRUE(isJoined("wrist", "hand"));
  EXPECT_FALSE(isJoined("arm", "wrist"));
  EXPECT_EQ(explain("arm"), "no transform from 'map' to 'base' yet");
  EXPECT_EQ(explain("hand"), "no transform from 'arm' to 'wrist' yet");
}

TEST_F(PoseReaderParts, faultsInARow_areOneCause) {
  options_.world_frame = "map";
  read(10.0);
  EXPECT_EQ(part("hand"), topAt("hand"));
  EXPECT_EQ(explain("hand"), "no transform from 'base' to 'arm' yet");
  EXPECT_EQ(explain("base"), "no transform from 'map' to 'base' yet") << "a cause of its own";
}

TEST_F(PoseReaderParts, linkThatLeadsToNoGeometry_isNoPart) {
  sendArm(10.0, 0.25);
  read(10.0);
  EXPECT_EQ(poses_.status[at("camera")], LinkStatus::missing);
  EXPECT_EQ(part("camera"), kWorldPart);
}

}  // namespace
}  // namespace collision_monitor::test
