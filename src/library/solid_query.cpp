// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <string>
#include <utility>

#include "library/solid_parts.h"
#include "model/number_text.h"
#include "pipeline/refine/touch_elements.h"

namespace collision_monitor {

/// Scratch, and what the last search of two solids left.
struct SolidWork {
  RefineScratch scratch;
  FrontPool pool{MeshFront::kMostBlocks};
  MeshFront front{pool};
  KeptDepth depth;
  RefineMemory memory;
  std::shared_ptr<const SolidParts> a;
  std::shared_ptr<const SolidParts> b;

  SolidWork() {
    memory.front = &front;
    memory.depth = &depth;
  }

  /// Prepares a search for two solids, from the last one if they are the same.
  ElementSearch searchFor(const Solid& one, const Solid& other) {
    if (a != one.parts_ || b != other.parts_) {
      forget(memory);
      a = one.parts_;
      b = other.parts_;
    }
    return {std::numeric_limits<std::uint32_t>::max(), memory, scratch};
  }
};

namespace {

bool isUsable(const Pose& pose) noexcept {
  return isRigid(pose) && pose.translation.cwiseAbs().maxCoeff() <= kFarthest;
}

SignedDistance unknownDistance() {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3d nowhere = Eigen::Vector3d::Constant(kNaN);
  return {kNaN, nowhere, nowhere, nowhere};
}

/// Searches for the largest depth of two meshes that overlap. Spheres and capsules have no mesh:
/// with them, the depth of inner shapes remains.
void deepen(const PlacedElement& a, const PlacedElement& b, ElementSearch& search,
            SignedDistance& overlap) {
  constexpr std::uint32_t kPoints = 1000;  // a millisecond
  if (a.element.mesh && b.element.mesh) {
    deepenElements(a, b, kPoints, search, overlap);
  }
}

}  // namespace

SolidQuery::SolidQuery() : work_(std::make_unique<SolidWork>()) {}
SolidQuery::~SolidQuery() = default;
SolidQuery::SolidQuery(SolidQuery&& other) noexcept = default;
SolidQuery& SolidQuery::operator=(SolidQuery&& other) noexcept = default;

SolidDistance SolidQuery::distance(const Solid& a, const Pose& world_from_a, const Solid& b,
                                   const Pose& world_from_b, double within) {
  if (!(within > 0.0)) {
    throw ArgumentError({"`within` is " + shortText(within) + " m; accepted: above 0 m"});
  }
  if (!isUsable(world_from_a) || !isUsable(world_from_b)) {
    return {unknownDistance(), Quality::unknown};
  }
  ElementSearch search = work_->searchFor(a, b);
  search.cutoff = within;
  const PlacedElement one{a.parts_->element, world_from_a};
  const PlacedElement other{b.parts_->element, world_from_b};
  ElementDistance found = measureElements(one, other, search);
  if (found.quality == Quality::estimate) {
    deepen(one, other, search, found.measured);
  }
  remember({found, world_from_a, world_from_b}, work_->memory);
  if (!found.has_points) {
    const double bound = found.measured.distance;
    found.measured = unknownDistance();
    found.measured.distance = found.quality == Quality::unknown ? found.measured.distance : bound;
  }
  return {found.measured, found.quality};
}

bool SolidQuery::collide(const Solid& a, const Pose& world_from_a, const Solid& b,
                         const Pose& world_from_b) {
  std::vector<std::string> faults;
  for (const auto& [name, pose] :
       {std::pair("world_from_a", &world_from_a), std::pair("world_from_b", &world_from_b)}) {
    if (!isUsable(*pose)) {
      faults.push_back(std::string("`") + name +
                       "` is not rigid, not finite or beyond 1e9 m; accepted: a rotation and a "
                       "translation");
    }
  }
  if (!faults.empty()) {
    throw ArgumentError(std::move(faults));
  }
  ElementSearch search = work_->searchFor(a, b);
  // Without a budget every search ends. Should one not, the solids count as touching.
  return touchElements({a.parts_->element, world_from_a}, {b.parts_->element, world_from_b},
                       contactAlone(0.0), search)
             .state != ElementContact::State::apart;
}

}  // namespace collision_monitor
