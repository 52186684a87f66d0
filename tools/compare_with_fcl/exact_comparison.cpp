// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "exact_comparison.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "random_poses.h"
#include "support_fcl/fcl_adapter.h"
#include "support_fcl/solid.h"

namespace collision_monitor {
namespace {

constexpr std::size_t kMostWrong = 100;
constexpr std::uint32_t kNoBudget = 1000000000;

/// A collision element as FCL has it, plus its inside, which FCL does not have.
struct Solid {
  LinkId link;
  Pose link_from_geometry;
  Pose world_from_geometry;
  std::unique_ptr<test::FclObject> object;
  test::Inside inside;
};

Solid makeSolid(LinkId link, const CollisionElement& element) {
  const test::FclGeometry geometry = test::fclGeometryOf(element.geometry);
  if (geometry == nullptr) {
    throw std::runtime_error("collision '" + element.name +
                             "': its mesh has no triangle with an area, which FCL cannot measure");
  }
  return {link,
          element.link_from_geometry,
          {},
          std::make_unique<test::FclObject>(geometry),
          test::insideOf(element.geometry)};
}

enum class Truth { clear, undecided, contact };

test::Holds holdsMarkOf(const Solid& outer, const Solid& inner) {
  return test::holdsMarkOf(outer.inside, outer.world_from_geometry, inner.inside,
                           inner.world_from_geometry);
}

/// Runs one comparison over one robot.
class ExactComparer {
 public:
  explicit ExactComparer(const CycleSetup& setup)
      : setup_(setup),
        enclosing_(makeBuffers(setup, BroadPhaseKind::sweep_and_prune)),
        refined_(makeBuffers(setup, BroadPhaseKind::sweep_and_prune)),
        complete_(makeBuffers(setup, BroadPhaseKind::sweep_and_prune)),
        solids_of_(setup.model.links.size()),
        truths_(setup.checked.size()) {
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

  static Truth truthOf(const Solid& a, const Solid& b) {
    if (!a.object->getAABB().overlap(b.object->getAABB())) {
      return Truth::clear;
    }
    if (test::fclOverlap(*a.object, *b.object).value_or(false)) {
      return Truth::contact;
    }
    const test::Holds holds = std::max(holdsMarkOf(a, b), holdsMarkOf(b, a));
    return holds == test::Holds::yes         ? Truth::contact
           : holds == test::Holds::undecided ? Truth::undecided
                                             : Truth::clear;
  }

  Truth truthOf(const CheckedLinkPair& pair) const {
    Truth truth = Truth::clear;
    for (const Solid& a : solids_of_[index(pair.a)]) {
      for (const Solid& b : solids_of_[index(pair.b)]) {
        truth = std::max(truth, truthOf(a, b));
        if (truth == Truth::contact) {
          return truth;
        }
      }
    }
    return truth;
  }

  /// The same, without a budget.
  void compareComplete(const LinkPoses& poses) {
    if (refined_.counters.left > 0) {
      resetMemory(complete_);
      runCycle(setup_, poses, complete_);
    }
    const CycleBuffers& complete = refined_.counters.left > 0 ? complete_ : refined_;
    for (std::size_t i = 0; i < setup_.checked.size(); ++i) {
      const bool ours = complete.events.verdicts[i] == Verdict::contact;
      const bool is_right = agree(ours, truths_[i]) || isTouch(nearestOf(complete, i));
      result_.complete_wrong += is_right ? 0 : 1;
    }
  }

  static PairDistance nearestOf(const CycleBuffers& buffers, std::size_t i) {
    const std::uint32_t place = buffers.events.closest[i];
    return place == kNone ? PairDistance() : buffers.distances.pairs[place];
  }

  static bool agree(bool is_contact, Truth truth) {
    return truth == Truth::undecided || is_contact == (truth == Truth::contact);
  }

  /// Whether the pair just touches, so that either verdict is right.
  static bool isTouch(const PairDistance& nearest) {
    return std::abs(nearest.measured.distance) <= kTolerance && nearest.quality == Quality::exact;
  }

  void comparePair(std::size_t i) {
    const CheckedLinkPair& pair = setup_.checked[i];
    const Truth truth = truths_[i] = truthOf(pair);
    const bool of_shapes = enclosing_.events.verdicts[i] == Verdict::contact;
    const bool ours = refined_.events.verdicts[i] == Verdict::contact;
    const PairDistance nearest = nearestOf(refined_, i);
    ++result_.pairs;
    result_.contacts += truth == Truth::contact ? 1 : 0;
    result_.undecided += truth == Truth::undecided ? 1 : 0;
    result_.enclosing_contacts += of_shapes ? 1 : 0;
    result_.enclosing_alarms += of_shapes && truth == Truth::clear ? 1 : 0;
    if (agree(ours, truth) || isTouch(nearest)) {
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
  std::vector<Truth> truths_;                  ///< by LinkPairIndex
  ExactComparison result_;
};

}  // namespace

ExactComparison compareExactly(const CycleSetup& setup, const ComparisonOptions& options) {
  ExactComparer comparer(setup);
  forRandomPoses(setup, options, [&](const LinkPoses& poses) { comparer.comparePose(poses); });
  return comparer.result();
}

}  // namespace collision_monitor
