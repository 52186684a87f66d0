// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/markers/markers.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "pipeline/cycle/run_cycle.h"
#include "unit/ros_edge/draw_markers.h"
#include "unit/ros_edge/edge_scene.h"

namespace collision_monitor::test {
namespace {

class MarkersTest : public testing::Test {
 protected:
  /// base and tool are 0.3 m + reach apart.
  LinkPoses posesAt(double reach) const { return slidingPoses(setup_->setup.model, 0.0, reach); }
  std::unique_ptr<Watch> watch(const LinkPoses& poses) { return judged(setup_, store_, poses); }

  TransformStore store_;
  std::shared_ptr<const MonitorSetup> setup_ = slidingSetup();
};

/// The markers of one array with this namespace and action.
std::size_t count(const visualization_msgs::MarkerArray& array, const std::string& name_space,
                  int action) {
  return static_cast<std::size_t>(std::count_if(
      array.markers.begin(), array.markers.end(), [&](const visualization_msgs::Marker& marker) {
        return marker.ns == name_space && marker.action == action;
      }));
}

TEST_F(MarkersTest, ofAContact_areDeletedWhenItEnds) {
  using visualization_msgs::Marker;
  const auto touching = watch(posesAt(-0.34));
  Markers markers(*touching->fixed);
  const auto first = draw(markers, *touching);
  EXPECT_EQ(first.markers.front().action, Marker::DELETEALL);
  EXPECT_EQ(count(first, "shapes", Marker::ADD), 4U);
  EXPECT_EQ(count(first, "contacts", Marker::ADD), 5U) << "points, and a normal at each corner";
  EXPECT_EQ(count(first, "distances", Marker::ADD), 1U);
  EXPECT_EQ(count(first, "labels", Marker::ADD), 1U);
  for (const Marker& marker : first.markers) {
    EXPECT_EQ(marker.header.stamp, ros::Time(12.5));
    EXPECT_EQ(marker.header.frame_id, "base");
  }
  const auto second = draw(markers, *watch(posesAt(0.25)));
  EXPECT_EQ(count(second, "contacts", Marker::DELETE), 5U);
  EXPECT_EQ(count(second, "contacts", Marker::ADD), 0U);
  const auto third = draw(markers, *watch(posesAt(0.25)));
  EXPECT_EQ(count(third, "contacts", Marker::DELETE), 0U) << "once is enough";
}

TEST_F(MarkersTest, ofAnEstimateOfADepthThatIsAllowed_areThoseOfAContact) {
  const auto watch = estimatedDepth(store_);
  EXPECT_EQ(count(drawFirst(*watch), "contacts", visualization_msgs::Marker::ADD), 5U);
}

TEST_F(MarkersTest, ofAContact_areItsPointsAndNormals) {
  using visualization_msgs::Marker;
  const auto touching = watch(posesAt(-0.34));
  Contacts contacts;
  toMessage(*touching, contacts);
  ASSERT_EQ(contacts.contacts.size(), 1U);
  ASSERT_EQ(contacts.contacts[0].points.size(), 4U) << "two faces";
  Markers markers(*touching->fixed);
  std::vector<int> ids;
  for (const Marker& marker : draw(markers, *touching).markers) {
    if (marker.ns != "contacts") {
      continue;
    }
    ids.push_back(marker.id % 5);
    if (marker.type == Marker::SPHERE_LIST) {
      EXPECT_EQ(marker.points, contacts.contacts[0].points);
    } else {
      ASSERT_EQ(marker.type, Marker::ARROW);
      EXPECT_EQ(marker.points.at(0), contacts.contacts[0].points.at(marker.id % 5 - 1));
      EXPECT_GT(marker.points.at(1).x, marker.points.at(0).x) << "from base to tool";
    }
  }
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(ids, (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST_F(MarkersTest, ofAPairThatHysteresisKeepsInContact_areThoseOfAContact) {
  SetupOptions options;
  options.limits.hysteresis = 0.01;
  setup_ = slidingSetup(options);
  const auto watch = this->watch(posesAt(-0.31));
  runCycle(watch->setup(), posesAt(-0.295), watch->buffers);
  Contacts contacts;
  toMessage(*watch, contacts);
  ASSERT_EQ(contacts.contacts.size(), 1U);
  EXPECT_EQ(count(drawFirst(*watch), "contacts", visualization_msgs::Marker::ADD), 5U);
}

TEST_F(MarkersTest, ofAContactBetweenTwoCycles_areWhereItWas) {
  const auto watch = this->watch(posesAt(0.25));
  watch->poses = posesAt(-1.25);
  watch->poses.stamp_ns += 30'000'000;
  runCycle(watch->setup(), watch->poses, watch->buffers);
  Contacts contacts;
  toMessage(*watch, contacts);
  ASSERT_EQ(contacts.contacts.size(), 1U);
  Markers markers(*watch->fixed);
  const auto array = draw(markers, *watch);
  ASSERT_EQ(count(array, "contacts", visualization_msgs::Marker::ADD), 2U);
  const auto point = std::find_if(array.markers.begin(), array.markers.end(),
                                  [](const auto& marker) { return marker.ns == "contacts"; });
  EXPECT_NEAR(point->points.at(0).x, contacts.contacts[0].points[0].x, 1e-12);
}

TEST_F(MarkersTest, ofAnUnknownLink_areGreyWhereItWasSeen) {
  const auto known = watch(posesAt(0.25));
  Markers markers(*known->fixed);
  draw(markers, *known);
  LinkPoses poses = posesAt(0.25);
  poses.status[index(linkNamed(setup_->setup.model, "tool"))] = LinkStatus::missing;
  poses.world_from_link[index(linkNamed(setup_->setup.model, "tool"))].translation.x() = 9.0;
  const auto array = draw(markers, *watch(poses));
  const std::size_t tool = 2;  // base, slider, tool, finger
  std::size_t seen = 0;
  for (const auto& marker : array.markers) {
    if (marker.ns == "shapes" && marker.id == static_cast<int>(tool)) {
      EXPECT_EQ(marker.color.r, marker.color.g);
      EXPECT_EQ(marker.color.g, marker.color.b);
      EXPECT_NEAR(marker.pose.position.x, 0.75, 1e-12);
      ++seen;
    }
  }
  EXPECT_EQ(seen, 1U);
}

TEST_F(MarkersTest, ofAShape_beginWhenItIsSeenFirst) {
  LinkPoses poses = posesAt(0.25);
  const std::size_t tool = index(linkNamed(setup_->setup.model, "tool"));
  poses.status[tool] = LinkStatus::missing;
  const auto hidden = watch(poses);
  Markers markers(*hidden->fixed);
  EXPECT_EQ(count(draw(markers, *hidden), "shapes", visualization_msgs::Marker::ADD), 3U);
  const auto array = draw(markers, *watch(posesAt(0.25)));
  EXPECT_EQ(count(array, "", visualization_msgs::Marker::DELETEALL), 0U) << "once is enough";
  EXPECT_EQ(count(array, "shapes", visualization_msgs::Marker::ADD), 4U);
  for (const auto& marker : array.markers) {
    if (marker.ns == "shapes" && marker.id == 2) {  // base, slider, tool, finger
      EXPECT_NEAR(marker.pose.position.x, 0.75, 1e-12);
    }
  }
}

/// base, tool and finger side by side at x = 0, 0.16 and 0.1: the labels of finger's two pairs, 0.8
/// m wide, would lie on each other.
TEST_F(MarkersTest, ofPairsSideBySide_haveLabelsAboveEachOther) {
  SetupOptions options;
  options.limits.report_distance = options.limits.warning_distance = 1.0;
  setup_ = slidingSetup(options);
  const auto near = watch(posesAt(-0.34));
  Markers markers(*near->fixed);
  std::vector<visualization_msgs::Marker> labels;
  for (const auto& marker : draw(markers, *near).markers) {
    if (marker.ns == "labels") {
      labels.push_back(marker);
    }
  }
  ASSERT_EQ(labels.size(), 3U);
  EXPECT_EQ(labels[0].text, "-40 mm\nbase - tool");
  EXPECT_EQ(labels[1].text, "800 mm\nbase - finger");
  EXPECT_EQ(labels[2].text, "800 mm\ntool - finger");
  EXPECT_GE(std::abs(labels[1].pose.position.z - labels[2].pose.position.z),
            2.0 * labels[1].scale.z);
  EXPECT_EQ(count(draw(markers, *near), "leaders", visualization_msgs::Marker::ADD), 3U)
      << "from each pair to its label";
}

TEST_F(MarkersTest, ofClearPairs_haveNoLabelButTheClosest) {
  SetupOptions options;
  options.limits.report_distance = 1.0;
  setup_ = slidingSetup(options);
  const auto near = watch(posesAt(-0.34));
  const auto array = drawFirst(*near);
  EXPECT_EQ(count(array, "distances", visualization_msgs::Marker::ADD), 3U);
  EXPECT_EQ(count(array, "labels", visualization_msgs::Marker::ADD), 1U);
}

TEST_F(MarkersTest, ofABound_sayThatItIsOne) {
  const auto near = watch(posesAt(-0.25));
  const auto labelText = [&](Quality quality) {
    near->buffers.distances.pairs.front().quality = quality;
    Markers markers(*near->fixed);
    for (const auto& marker : draw(markers, *near).markers) {
      if (marker.ns == "labels") {
        return marker.text;
      }
    }
    return std::string();
  };
  EXPECT_EQ(labelText(Quality::exact), "50 mm\nbase - tool");
  EXPECT_EQ(labelText(Quality::lower_bound), ">= 50 mm\nbase - tool");
  EXPECT_EQ(labelText(Quality::estimate), "<= 50 mm\nbase - tool");
}

}  // namespace
}  // namespace collision_monitor::test
