// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench_loop.h"
#include "narrow_phase/mesh/mesh_distance.h"
#include "support/mesh_overlap.h"
#include "support/own_front.h"
#include "support/query_meshes.h"
#include "support_fcl/fcl_mesh.h"
#ifdef COLLISION_MONITOR_HAS_COAL
#include "peers/coal_adapter.h"
#endif

// Two bodies of 50,000 triangles each, brought to a gap. Times of an overlap test, of a distance
// without a warm start, of a distance with the last nearest pair after a motion of a millimetre and
// a milliradian, and of a series of such steps, or of a tenth of them, across the gap, each from
// the result of the last. FCL runs on the same poses in the same run, and Coal if it is there. Read
// as ratios.
namespace collision_monitor::test {
namespace {

constexpr int kSectors = 224;
constexpr std::size_t kPoseCount = 24;

struct ScenePose {
  Pose world_from_a;
  Pose world_from_b;
  Pose moved_b;
  Eigen::Vector3d away;  ///< from A, unit
  TrianglePair nearest;
  std::unique_ptr<OwnFront> front;
};

struct Scene {
  TriangleMesh mesh = bumpyMesh(1.0, kSectors);
  MeshTree tree{mesh, true};
  std::shared_ptr<FclMesh> fcl = toFcl(mesh);
  std::unique_ptr<MeshQueryMemory> memory = std::make_unique<MeshQueryMemory>();
};

Scene& scene() {
  static Scene the_scene;
  return the_scene;
}

MeshDistance measure(const Pose& a, const Pose& b, const TrianglePair& start = TrianglePair{}) {
  Scene& s = scene();
  return distanceBetween({s.tree, a}, {s.tree, b}, *s.memory, start);
}

// Moves along a line through A's center, each time no farther than the distance allows.
std::vector<ScenePose> posesAtGap(double gap) {
  Random random(20260101);
  std::vector<ScenePose> poses;
  while (poses.size() < kPoseCount) {
    const Pose a = randomPose(random, 1.0);
    const Eigen::Vector3d away = randomPoint(random, 1.0).normalized();
    Pose b{randomRotation(random), a.translation + 3.0 * away};
    for (int step = 0; step < 50; ++step) {
      b.translation -= (measure(a, b).measured.distance - gap) * away;
    }
    Pose moved = b;
    moved.translation += 1e-3 * away;
    moved.rotation = Eigen::AngleAxisd(1e-3, away).toRotationMatrix() * moved.rotation;
    poses.push_back({a, b, moved, away, measure(a, b).nearest, std::make_unique<OwnFront>()});
  }
  return poses;
}

/// Ten steps across the gap, back, and on to the other side.
Pose walked(const ScenePose& pose, double length, std::size_t step) {
  constexpr std::size_t kSteps = 10;
  const auto phase = static_cast<double>(step % (4 * kSteps));
  const double way = length * (std::abs(phase - 2.0 * kSteps) - 1.0 * kSteps);
  Pose b = pose.world_from_b;
  b.translation += way * pose.away.unitOrthogonal();
  b.rotation = Eigen::AngleAxisd(way, pose.away).toRotationMatrix() * b.rotation;
  return b;
}

template <class Query>
void forPoses(benchmark::State& state, double gap, const Query& query) {
  const std::vector<ScenePose> poses = posesAtGap(gap);
  std::size_t next = 0;
  for ([[maybe_unused]] const auto unused : state) {
    benchmark::DoNotOptimize(query(poses[next++ % kPoseCount]));
  }
}

void addOurs(const std::string& gap_name, double gap) {
  benchmark::RegisterBenchmark((gap_name + "overlap").c_str(), [gap](benchmark::State& state) {
    forPoses(state, gap, [](const ScenePose& pose) {
      Scene& s = scene();
      return meshesOverlap({s.tree, pose.world_from_a}, {s.tree, pose.world_from_b}, *s.memory);
    });
  });
  benchmark::RegisterBenchmark((gap_name + "distance_cold").c_str(),
                               [gap](benchmark::State& state) {
                                 forPoses(state, gap, [](const ScenePose& pose) {
                                   return measure(pose.world_from_a, pose.world_from_b);
                                 });
                               });
  benchmark::RegisterBenchmark((gap_name + "distance_warm").c_str(),
                               [gap](benchmark::State& state) {
                                 forPoses(state, gap, [](const ScenePose& pose) {
                                   return measure(pose.world_from_a, pose.moved_b, pose.nearest);
                                 });
                               });
}

void addWalk(const std::string& name, double gap, double step) {
  benchmark::RegisterBenchmark(name.c_str(), [gap, step](benchmark::State& state) {
    std::size_t asked = 0;
    forPoses(state, gap, [&](const ScenePose& pose) {
      Scene& s = scene();
      const Pose b = walked(pose, step, asked++ / kPoseCount);
      return distanceBetween({s.tree, pose.world_from_a}, {s.tree, b}, *s.memory, *pose.front);
    });
  });
}

void addFcl(const std::string& gap_name, double gap) {
  benchmark::RegisterBenchmark((gap_name + "fcl_overlap").c_str(), [gap](benchmark::State& state) {
    forPoses(state, gap, [](const ScenePose& pose) {
      return fclMeshOverlap(fclObject(scene().fcl, pose.world_from_a),
                            fclObject(scene().fcl, pose.world_from_b));
    });
  });
  benchmark::RegisterBenchmark((gap_name + "fcl_distance").c_str(), [gap](benchmark::State& state) {
    forPoses(state, gap, [](const ScenePose& pose) {
      return fclMeshDistance(fclObject(scene().fcl, pose.world_from_a),
                             fclObject(scene().fcl, pose.world_from_b));
    });
  });
}

#ifdef COLLISION_MONITOR_HAS_COAL
std::shared_ptr<CoalMesh> coalMesh() {
  static const std::shared_ptr<CoalMesh> mesh = toCoal(scene().mesh);
  return mesh;
}

void addCoal(const std::string& gap_name, double gap) {
  benchmark::RegisterBenchmark((gap_name + "coal_overlap").c_str(), [gap](benchmark::State& state) {
    forPoses(state, gap, [](const ScenePose& pose) {
      return coalOverlap(coalObject(coalMesh(), pose.world_from_a),
                         coalObject(coalMesh(), pose.world_from_b));
    });
  });
  benchmark::RegisterBenchmark(
      (gap_name + "coal_distance").c_str(), [gap](benchmark::State& state) {
        forPoses(state, gap, [](const ScenePose& pose) {
          return coalDistance(coalObject(coalMesh(), pose.world_from_a),
                              coalObject(coalMesh(), pose.world_from_b), coalRequest(false));
        });
      });
}

void addCoalBuild() {
  benchmark::RegisterBenchmark("coal_build", [](benchmark::State& state) {
    const TriangleMesh& mesh = scene().mesh;
    for ([[maybe_unused]] const auto unused : state) {
      benchmark::DoNotOptimize(toCoal(mesh));
    }
  });
}
#endif

void registerAll() {
  benchmark::RegisterBenchmark("build", [](benchmark::State& state) {
    const TriangleMesh& mesh = scene().mesh;
    for ([[maybe_unused]] const auto unused : state) {
      benchmark::DoNotOptimize(MeshTree(mesh, true).nodes().size());
    }
  });
  benchmark::RegisterBenchmark("fcl_build", [](benchmark::State& state) {
    const TriangleMesh& mesh = scene().mesh;
    for ([[maybe_unused]] const auto unused : state) {
      benchmark::DoNotOptimize(toFcl(mesh));
    }
  });
  for (const auto& [name, gap] : {std::pair<const char*, double>{"gap_1mm/", 1e-3},
                                  {"gap_1cm/", 1e-2},
                                  {"gap_10cm/", 1e-1}}) {
    addOurs(name, gap);
    addWalk(std::string(name) + "distance_walk_1mm", gap, 1e-3);
    addWalk(std::string(name) + "distance_walk_0.1mm", gap, 1e-4);
    addFcl(name, gap);
#ifdef COLLISION_MONITOR_HAS_COAL
    addCoal(name, gap);
#endif
  }
#ifdef COLLISION_MONITOR_HAS_COAL
  addCoalBuild();
#endif
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) {
  return collision_monitor::test::runBenchmarks(argc, argv, &collision_monitor::test::registerAll);
}
