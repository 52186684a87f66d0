// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "bench_loop.h"
#include "support/convex_cases.h"
#include "support/sample_meshes.h"
#include "support_fcl/fcl_adapter.h"
#ifdef COLLISION_MONITOR_HAS_COAL
#include "peers/coal_adapter.h"
#endif

// Time of one signed distance of hulls and cylinders: without a warm start, and as in a monitor,
// where the pair turns by half a degree between queries and keeps its warm start. FCL's distance
// and its contact with depth run on the same pairs in the same run; so does Coal, warm, if it is
// there.
namespace collision_monitor::test {
namespace {

constexpr std::size_t kSteps = 720;  // once around

struct Scene {
  ConvexGeometry a;
  ConvexGeometry b;
  double gap{0.0};  // [m] between them, approximately
};

// Points on a sphere of 10 cm, so that each of them is a corner.
ConvexGeometry ballHull(std::size_t corners) {
  Random random(corners);
  std::vector<Eigen::Vector3d> points;
  while (points.size() < corners) {
    const Eigen::Vector3d point = randomPoint(random, 1.0);
    if (point.norm() > 0.1) {
      points.push_back(0.1 * point.normalized());
    }
  }
  return ConvexHull(points);
}

ConvexGeometry boxAsHull(const Eigen::Vector3d& half_extents) {
  return ConvexHull(boxMesh(half_extents).vertices);
}

std::vector<PosedConvexPair> makePath(const Scene& scene) {
  Random random(20260101);
  const Eigen::Vector3d axis = randomPoint(random, 1.0).normalized();
  static ConvexWorkspace workspace;
  std::vector<PosedConvexPair> path;
  for (std::size_t i = 0; i < kSteps; ++i) {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / kSteps;
    PosedConvexPair pair{&scene.a, Pose{}, &scene.b,
                         Pose{Eigen::AngleAxisd(angle, axis).toRotationMatrix(), {0.15, 0.1, 0.1}}};
    ConvexWarmStart warm;
    ConvexSearch search{workspace, warm};
    const SignedDistance now =
        signedDistanceBetween(*pair.a, pair.world_from_a, *pair.b, pair.world_from_b, search)
            .measured;
    pair.world_from_b.translation += (scene.gap - now.distance) * now.normal_a_to_b;
    path.push_back(pair);
  }
  return path;
}

void measureOurs(benchmark::State& state, const Scene& scene, bool is_warm) {
  const std::vector<PosedConvexPair> path = makePath(scene);
  static ConvexWorkspace workspace;
  ConvexWarmStart warm;
  std::size_t next = 0;
  for ([[maybe_unused]] const auto unused : state) {
    const PosedConvexPair& pair = path[next++ % kSteps];
    if (!is_warm) {
      warm = ConvexWarmStart{};
    }
    ConvexSearch search{workspace, warm};
    benchmark::DoNotOptimize(
        signedDistanceBetween(*pair.a, pair.world_from_a, *pair.b, pair.world_from_b, search));
  }
}

/// Asks about pose after pose of two geometries of a peer.
template <class Object, class Geometry, class Query>
void measurePeer(benchmark::State& state, const Scene& scene,
                 Geometry (*geometry_of)(const ConvexGeometry&), const Query& query) {
  const Geometry geometry_a = geometry_of(scene.a);
  const Geometry geometry_b = geometry_of(scene.b);
  std::vector<Object> objects_a;
  std::vector<Object> objects_b;
  for (const PosedConvexPair& pair : makePath(scene)) {
    objects_a.emplace_back(geometry_a, pair.world_from_a.rotation, pair.world_from_a.translation);
    objects_b.emplace_back(geometry_b, pair.world_from_b.rotation, pair.world_from_b.translation);
  }
  std::size_t next = 0;
  for ([[maybe_unused]] const auto unused : state) {
    const std::size_t i = next++ % kSteps;
    benchmark::DoNotOptimize(query(objects_a[i], objects_b[i]));
  }
}

void registerFcl(const std::string& name, const Scene& scene) {
  const bool is_apart = scene.gap > 0.0;
  benchmark::RegisterBenchmark((name + (is_apart ? "/fcl_distance" : "/fcl_signed")).c_str(),
                               [=](benchmark::State& state) {
                                 measurePeer<FclObject>(state, scene, toFclGeometry,
                                                        is_apart ? fclDistance : fclSignedDistance);
                               });
}

#ifdef COLLISION_MONITOR_HAS_COAL
void registerCoal(const std::string& name, const Scene& scene) {
  const bool is_apart = scene.gap > 0.0;
  benchmark::RegisterBenchmark(
      (name + (is_apart ? "/coal_distance" : "/coal_signed")).c_str(),
      [=](benchmark::State& state) {
        const coal::DistanceRequest warm = warmCoalRequest(!is_apart);
        measurePeer<CoalObject>(
            state, scene, toCoalGeometry,
            [&](const CoalObject& a, const CoalObject& b) { return coalDistance(a, b, warm); });
      });
}
#endif

void registerScene(const std::string& name, const Scene& scene) {
  benchmark::RegisterBenchmark((name + "/warm").c_str(), measureOurs, scene, true);
  benchmark::RegisterBenchmark((name + "/cold").c_str(), measureOurs, scene, false);
  registerFcl(name, scene);
#ifdef COLLISION_MONITOR_HAS_COAL
  registerCoal(name, scene);
#endif
}

void registerAll() {
  const ConvexGeometry can = Cylinder{0.1, 0.05};
  const struct {
    const char* name;
    ConvexGeometry a;
    ConvexGeometry b;
  } kPairs[] = {
      {"hull16-hull16", ballHull(16), ballHull(16)},
      {"box_as_hull-box_as_hull", boxAsHull({0.1, 0.06, 0.08}), boxAsHull({0.07, 0.1, 0.05})},
      {"hull8-hull8", ballHull(8), ballHull(8)},
      {"hull12-hull12", ballHull(12), ballHull(12)},
      {"hull64-hull64", ballHull(64), ballHull(64)},
      {"hull256-hull256", ballHull(256), ballHull(256)},
      {"cylinder-cylinder", can, can},
      {"cylinder-hull64", can, ballHull(64)}};
  for (const auto& pair : kPairs) {
    registerScene(std::string(pair.name) + "/apart_1cm", {pair.a, pair.b, 0.01});
    registerScene(std::string(pair.name) + "/deep_1mm", {pair.a, pair.b, -0.001});
    registerScene(std::string(pair.name) + "/deep_1cm", {pair.a, pair.b, -0.01});
    registerScene(std::string(pair.name) + "/deep_5cm", {pair.a, pair.b, -0.05});
  }
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) {
  return collision_monitor::test::runBenchmarks(argc, argv, &collision_monitor::test::registerAll);
}
