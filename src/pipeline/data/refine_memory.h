// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "collision_monitor/geometry/ids.h"
#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/narrow_phase/convex_workspace.h"
#include "collision_monitor/narrow_phase/quality.h"
#include "collision_monitor/narrow_phase/signed_distance.h"
#include "collision_monitor/pipeline/element.h"
#include "narrow_phase/mesh/mesh_distance.h"
#include "narrow_phase/mesh_depth/mesh_depth.h"

namespace collision_monitor {

/// The distance of two elements. Quality::unknown: no more than enclosing shapes say.
struct ElementDistance {
  Quality quality{Quality::unknown};
  bool has_points{false};  ///< false: a lower bound without points
  SignedDistance measured;
  double shortfall{0.0};    ///< [m] as MeshDistance::shortfall
  std::uint32_t work{0};    ///< work done of the budget
  bool is_complete{false};  ///< false: a larger budget would have found more
  /// [m] as MeshDistance::outside
  double outside{std::numeric_limits<double>::infinity()};
};

/// Points of two elements. At any poses, the sum of their distance and `error` is an upper bound of
/// the distance of the elements.
struct WitnessPoints {
  Eigen::Vector3d on_a{Eigen::Vector3d::Zero()};          ///< A's frame
  Eigen::Vector3d on_b{Eigen::Vector3d::Zero()};          ///< B's frame
  double error{std::numeric_limits<double>::infinity()};  ///< [m] infinite: none are known
  Quality quality{Quality::unknown};                      ///< of the distance they come from
};

/// The last measurement of a pair of elements, and the poses it was made at.
struct LastMeasurement {
  ElementDistance found;
  Pose world_from_a;
  Pose world_from_b;
  WitnessPoints witness{};  ///< of the last distance with points
};

/// Foretells the answer of a contact test from the last ones.
///
/// Source: a saturating counter, as it predicts branches of programs (Smith 1981).
class ContactForecast {
 public:
  bool isLikely() const noexcept { return score_ >= kLikely; }
  void add(bool is_contact) noexcept {
    score_ = is_contact ? std::min(score_ + 1, kMost) : std::max(score_ - kLoss, 0);
  }

 private:
  // With these, contact is likely where it is seen more than twice as often as not.
  static constexpr std::int32_t kLikely = 6;
  static constexpr std::int32_t kMost = 8;
  static constexpr std::int32_t kLoss = 2;

  std::int32_t score_{0};
};

/// What is kept of the last measurements of a pair of elements, as a warm start of the next one and
/// as a bound where there is none. Takes some thousand bytes, with meshes over ten thousand.
struct RefineMemory {
  ConvexWarmStart warm;
  TrianglePair nearest;
  LastMeasurement last;
  LastMeasurement before;          ///< the one before `last`, at other poses
  MeshFront* front{nullptr};       ///< where a mesh is searched; null: starts at the roots
  ContactForecast triangles_meet;  ///< that a test of few triangles finds a contact
  HeldProbe held{kNone};           ///< as MeshDistance::held, of the last query
  KeptDepth* depth{nullptr};  ///< of two elements with meshes, one or both not convex; keptDepth
  FixedRoom<KeptDepth>* depths{nullptr};  ///< room for `depth`, where there is none yet
};

/// What depths of the pair leave for the next ones; null if they leave nothing. It is large and few
/// pairs overlap, so it is made when it is first asked for.
KeptDepth* keptDepth(RefineMemory& memory) noexcept;

/// The points of a distance that is measured; none of a depth or a bound.
WitnessPoints witnessOf(const LastMeasurement& measurement) noexcept;

/// Keeps a measurement as the last one. Its points replace the older ones if it has any; they are
/// taken from `found`, not from `witness`.
void remember(const LastMeasurement& measurement, RefineMemory& memory) noexcept;

/// Makes the memory as new.
void forget(RefineMemory& memory) noexcept;

/// What a pair of elements keeps, and so what its memory has room for.
enum class RefineKind : unsigned char {
  never,  ///< its bodies are exact: nothing to refine
  plain,
  front,  ///< RefineMemory::front
  depth,  ///< keptDepth
  both,
};

}  // namespace collision_monitor
