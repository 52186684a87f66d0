// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/convex_cases.h"

namespace collision_monitor::test {

struct SolidTally {
  long count{0};
  long not_finite{0};
  long wrong{0};
  double error{0.0};  ///< [m] against the other road, apart
};

/// Hulls as meshes against `other`, which is a mesh too where it is a hull: the distance has to be
/// that of the convex geometries, found by another road.
SolidTally stressMeshes(ConvexKind other, long count, const ConvexPoolRecipe& recipe,
                        Random& random);

/// Unions of three spheres against `other`: the least of what its spheres say. Where `other` is a
/// hull it is a mesh, whose depth is an estimate, so that only distances are compared.
SolidTally stressUnions(ConvexKind other, long count, const ConvexPoolRecipe& recipe,
                        Random& random);

/// [m] What an exact answer may be off by for pairs of this size: as docs/accuracy.md says for
/// links, and less sharply where 1 um meets 1 km.
inline double allowedError(double size) { return 1e-9 + (size < 100.0 ? 1e-11 : 1e-10) * size; }

/// [m] Bounds the coordinates of a pair, 10 m at least.
double sizeOf(const PosedConvexPair& pair);

}  // namespace collision_monitor::test
