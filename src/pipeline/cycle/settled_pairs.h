// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/near_bodies.h"

/// Pairs that a cycle passes over, since what they say is settled: a warning that stays one, and
/// other pairs of their robots are nearer, touch sooner and ask for a smaller scale.
namespace collision_monitor {

/// Decides which pairs are settled, and notes them in PairEvents::settled.
class SettledPairs {
 public:
  /// Forgets the pairs that were settled.
  SettledPairs(const CycleSetup& setup, const NearBodies& near, CycleBuffers& buffers) noexcept;

  /// Whether the elements of these bodies are settled; then notes their links. Where any pair may be
  /// the nearest, none is.
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

/// Whether the pairs looked at say less than was expected. Then pairs that were passed over may
/// matter.
bool sayLessThanExpected(const RobotSpeeds& robots, const PairEvents& events) noexcept;

/// Expects nothing: the cycle looks at all pairs.
void expectNothing(RobotSpeeds& robots) noexcept;

/// Expects what was found: other pairs can only say less.
void expectFound(RobotSpeeds& robots) noexcept;

/// Expects that the next cycle finds about what this one found. It expects nothing of robots that
/// may be free.
/// @pre measureTold and scaleSpeed were called
void expectNext(RobotSpeeds& robots) noexcept;

}  // namespace collision_monitor
