// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/near_bodies.h"

/// Pairs that a cycle passes over while nobody listens to all distances. Their verdict is proven to
/// stay a warning, or clear, and other pairs of their robots are proven to be nearer, to touch
/// sooner and to ask for a smaller scale.
///
/// How near, how soon and how slow those are is known only after they are measured. So a cycle
/// begins with what it expects by the last one (RobotSpeeds::expected). If it finds that the
/// nearest pair is farther, the soonest later or the slowest faster than that, it measures once
/// more with what it found as a limit.
namespace collision_monitor {

/// Decides which pairs are passed over. Notes those that are warnings in PairEvents::settled.
class SettledPairs {
 public:
  /// Forgets the pairs that were settled.
  SettledPairs(const CycleSetup& setup, const NearBodies& near, CycleBuffers& buffers) noexcept;

  /// Whether two elements are passed over; then notes their links. While nothing is expected of
  /// their robots, they are not.
  bool passOver(const ElementsPlace& pair) noexcept;

 private:
  bool isSettled(const ElementsPlace& pair) noexcept;
  /// Whether the pair is proven to be farther than `limit` and, if it is a warning, to stay one.
  bool isProven(const ElementsPlace& pair, double limit, double travel) const noexcept;
  /// Improves what is known of the elements by how they have moved relative to each other.
  void recall(const ElementsPlace& pair, double travel) noexcept;
  /// [m] Beyond this the pair says nothing new.
  double limitOf(const ElementsPlace& pair) const noexcept;

  /// [m] Beyond this other pairs touch sooner and ask for a smaller scale.
  double reachOf(const ElementsPlace& pair) const noexcept;

  const CycleSetup& setup_;
  const NearBodies& near_;
  CycleBuffers& buffers_;
  PairMemory& memory_;
  const RobotSpeeds& robots_;
  PairEvents& events_;
};

/// Keeps what the measured distances prove for the next cycles.
void keepProven(const CycleSetup& setup, CycleBuffers& buffers) noexcept;

/// Whether the nearest pair of a robot is farther, its soonest later or its slowest faster than
/// expected. Then a pair that was passed over may be the one to tell.
/// @pre measureTold was called
bool isMoreThanExpected(const CycleSetup& setup, const RobotSpeeds& robots,
                        const PairEvents& events) noexcept;

/// Expects nothing: the cycle looks at all pairs.
void expectNothing(RobotSpeeds& robots) noexcept;

/// Expects what was found. Measuring more pairs can only find nearer, sooner and slower ones.
void expectFound(const CycleSetup& setup, RobotSpeeds& robots) noexcept;

/// Expects of the next cycle about what this one found. Expects nothing of a robot whose speed
/// scale may jump to 1, which takes a look at all pairs, nor of one without a pair in reach.
/// @pre measureTold and scaleSpeed were called
void expectNext(const CycleSetup& setup, RobotSpeeds& robots) noexcept;

}  // namespace collision_monitor
