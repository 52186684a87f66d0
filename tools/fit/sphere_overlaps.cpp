// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sphere_overlaps.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>

#include "collision_monitor/model/kinematics.h"
#include "collision_monitor/model/pair_rules.h"
#include "narrow_phase/geometry_distance.h"
#include "table.h"

namespace collision_monitor::fit_tool {
namespace {

/// The unions of a link's spheres, one per geometry.
using Unions = std::vector<SphereUnion>;

std::vector<Unions> unionsByLink(const RobotModel& model, const std::vector<LinkSpheres>& spheres) {
  std::vector<Unions> by_link(model.links.size());
  for (const LinkSpheres& of_link : spheres) {
    Unions& unions = by_link[index(*model.findLink(of_link.link))];
    for (const SphereTree& tree : of_link.trees) {
      unions.push_back(makeSphereUnion(tree));
    }
  }
  return by_link;
}

/// Computes distances between the spheres of two links.
class SphereDistances {
 public:
  double operator()(const Unions& a, const Pose& world_from_a, const Unions& b,
                    const Pose& world_from_b) {
    double least = std::numeric_limits<double>::infinity();
    for (const SphereUnion& of_a : a) {
      for (const SphereUnion& of_b : b) {
        const ConvexDistance found =
            signedDistanceBetween(&of_a, world_from_a, &of_b, world_from_b, search_);
        least = std::min(least, found.measured.distance);
      }
    }
    return least;
  }

 private:
  std::unique_ptr<ConvexWorkspace> workspace_ = std::make_unique<ConvexWorkspace>();
  std::unique_ptr<MeshQueryMemory> memory_ = std::make_unique<MeshQueryMemory>();
  ConvexWarmStart warm_;
  ConvexSearch convex_{*workspace_, warm_};
  GeometrySearch search_{convex_, *memory_};
};

}  // namespace

std::vector<Problem> sphereOverlaps(const RobotModel& model,
                                    const std::vector<LinkSpheres>& spheres) {
  const std::vector<Unions> unions = unionsByLink(model, spheres);
  const std::vector<Pose> world_from_link = defaultPoses(model);
  SphereDistances distanceOf;
  std::vector<Problem> overlaps;
  for (const LinkPair& pair : decideLinkPairs(model, {})) {
    const std::size_t a = index(pair.a);
    const std::size_t b = index(pair.b);
    const double distance = isChecked(pair.reason) ? distanceOf(unions[a], world_from_link[a],
                                                                unions[b], world_from_link[b])
                                                   : 0.0;
    if (distance < 0.0) {
      overlaps.push_back(
          {"spheres of '" + model.link(pair.a).name + "' and '" + model.link(pair.b).name + "'",
           "the finest overlap by " + fixed(-1e3 * distance, 1) + " mm in the default pose",
           "more --leaves, or leave out the pair where the spheres are used"});
    }
  }
  return overlaps;
}

}  // namespace collision_monitor::fit_tool
