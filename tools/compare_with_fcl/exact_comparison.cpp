// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "exact_comparison.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>

#include "collision_monitor/geometry/mesh_tree.h"
#include "collision_monitor/geometry/winding.h"
#include "collision_monitor/pipeline/run_cycle.h"
#include "fitting/closed_surface.h"
#include "random_poses.h"
#include "support_fcl/fcl_adapter.h"
#include "support_fcl/fcl_mesh.h"

namespace collision_monitor {
namespace {

constexpr std::size_t kMostWrong = 100;
constexpr std::uint32_t kNoBudget = 1000000000;

struct MakeFcl {
  template <class Primitive>
  test::FclGeometry operator()(const Primitive& primitive) const {
    return test::toFclGeometry(primitive);
  }
  test::FclGeometry operator()(const TriangleMesh& mesh) const { return test::toFcl(mesh); }
};

/// Points of a geometry of which one is inside whatever it is inside of. Into a closed surface that
/// it does not meet any would do; into an open one it may reach with some of them.
struct MarkPoints {
  using Points = std::vector<Eigen::Vector3d>;

  Points operator()(const TriangleMesh& mesh) const { return MeshTree(mesh).probes(); }
  Points operator()(const Sphere&) const { return {Eigen::Vector3d::Zero()}; }
  Points operator()(const Capsule& capsule) const { return box(0.0, capsule.half_length); }
  Points operator()(const Cylinder& c) const {
    return box(std::sqrt(0.5) * c.radius, c.half_length);
  }
  Points operator()(const Box& shape) const {
    Points points = box(1.0, 1.0);
    for (Eigen::Vector3d& point : points) {
      point = point.cwiseProduct(shape.half_extents);
    }
    return points;
  }

 private:
  static Points box(double width, double height) {
    Points points;
    for (int corner = 0; corner < 8; ++corner) {
      points.emplace_back((corner & 1) != 0 ? width : -width, (corner & 2) != 0 ? width : -width,
                          (corner & 4) != 0 ? height : -height);
    }
    return points;
  }
};

/// A collision element as FCL has it, and what FCL does not know: its inside.
struct Solid {
  LinkId link;
  Pose link_from_geometry;
  Pose world_from_geometry;
  std::unique_ptr<test::FclObject> object;
  std::optional<TriangleBvh> surface;  ///< that goes around its inside
  std::vector<Eigen::Vector3d> marks;
};

Solid makeSolid(LinkId link, const CollisionElement& element) {
  const auto* mesh = std::get_if<TriangleMesh>(&element.geometry);
  if (mesh != nullptr && mesh->triangles.empty()) {
    throw std::runtime_error("collision '" + element.name +
                             "': its mesh has no triangle with an area, which FCL cannot measure");
  }
  Solid solid{link, element.link_from_geometry, {}, nullptr, std::nullopt, {}};
  solid.marks = std::visit(MarkPoints(), element.geometry);
  solid.object = std::make_unique<test::FclObject>(std::visit(MakeFcl{}, element.geometry));
  if (mesh != nullptr) {
    const auto closed = closedSurface(*mesh);
    solid.surface.emplace(closed ? *closed : orientedSurface(*mesh));
  }
  return solid;
}

// Most points are not even in the box of the surface, all of whose triangles count.
bool holds(const TriangleBvh& surface, const Eigen::Vector3d& point) {
  return meets(surface.bounds(), {point, point}) && std::abs(windingNumber(surface, point)) > 0.5;
}

bool holdsMarkOf(const Solid& outer, const Solid& inner) {
  const Pose outer_from_inner = inverse(outer.world_from_geometry) * inner.world_from_geometry;
  return outer.surface &&
         std::any_of(inner.marks.begin(), inner.marks.end(), [&](const Eigen::Vector3d& mark) {
           return holds(*outer.surface, outer_from_inner * mark);
         });
}

/// One run over one robot.
class ExactComparer {
 public:
  explicit ExactComparer(const CycleSetup& setup)
      : setup_(setup),
        enclosing_(makeBuffers(setup, BroadPhaseKind::sweep_and_prune)),
        refined_(makeBuffers(setup, BroadPhaseKind::sweep_and_prune)),
        complete_(makeBuffers(setup, BroadPhaseKind::sweep_and_prune)),
        solids_of_(setup.model.links.size()),
        is_contact_(setup.checked.size()) {
    enclosing_.refine.limits.budget = 0;
    complete_.refine.limits.budget = kNoBudget;
    for (std::size_t i = 0; i < setup.model.links.size(); ++i) {
      for (const CollisionElement& element : setup.model.links[i].collisions) {
        solids_of_[i].push_back(makeSolid(idAt<LinkId>(i), element));
      }
    }
  }

