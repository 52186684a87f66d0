// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "pipeline/trajectory/check_trajectory.h"
#include "pipeline/trajectory/link_pair_distance.h"
#include "support/robots/geometry_setup.h"
#include "support/robots/urdf_text.h"
#include "support/sample_meshes.h"
#include "unit/pipeline/refine/refine_scene.h"

// How little is searched for on the way of links, and what is told of them all the same.
namespace collision_monitor::test {
namespace {

std::string objOf(const TriangleMesh& mesh) {
  std::ostringstream text;
  for (const Eigen::Vector3d& v : mesh.vertices) {
    text << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  }
  for (const auto& t : mesh.triangles) {
    text << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
  return text.str();
}

/// Balls of 0.1 m and 2,000 triangles each.
TriangleMesh balls(const std::vector<Eigen::Vector3d>& centers) {
  TriangleMesh mesh;
  for (const Eigen::Vector3d& center : centers) {
    mesh = joined(mesh, moved(sphereMesh(0.1, 46), Eigen::Vector3d::Zero(), center));
  }
  return mesh;
}

/// What encloses one of them twice, one over the other, tells how far they are apart.
const std::vector<Eigen::Vector3d> kDumbBell = {{0.2, 0.2, 0.0}, {-0.2, -0.2, 0.0}};
/// Neither shapes nor hulls do, which overlap.
const std::vector<Eigen::Vector3d> kThreeBalls = {
    {0.2, 0.2, 0.0}, {-0.2, -0.2, 0.0}, {0.2, -0.2, -0.25}};

/// A mesh twice, one 0.2 m and a gap over the other. The upper one slides by 0.4 m along x.
class OverEachOther {
 public:
  OverEachOther(const std::vector<Eigen::Vector3d>& centers, double gap)
      : setup_(buildSetup(
            {describeText(robotXml(
                linkXml("lower", kMesh) +
                linkXml("carriage", "<sphere radius='0.01'/>", "<origin xyz='0 0 9'/>") +
                linkXml("upper", kMesh) + slide("lift", "lower", "carriage", "0 0 1", 0.2 + gap) +
                slide("slide", "carriage", "upper", "1 0 0", 0.0)))},
            textLoader({{"package://p/balls.obj", objOf(balls(centers))}}), options())) {
    for (int i = 0; i <= 20; ++i) {
      path_.times.push_back(i);
      path_.positions.push_back(0.02 * i);
    }
    path_.joints = {*setup_.model.findJoint("slide")};
  }

  TrajectoryReport check(double margin) const {
    LinkPoses start = makeLinkPoses(setup_.model);
    placeLinks(setup_.model, defaultPositions(setup_.model), {Pose()}, start.world_from_link);
    std::fill(start.status.begin(), start.status.end(), LinkStatus::known);
    TrajectoryOptions options;
    options.margin = margin;
    return checkTrajectory(setup_, path_, start, options);
  }

 private:
  static constexpr const char* kMesh = "<mesh filename='package://p/balls.obj'/>";

  static SetupOptions options() {
    SetupOptions options = optionsFor(RefineGeometry::mesh);
    options.ignore_default_overlap = false;
    return options;
  }
  static std::string slide(const std::string& name, const std::string& parent,
                           const std::string& child, const std::string& axis, double height) {
    return jointXml(name, "prismatic", parent, child,
                    "<origin xyz='0 0 " + std::to_string(height) + "'/><axis xyz='" + axis +
                        "'/><limit lower='-1' upper='1' velocity='1' effort='1'/>");
  }

  CycleSetup setup_;
  JointPath path_;
};

constexpr double kStored = 1e-8;  ///< [m] Corners of meshes are stored as floats.

const PairApproach& nearestOf(const TrajectoryReport& report) {
  return *std::min_element(report.pairs.begin(), report.pairs.end(),
                           [](const PairApproach& one, const PairApproach& other) {
                             return one.at_least < other.at_least;
                           });
}

TEST(TrajectoryWork, nearMiss_isFoundWhereItIsNearest) {
  const TrajectoryReport report = OverEachOther(kThreeBalls, 0.03).check(0.05);
  const PairApproach& found = nearestOf(report);
  EXPECT_EQ(found.state, ApproachState::clear);
  EXPECT_EQ(found.nearest.quality, Quality::exact);
  EXPECT_NEAR(found.nearest.measured.distance, 0.03, kStored);
  EXPECT_GE(found.at_least, 0.029 - kStored);
}

TEST(TrajectoryWork, contactsAlone_nearestIsABoundThatIsProven) {
  const TrajectoryReport report = OverEachOther(kThreeBalls, 0.03).check(0.0);
  const PairApproach& found = nearestOf(report);
  EXPECT_EQ(found.state, ApproachState::clear);
  EXPECT_EQ(found.nearest.quality, Quality::lower_bound);
  EXPECT_TRUE(found.nearest.is_raised);
  EXPECT_GT(found.at_least, 0.0);
  EXPECT_GE(found.nearest.measured.distance, found.at_least);
  EXPECT_LE(found.nearest.measured.distance, 0.03);
  EXPECT_LT(report.work, 1000U) << "19,000 if distances are exact";
}

TEST(TrajectoryWork, beyondTheMargin_isMeasuredOnce) {
  const TrajectoryReport report = OverEachOther(kThreeBalls, 0.06).check(0.02);
  const PairApproach& found = nearestOf(report);
  EXPECT_EQ(found.nearest.quality, Quality::exact);
  EXPECT_GE(found.nearest.measured.distance, 0.06 - kStored);
  EXPECT_GE(found.at_least, 0.02);
  EXPECT_LT(report.work, 14000U) << "twice as many if all way-points are measured";
}

TEST(TrajectoryWork, contact_isFoundThoughNothingIsMeasuredBefore) {
  const TrajectoryReport report = OverEachOther(kDumbBell, -0.05).check(0.0);
  EXPECT_EQ(nearestOf(report).state, ApproachState::contact);
  EXPECT_EQ(nearestOf(report).time, 0.0);
}

/// Links of 1 cm in a row, with an angle at both ends.
CycleSetup chainOf(int count) {
  const char* const angle = "<mesh filename='package://p/angle.obj'/>";
  std::string xml = linkXml("l0", angle);
  for (int i = 1; i <= count; ++i) {
    const std::string link = "l" + std::to_string(i);
    xml += i == count       ? linkXml(link, angle)
           : i == count / 2 ? linkXml(link, "<sphere radius='0.01'/>", "<origin xyz='0 0 9'/>")
                            : "<link name='" + link + "'/>";
    xml += jointXml("j" + std::to_string(i), "continuous", "l" + std::to_string(i - 1), link,
                    "<origin xyz='0 0 0.01'/><axis xyz='" +
                        std::string(i % 2 == 0 ? "1 0 0" : "0 1 0") + "'/>");
  }
  SetupOptions options = optionsFor(RefineGeometry::mesh);
  options.ignore_default_overlap = false;
  return buildSetup({describeText(robotXml(xml))},
                    textLoader({{"package://p/angle.obj", objOf(angleMesh())}}), options);
}

/// The joint at the root stands still, and the others make more way than a number holds.
TEST(TrajectoryWork, turnsThatOverflow_proveNothing) {
  constexpr std::size_t kLinks = 40;
  const CycleSetup setup = chainOf(kLinks);
  ASSERT_EQ(setup.checked.size(), 1U);
  JointPath path;
  path.times = {0.0, 1.0};
  for (std::size_t i = 1; i <= kLinks; ++i) {
    path.joints.push_back(*setup.model.findJoint("j" + std::to_string(i)));
  }
  path.positions.assign(kLinks + 1, 0.0);
  path.positions.resize(2 * kLinks, 1e9);
  LinkPoses start = makeLinkPoses(setup.model);
  placeLinks(setup.model, defaultPositions(setup.model), {Pose()}, start.world_from_link);
  std::fill(start.status.begin(), start.status.end(), LinkStatus::known);
  TrajectoryOptions options;
  options.budget = 100'000;
  const TrajectoryReport report = checkTrajectory(setup, path, start, options);
  EXPECT_NE(report.pairs[0].state, ApproachState::clear);
}

TEST(HullDistance, hullsThatAreNearestOnTheGeometries_tellTheirDistance) {
  RefineScene scene({angleMesh(), angleMesh()});
  scene.poses.world_from_link[1].translation = Eigen::Vector3d(0.35, 0.0, 0.02);
  LinkPairMeasures measures(scene.setup);
  const auto distance = [&](double cutoff) {
    return hullDistance(measures, 0, scene.poses.world_from_link, cutoff);
  };
  EXPECT_TRUE(distance(1.0).is_refined);
  EXPECT_EQ(distance(1.0).quality, Quality::exact);
  EXPECT_NEAR(distance(1.0).measured.distance, 0.05, 1e-12);
  EXPECT_FALSE(distance(0.02).is_refined);
  EXPECT_GE(distance(0.02).measured.distance, 0.02);
}

TEST(HullDistance, hullsThatAreNearer_areABound) {
  RefineScene scene({angleMesh(), Sphere{0.02}});
  // Off the middle of the long side of the hull, which no bar is near.
  scene.poses.world_from_link[1].translation = Eigen::Vector3d(0.25, 0.25, 0.0);
  LinkPairMeasures measures(scene.setup);
  const PairDistance found = hullDistance(measures, 0, scene.poses.world_from_link, 1.0);
  EXPECT_FALSE(found.is_refined);
  EXPECT_EQ(found.quality, Quality::lower_bound);
  EXPECT_NEAR(found.measured.distance, 0.1 * std::sqrt(0.5) - 0.02, 1e-9);
  EXPECT_GT(elementDistance(measures, 0, scene.poses.world_from_link).measured.distance,
            found.measured.distance + 0.05);
}

TEST(ElementDistance, bodiesThatAreTighterThanAHull_areTheBound) {
  SetupOptions options = optionsFor(RefineGeometry::hull);
  options.default_limits.max_shapes = 4;
  RefineScene scene({angleMesh(), Sphere{0.02}}, options);
  scene.poses.world_from_link[1].translation = Eigen::Vector3d(0.25, 0.25, 0.0);
  LinkPairMeasures measures(scene.setup);
  const double of_bodies = bodyDistance(measures, 0, scene.poses.world_from_link).measured.distance;
  const double of_hulls = 0.1 * std::sqrt(0.5) - 0.02;
  ASSERT_GT(of_bodies, of_hulls + 0.01);
  EXPECT_EQ(elementDistance(measures, 0, scene.poses.world_from_link).measured.distance, of_bodies);
}

}  // namespace
}  // namespace collision_monitor::test
