// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "pipeline/refine/measure_elements.h"

namespace collision_monitor {

/// The ball about what is measured of an element, in its frame. For set-up.
Ball ballOf(const Element& element);

/// What the last measurement says of two elements now: where neither has moved the same, to the
/// bit. Else distances are lower bounds, less by how far any point of one may have come, seen from
/// the other, and no more than it then takes to be inside an open mesh; they are not complete, and
/// overlaps say nothing.
/// @param balls of a and b.
ElementDistance recallElements(const LastMeasurement& last, const PlacedElement& a,
                               const PlacedElement& b, const std::array<Ball, 2>& balls) noexcept;

/// The last distance, if all that elements have moved since leaves it within a tolerance: the lower
/// bound that is recalled, between the points that were nearest, where they are now. Those of the
/// triangles that were found are no nearer than the elements are.
/// @param recalled what recallElements says. @param tolerance [m] as RefineLimits.
std::optional<ElementDistance> recallWithin(double tolerance, const LastMeasurement& last,
                                            const PlacedElement& a, const PlacedElement& b,
                                            const ElementDistance& recalled) noexcept;

}  // namespace collision_monitor
