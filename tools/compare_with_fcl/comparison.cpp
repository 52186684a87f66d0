// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/measure_pairs.h"
#include "pipeline/cycle/run_cycle.h"
#include "random_poses.h"
#include "support/reference/reference_distance.h"
#include "support_fcl/fcl_adapter.h"

namespace collision_monitor {
namespace {

constexpr std::size_t kMostListed = 100;

struct PosedPair {
  const Body& a;
  const Pose& world_from_a;
  const Body& b;
  const Pose& world_from_b;
};

PosedPair posedPair(const CycleSetup& setup, const BodyPoses& poses, std::size_t pair) {
  const BodyPair& bodies = setup.table.pairs()[pair];
  const std::size_t a = index(bodies.a);
  const std::size_t b = index(bodies.b);
  return {setup.bodies[a], poses.world_from_body[a], setup.bodies[b], poses.world_from_body[b]};
}

std::string kindOf(const PosedPair& pair) {
  std::string a = kindName(pair.a.shape);
  std::string b = kindName(pair.b.shape);
  return a < b ? a + ", " + b : b + ", " + a;
}

/// FCL has no rounded boxes. It gets their cores, and the radii are subtracted from its distance.
Shape withoutRounding(const Shape& shape) {
  const auto* rounded = std::get_if<RoundedBox>(&shape);
  return rounded == nullptr ? shape : Shape(Box{rounded->half_extents});
}

double roundingOf(const Shape& shape) {
  return std::holds_alternative<RoundedBox>(shape) ? radiusOf(shape) : 0.0;
}

/// @return nothing if FCL throws; minus infinity if it finds an overlap, because its verdict is
/// trusted but not its depth.
std::optional<double> fclDistanceOf(const PosedPair& pair) {
  const auto a = test::toFcl(withoutRounding(pair.a.shape), pair.world_from_a);
  const auto b = test::toFcl(withoutRounding(pair.b.shape), pair.world_from_b);
  std::optional<double> distance = test::fclDistance(*a, *b);
  if (distance && *distance <= 0.0) {
    return -std::numeric_limits<double>::infinity();
  }
  if (distance) {
    *distance -= roundingOf(pair.a.shape) + roundingOf(pair.b.shape);
  }
  return distance;
}

double referenceOf(const PosedPair& pair) {
  return test::referenceDistance(pair.a.shape, pair.world_from_a, pair.b.shape, pair.world_from_b)
      .distance;
}

/// Runs one comparison over one robot and keeps state from pose to pose.
class Comparer {
 public:
  Comparer(const CycleSetup& setup, const ComparisonOptions& options)
      : setup_(setup),
        options_(options),
        buffers_(makeBuffers(setup, BroadPhaseKind::sweep_and_prune)),
        least_(setup.checked.size()) {
    for (std::size_t i = 0; i < setup.table.size(); ++i) {
      all_pairs_.push_back(idAt<PairId>(i));
    }
    distances_.pairs.reserve(all_pairs_.size());
  }

  void comparePose(const LinkPoses& poses) {
    resetMemory(buffers_);
    runCycle(setup_, poses, buffers_);
    measurePairs(setup_, buffers_.body_poses, all_pairs_, distances_);
    std::fill(least_.begin(), least_.end(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < all_pairs_.size(); ++i) {
      const double truth = comparePair(i);
      double& least = least_[setup_.link_pair_of[i]];
      least = std::min(least, truth);
    }
    compareVerdicts();
    ++result_.poses;
  }

  Comparison result() const { return result_; }

 private:
  /// @return FCL's distance, or the reference's where FCL cannot be trusted.
  double comparePair(std::size_t i) {
    const PosedPair pair = posedPair(setup_, buffers_.body_poses, i);
    const double ours = distances_.pairs[i].measured.distance;
    KindTally& tally = result_.kinds[kindOf(pair)];
    const std::optional<double> fcl = fclDistanceOf(pair);
    if (!fcl) {
      ++tally.without_fcl;
      return decide(i, pair, std::numeric_limits<double>::quiet_NaN(), tally);
    }
    if (std::isinf(*fcl)) {
      ++tally.overlapping;
      return compareOverlap(i, pair, tally);
    }
    ++tally.separated;
    if (!(std::abs(ours - *fcl) <= kTolerance)) {
      return decide(i, pair, *fcl, tally);
    }
    tally.worst_against_fcl = std::max(tally.worst_against_fcl, std::abs(ours - *fcl));
    return *fcl;
  }

  /// FCL decides that there is an overlap; the reference decides its depth.
  double compareOverlap(std::size_t i, const PosedPair& pair, KindTally& tally) {
    const double ours = distances_.pairs[i].measured.distance;
    if (!(ours <= kTolerance)) {
      return decide(i, pair, std::numeric_limits<double>::quiet_NaN(), tally);
    }
    if (depths_ == options_.most_depths) {
      return ours;
    }
    ++depths_;
    ++tally.depths;
    const double truth = referenceOf(pair);
    tally.worst_depth = std::max(tally.worst_depth, std::abs(ours - truth));
    return truth;
  }

  double decide(std::size_t i, const PosedPair& pair, double fcl, KindTally& tally) {
    const double ours = distances_.pairs[i].measured.distance;
    const double truth = referenceOf(pair);
    const bool for_us = std::abs(ours - truth) <= kTolerance;
    ++(for_us ? tally.decided_for_us : tally.decided_for_fcl);
    if (std::isfinite(fcl)) {
      tally.worst_of_fcl = std::max(tally.worst_of_fcl, std::abs(fcl - truth));
    }
    if (result_.disagreements.size() < kMostListed) {
      result_.disagreements.push_back({setup_.model.link(pair.a.link).name + " - " +
                                           setup_.model.link(pair.b.link).name + " (" +
                                           kindOf(pair) + ")",
                                       ours, fcl, truth});
    }
    return truth;
  }

  void compareVerdicts() {
    const Limits& limits = setup_.limits;
    for (std::size_t i = 0; i < least_.size(); ++i) {
      // A distance within the tolerance of a threshold may be on either side of it.
      const auto verdictAt = [&](double distance) {
        return distance <= limits.contact_distance   ? Verdict::contact
               : distance <= limits.warning_distance ? Verdict::warning
                                                     : Verdict::clear;
      };
      const Verdict ours = buffers_.events.verdicts[i];
      ++result_.verdicts;
      if (ours != verdictAt(least_[i] - kTolerance) && ours != verdictAt(least_[i] + kTolerance)) {
        ++result_.wrong_verdicts;
      }
    }
  }

  const CycleSetup& setup_;
  const ComparisonOptions& options_;
  CycleBuffers buffers_;
  std::vector<PairId> all_pairs_;
  PairDistances distances_;
  std::vector<double> least_;  ///< by LinkPairIndex
  std::size_t depths_{0};
  Comparison result_;
};

}  // namespace

Comparison compareWithFcl(const CycleSetup& setup, const ComparisonOptions& options) {
  Comparer comparer(setup, options);
  forRandomPoses(setup, options, [&](const LinkPoses& poses) { comparer.comparePose(poses); });
  return comparer.result();
}

}  // namespace collision_monitor
