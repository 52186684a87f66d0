// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "pipeline/refine/measure_elements.h"

namespace collision_monitor {

/// The ball around the measured geometry of an element, in the element frame. For set-up.
Ball ballOf(const Element& element);

/// What the last measurement says of two elements now. It is returned as it is if neither pose has
/// changed by a bit. Otherwise a distance becomes a lower bound that is not complete: the last
/// distance, but at most MeshDistance::outside, minus the motion of one relative to the other.
/// Overlaps then say nothing.
/// @param balls of a and b.
ElementDistance recallElements(const LastMeasurement& last, const PlacedElement& a,
                               const PlacedElement& b, const std::array<Ball, 2>& balls) noexcept;

/// A lower bound between the last witness points, carried to the poses now. Their distance is an
/// upper bound of that of the elements: `shortfall` says how much larger it is. Nothing where no
/// points are known, where the bound is not above 0, or for two convex elements, which are measured
/// as fast.
/// @param bound [m] of the distance from below
std::optional<ElementDistance> recallPoints(const WitnessPoints& last, const PlacedElement& a,
                                            const PlacedElement& b, double bound) noexcept;

/// The last depth of elements that still overlap plus their motion since, with points carried to
/// the poses now. They may also just touch, so `shortfall` is the same sum. Nothing if the depth
/// was not that of meshes, or if the motion is more than half of it. Error: as that of depths.
/// @param balls of a and b.
std::optional<ElementDistance> recallOverlap(const LastMeasurement& last, const PlacedElement& a,
                                             const PlacedElement& b,
                                             const std::array<Ball, 2>& balls) noexcept;

}  // namespace collision_monitor