  void comparePose(const LinkPoses& poses) {
    resetMemory(enclosing_);
    std::fill(refined_.memory.reported.begin(), refined_.memory.reported.end(), Verdict::clear);
    runCycle(setup_, poses, enclosing_);
    runCycle(setup_, poses, refined_);
    place(poses);
    for (std::size_t i = 0; i < setup_.checked.size(); ++i) {
      comparePair(i);
    }
    result_.left += refined_.counters.left;
    ++result_.poses;
    compareComplete(poses);
  }

  const ExactComparison& result() const { return result_; }

 private:
  void place(const LinkPoses& poses) {
    for (std::size_t i = 0; i < solids_of_.size(); ++i) {
      for (Solid& solid : solids_of_[i]) {
        solid.world_from_geometry = poses.world_from_link[i] * solid.link_from_geometry;
        solid.object->setTransform(solid.world_from_geometry.rotation,
                                   solid.world_from_geometry.translation);
        solid.object->computeAABB();
      }
    }
  }

  bool isContact(const CheckedLinkPair& pair) const {
    for (const Solid& a : solids_of_[index(pair.a)]) {
      for (const Solid& b : solids_of_[index(pair.b)]) {
        if (a.object->getAABB().overlap(b.object->getAABB()) &&
            (test::fclOverlap(*a.object, *b.object).value_or(false) || holdsMarkOf(a, b) ||
             holdsMarkOf(b, a))) {
          return true;
        }
      }
    }
    return false;
  }

  /// The same without a budget.
  void compareComplete(const LinkPoses& poses) {
    if (refined_.counters.left > 0) {
      resetMemory(complete_);
      runCycle(setup_, poses, complete_);
    }
    const CycleBuffers& complete = refined_.counters.left > 0 ? complete_ : refined_;
    for (std::size_t i = 0; i < setup_.checked.size(); ++i) {
      const bool ours = complete.events.verdicts[i] == Verdict::contact;
      result_.complete_wrong += ours != is_contact_[i] && !isTouch(nearestOf(complete, i)) ? 1 : 0;
    }
  }

  static PairDistance nearestOf(const CycleBuffers& buffers, std::size_t i) {
    const std::uint32_t place = buffers.events.closest[i];
    return place == kNone ? PairDistance() : buffers.distances.measured[place];
  }

  /// Right either way.
  static bool isTouch(const PairDistance& nearest) {
    return std::abs(nearest.measured.distance) <= kTolerance && nearest.quality == Quality::exact;
  }

  void comparePair(std::size_t i) {
    const CheckedLinkPair& pair = setup_.checked[i];
    const bool is_contact = is_contact_[i] = isContact(pair);
    const bool of_shapes = enclosing_.events.verdicts[i] == Verdict::contact;
    const bool ours = refined_.events.verdicts[i] == Verdict::contact;
    const PairDistance nearest = nearestOf(refined_, i);
    ++result_.pairs;
    result_.contacts += is_contact ? 1 : 0;
    result_.enclosing_contacts += of_shapes ? 1 : 0;
    result_.enclosing_alarms += of_shapes && !is_contact ? 1 : 0;
    if (ours == is_contact || isTouch(nearest)) {
      return;
    }
    if (ours && nearest.quality == Quality::lower_bound) {
      ++result_.refined_alarms;
      return;
    }
    ++(ours ? result_.wrong_contacts : result_.missed);
    if (result_.wrong.size() < kMostWrong) {
      result_.wrong.push_back(setup_.model.link(pair.a).name + " - " +
                              setup_.model.link(pair.b).name + ": ours " +
                              std::to_string(nearest.measured.distance) + " m, quality " +
                              std::to_string(static_cast<int>(nearest.quality)) + ", pose " +
                              std::to_string(result_.poses));
    }
  }

  const CycleSetup& setup_;
  CycleBuffers enclosing_;
  CycleBuffers refined_;
  CycleBuffers complete_;
  std::vector<std::vector<Solid>> solids_of_;  ///< by LinkId
  std::vector<bool> is_contact_;               ///< in truth, by LinkPairIndex
  ExactComparison result_;
};

}  // namespace

ExactComparison compareExactly(const CycleSetup& setup, const ComparisonOptions& options) {
  ExactComparer comparer(setup);
  forRandomPoses(setup, options, [&](const LinkPoses& poses) { comparer.comparePose(poses); });
  return comparer.result();
}

}  // namespace collision_monitor
