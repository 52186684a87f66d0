// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "stress_solids.h"

// stress_pairs COUNT SEED: random and degenerate pairs of every two kinds of convex geometry, each
// answer held to what proves it; meshes and unions of spheres, held to another road. Prints a table
// and the worst case; exits 1 when an answer was NaN, inconsistent, or claimed to be exact or a
// bound and was not by its own certificate.
namespace collision_monitor::test {
namespace {

constexpr std::size_t kPool = 24;

struct Tally {
  long count{0};
  long not_finite{0};
  long bounds{0};  ///< lower bounds: searches that could not settle
  long wrong{0};
  double gap_error{0.0};     ///< exact answers against the gap along their own normal
  double outside{0.0};       ///< of witness points, relative to sizes
  double joined_error{0.0};  ///< point_on_b - point_on_a against distance * normal
};

// Points on curved surfaces are found to half the digits that distances are.
double allowedOutside(double size) { return 1e-6 * size; }

/// Sphere, capsule, box, rounded box.
bool isOfFamily(const ConvexGeometry& geometry) { return geometry.index() <= 3; }

bool isFiniteAnswer(const SignedDistance& found) {
  return std::isfinite(found.distance) && found.point_on_a.allFinite() &&
         found.point_on_b.allFinite() && found.normal_a_to_b.allFinite();
}

void judge(const PosedConvexPair& pair, const ConvexDistance& answer, Tally& tally) {
  const SignedDistance& found = answer.measured;
  ++tally.count;
  if (!isFiniteAnswer(found)) {
    ++tally.not_finite;
    return;
  }
  const double size = sizeOf(pair);
  const ConvexCertificate proof = certify(pair, found);
  const double joined =
      (found.point_on_b - found.point_on_a - found.distance * found.normal_a_to_b).norm();
  tally.joined_error = std::max(tally.joined_error, joined);
  const bool is_exact = answer.quality == Quality::exact;
  tally.bounds += is_exact ? 0 : 1;
  // Closed forms promise lengths up to 10 m. Over a kilometre their distance is exact, and their
  // normal less so where cores all but touch.
  const bool is_promised = size < 100.0 || !isOfFamily(*pair.a) || !isOfFamily(*pair.b);
  const double error = is_promised ? std::abs(found.distance - proof.gap_along_normal) : 0.0;
  const double outside = is_exact ? std::max({proof.a_outside, proof.b_outside, 0.0}) : 0.0;
  tally.gap_error = std::max(tally.gap_error, error);
  tally.outside = std::max(tally.outside, outside);
  const double allowed = allowedError(size);
  if (error > allowed || joined > allowed || outside > allowedOutside(size)) {
    ++tally.wrong;
    std::printf("distance %.17g, gap %.17g, outside %.3g %.3g, quality %d\n%s", found.distance,
                proof.gap_along_normal, proof.a_outside, proof.b_outside,
                static_cast<int>(answer.quality), describe(pair).c_str());
  }
}

struct Scene {
  ConvexKind a;
  ConvexKind b;
  long count;
  ConvexPoolRecipe recipe;
};

Tally run(const Scene& scene, Random& random) {
  const auto pool_a = makeConvexPool(scene.a, kPool, scene.recipe, random);
  const auto pool_b = makeConvexPool(scene.b, kPool, scene.recipe, random);
  static ConvexWorkspace workspace;
  Tally tally;
  for (long i = 0; i < scene.count; ++i) {
    const auto pick = static_cast<std::size_t>(i);
    const PosedConvexPair pair =
        placeConvexPair(pool_a[random() % kPool], pool_b[random() % kPool], kNearnesses[pick % 4],
                        kAlignments[(pick / 4) % 3], random);
    ConvexWarmStart warm;
    ConvexSearch search{workspace, warm};
    judge(pair,
          signedDistanceBetween(*pair.a, pair.world_from_a, *pair.b, pair.world_from_b, search),
          tally);
  }
  return tally;
}

constexpr ConvexPoolRecipe kRecipes[] = {
    {1e-3, 5.0, false}, {1e-3, 5.0, true}, {1e-6, 1e-3, true}, {1e-6, 1e3, true}};
constexpr const char* kRecipeNames[] = {"links", "degenerate", "tiny", "mixed"};
constexpr long kConvexScenes = 4 * 27;  // two half spaces have no distance
constexpr long kSolidScenes = 4 * 14;
constexpr long kMeshShare = 10;  // a pair with a mesh takes that many times longer

struct Total {
  long count{0};
  long bounds{0};
  long faults{0};
  double gap_error{0.0};
  double outside{0.0};
  double solid_error{0.0};
};

void runConvex(long count, Random& random, Total& total) {
  std::printf("%-24s %-10s %9s %7s %7s %7s %9s %9s %9s\n", "pair", "sizes", "count", "NaN",
              "bounds", "wrong", "gap", "outside", "joined");
  for (const ConvexKind a : kConvexKinds) {
    for (const ConvexKind b : kConvexKinds) {
      if (b < a || a == ConvexKind::half_space) {
        continue;
      }
      for (std::size_t r = 0; r < 4; ++r) {
        const Tally tally = run({a, b, std::max(1L, count / kConvexScenes), kRecipes[r]}, random);
        total.count += tally.count;
        total.bounds += tally.bounds;
        total.faults += tally.not_finite + tally.wrong;
        total.gap_error = std::max(total.gap_error, tally.gap_error);
        total.outside = std::max(total.outside, tally.outside);
        std::printf("%-11s %-12s %-10s %9ld %7ld %7ld %7ld %9.1e %9.1e %9.1e\n", nameOf(a),
                    nameOf(b), kRecipeNames[r], tally.count, tally.not_finite, tally.bounds,
                    tally.wrong, tally.gap_error, tally.outside, tally.joined_error);
      }
    }
  }
}

void runSolids(long count, Random& random, Total& total) {
  const long each = std::max(1L, count / kMeshShare / kSolidScenes);
  std::printf("%-24s %-10s %9s %7s %7s %9s\n", "pair", "sizes", "count", "NaN", "wrong", "error");
  for (const bool is_mesh : {true, false}) {
    for (const ConvexKind other : kConvexKinds) {
      for (std::size_t r = 0; r < 4; ++r) {
        const SolidTally tally = is_mesh ? stressMeshes(other, each, kRecipes[r], random)
                                         : stressUnions(other, each, kRecipes[r], random);
        total.count += tally.count;
        total.faults += tally.not_finite + tally.wrong;
        total.solid_error = std::max(total.solid_error, tally.error);
        std::printf("%-11s %-12s %-10s %9ld %7ld %7ld %9.1e\n", is_mesh ? "mesh" : "spheres",
                    other == ConvexKind::hull ? "mesh" : nameOf(other), kRecipeNames[r],
                    tally.count, tally.not_finite, tally.wrong, tally.error);
      }
    }
  }
}

int runAll(long count, std::uint64_t seed) {
  Random random(seed);
  Total total;
  runConvex(count, random, total);
  runSolids(count, random, total);
  std::printf(
      "%ld pairs, %ld bounds, worst gap %.1e, worst point %.1e, worst of meshes and spheres "
      "%.1e, %ld faults\n",
      total.count, total.bounds, total.gap_error, total.outside, total.solid_error, total.faults);
  return total.faults == 0 ? 0 : 1;
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: stress_pairs COUNT SEED\n");
    return 2;
  }
  return collision_monitor::test::runAll(std::atol(argv[1]),
                                         static_cast<std::uint64_t>(std::atoll(argv[2])));
}
