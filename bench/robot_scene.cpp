// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot_scene.h"

#include <algorithm>
#include <limits>
#include <random>

#include "narrow_phase/distance.h"
#include "pipeline/cycle/bound_bodies.h"
#include "pipeline/cycle/measure_pairs.h"
#include "pipeline/cycle/place_bodies.h"
#include "pipeline/refine/measure_elements.h"
#include "support/mesh_overlap.h"
#include "support/robots/robot_moves.h"

namespace collision_monitor::test {
namespace {

constexpr std::size_t kStatesAMove = 100;

/// From each random configuration straight to the next.
std::vector<LinkPoses> moveThrough(const RobotModel& model) {
  std::mt19937_64 random(20260101);
  std::vector<LinkPoses> states;
  JointPositions from = drawPositions(model, random);
  while (states.size() < kStates) {
    const JointPositions to = drawPositions(model, random);
    for (std::size_t step = 0; step < kStatesAMove; ++step) {
      const double share = static_cast<double>(step) / kStatesAMove;
      states.push_back(posesAt(model, between(from, to, share)));
    }
    from = to;
  }
  return states;
}

struct ToHull {
  ConvexGeometry operator()(const TriangleMesh& mesh) const { return ConvexHull(mesh.vertices); }
  template <class Primitive>
  ConvexGeometry operator()(const Primitive& primitive) const {
    return primitive;
  }
};

void addElements(RobotScene& scene) {
  const std::vector<FclGeometry> geometries = fclGeometries(scene.setup);
  std::vector<FclGeometry> hulls;
  for (const Element& element : scene.setup.elements) {
    const CollisionElement& source = sourceOf(scene.setup.model, element);
    scene.hulls.emplace_back(std::visit(ToHull{}, source.geometry));
    hulls.push_back(toFclGeometry(*scene.hulls.back()));
  }
  for (const LinkPoses& state : scene.states) {
    placeBodies(scene.setup, state, scene.poses);
    placeElements(scene.setup, state, scene.poses);
    scene.world_from_element.push_back(scene.poses.world_from_element);
    scene.fcl_states.push_back(placeFcl(geometries, scene.poses.world_from_element));
    scene.fcl_hulls.push_back(placeFcl(hulls, scene.poses.world_from_element));
  }
}

PlacedElement placed(const RobotScene& scene, ElementId id) {
  return {scene.setup.elements[index(id)], scene.poses.world_from_element[index(id)]};
}

}  // namespace

std::vector<RobotFile> benchRobots() {
  std::vector<RobotFile> chosen;
  for (const RobotFile& robot : allRobotFiles()) {
    const std::string name = robotNameOf(robot);
    const bool is_first = chosen.empty() || robotNameOf(chosen.back()) != name;
    for (const char* wanted : {"panda_moveit", "atlas", "icub", "anymal_kinova", "stretch"}) {
      if (name == wanted && is_first) {
        chosen.push_back(robot);
      }
    }
  }
  return chosen;
}

std::string robotNameOf(const RobotFile& robot) {
  return robot.name.substr(0, robot.name.find('/'));
}

std::unique_ptr<RobotScene> makeRobotScene(const RobotFile& robot) {
  auto scene = std::make_unique<RobotScene>();
  SetupOptions options;
  options.default_limits.max_shapes = 1;
  scene->setup = buildSetup({describe(robot)}, fileLoader(robot.package_root), options);
  scene->states = moveThrough(scene->setup.model);
  scene->poses = makeBodyPoses(scene->setup);
  scene->boxes.boxes.resize(scene->setup.bodies.size());
  scene->boxes.known.resize(scene->setup.bodies.size());
  scene->candidates.reserve(scene->setup.table.size());
  scene->distances.pairs.reserve(scene->setup.table.size());
  scene->memory = makeRefineMemory(scene->setup);
  scene->warm.resize(scene->setup.element_pairs.size());
  scene->queries.resize(scene->warm.size());
  scene->answers.resize(scene->warm.size());
  scene->scratch = std::make_unique<RefineScratch>();
  addElements(*scene);
  return scene;
}

void boundPairs(RobotScene& scene, std::size_t state) {
  const CycleSetup& setup = scene.setup;
  placeBodies(setup, scene.states[state], scene.poses);
  placeElements(setup, scene.states[state], scene.poses);
  boundBodies(setup, scene.poses, 0.0, scene.boxes);
  findCandidates(scene.broad_phase, scene.boxes, setup.table, scene.candidates);
  measurePairs(setup, scene.poses, scene.candidates, scene.distances);
  scene.bounds.clear();
  for (const PairDistance& distance : scene.distances.pairs) {
    scene.bounds.emplace_back(distance.measured.distance,
                              setup.element_pair_of[index(distance.pair)]);
  }
}

bool mayBeNearer(const RobotScene& scene, const BodyPair& pair, double distance) {
  const Body& a = scene.setup.bodies[index(pair.a)];
  const Body& b = scene.setup.bodies[index(pair.b)];
  const Pose& world_from_a = scene.poses.world_from_body[index(pair.a)];
  const Pose& world_from_b = scene.poses.world_from_body[index(pair.b)];
  const double reach = distance + a.bounding_radius + b.bounding_radius;
  return (world_from_b.translation - world_from_a.translation).squaredNorm() < reach * reach &&
         distanceBetween(a.shape, world_from_a, b.shape, world_from_b).distance < distance;
}

double measurePair(RobotScene& scene, ElementPairIndex pair, double enough) {
  const ElementPair& ids = scene.setup.element_pairs[pair];
  ElementSearch search{std::numeric_limits<std::uint32_t>::max(), scene.memory.of(pair),
                       *scene.scratch, enough};
  return measureElements(placed(scene, ids.a), placed(scene, ids.b), search).measured.distance;
}

bool touch(RobotScene& scene, ElementPairIndex pair) {
  const ElementPair& ids = scene.setup.element_pairs[pair];
  const PlacedElement a = placed(scene, ids.a);
  const PlacedElement b = placed(scene, ids.b);
  return a.element.mesh && b.element.mesh
             ? meshesOverlap({*a.element.mesh, a.world_from_element},
                             {*b.element.mesh, b.world_from_element}, scene.scratch->mesh)
             : measurePair(scene, pair, 1e-6) <= 0.0;
}

void measureHulls(RobotScene& scene, std::size_t state) {
  const std::vector<Pose>& poses = scene.world_from_element[state];
  for (ElementPairIndex pair = 0; pair < scene.queries.size(); ++pair) {
    const ElementPair& ids = scene.setup.element_pairs[pair];
    scene.queries[pair] = {&*scene.hulls[index(ids.a)], &poses[index(ids.a)],
                           &*scene.hulls[index(ids.b)], &poses[index(ids.b)], &scene.warm[pair]};
  }
  signedDistancesBetween(scene.queries.data(), scene.queries.size(), scene.scratch->convex,
                         scene.answers.data());
}

}  // namespace collision_monitor::test
