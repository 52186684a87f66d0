// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "bench_loop.h"
#include "pipeline/cycle/place_bodies.h"
#include "pipeline/states/check_states.h"
#include "support/instruction_sets.h"
#include "support/random_poses.h"
#include "support/robots/file_loader.h"
#include "support_fcl/fcl_adapter.h"

// Prints a table for robots of the shared data with one shape per link, at random joint positions:
// times of one of many states [us], kinematics included. FCL runs on the same pairs, with given
// link poses, in the same run.
//   states_bench ROBOT... [--only INSTRUCTION_SET]
namespace collision_monitor::test {
namespace {

constexpr std::size_t kStates = 256;

struct Scene {
  CycleSetup setup;
  JointPositions positions;  // kStates states
  std::vector<LinkPoses> poses;
};

CycleSetup setupWith(const RobotFile& robot, bool with_boxes) {
  SetupOptions options;
  options.default_limits.max_shapes = 1;
  options.default_limits.kinds = {false, !with_boxes, with_boxes, false};
  options.refine.geometry = RefineGeometry::none;
  return buildSetup({describe(robot)}, fileLoader(robot.package_root), options);
}

void fillStates(Scene& scene) {
  Random random(20260101);
  const RobotModel& model = scene.setup.model;
  for (std::size_t i = 0; i < kStates; ++i) {
    JointPositions state = defaultPositions(model);
    for (const Joint& joint : model.joints) {
      if (joint.type != JointType::fixed && joint.type != JointType::floating && !joint.mimic) {
        state[joint.first_variable] =
            uniform(random, std::max(joint.lower, -3.14), std::min(joint.upper, 3.14));
      }
    }
    LinkPoses poses = makeLinkPoses(model);
    placeLinks(model, state, std::vector<Pose>(model.robots.size()), poses.world_from_link);
    std::fill(poses.status.begin(), poses.status.end(), LinkStatus::known);
    scene.poses.push_back(poses);
    scene.positions.insert(scene.positions.end(), state.begin(), state.end());
  }
}

std::vector<FclObject> toFclObjects(const Scene& scene) {
  std::vector<FclObject> objects;
  for (const Body& body : scene.setup.bodies) {
    objects.push_back(*toFcl(body.shape, Pose{}));
  }
  return objects;
}

void placeFcl(const Scene& scene, std::size_t state, std::vector<FclObject>& objects) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Body& body = scene.setup.bodies[i];
    const Pose pose = scene.poses[state].world_from_link[index(body.link)] * body.link_from_body;
    objects[i].setTransform(pose.rotation, pose.translation);
  }
}

void fclDistances(const Scene& scene, const std::vector<FclObject>& objects) {
  for (const BodyPair& pair : scene.setup.table.pairs()) {
    benchmark::DoNotOptimize(fclDistance(objects[index(pair.a)], objects[index(pair.b)]));
  }
}

void fclContact(const Scene& scene, const std::vector<FclObject>& objects) {
  for (const BodyPair& pair : scene.setup.table.pairs()) {
    const auto is_contact = fclOverlap(objects[index(pair.a)], objects[index(pair.b)]);
    if (is_contact && *is_contact) {
      return;
    }
  }
}

void print(const std::string& name, const char* figure, double ours, double fcl) {
  std::printf("%s/%s %.4f %.4f\n", name.c_str(), figure, 1e-3 * ours, 1e-3 * fcl);
}

template <class Work>
double perState(const Work& work) {
  std::size_t next = 0;
  return medianTime([&] { work(next = (next + 1) % kStates); });
}

void benchScene(const std::string& name, const Scene& scene) {
  std::vector<FclObject> fcl = toFclObjects(scene);
  const double fcl_all = perState([&](std::size_t i) {
    placeFcl(scene, i, fcl);
    fclDistances(scene, fcl);
  });
  const double fcl_any = perState([&](std::size_t i) {
    placeFcl(scene, i, fcl);
    fclContact(scene, fcl);
  });

  StatesWork work = makeStatesWork(
      scene.setup,
      standingAt(scene.setup.model, std::vector<Pose>(scene.setup.model.robots.size())));
  std::vector<StateCheck> checks(kStates);
  for (const StateQuestion question : {StateQuestion::contact, StateQuestion::nearest}) {
    const bool is_contact = question == StateQuestion::contact;
    const double many =
        medianTime([&] { checkStates(scene.setup, scene.positions, question, work, checks); });
    print(name, is_contact ? "many_states_contact" : "many_states_nearest",
          many / static_cast<double>(kStates), is_contact ? fcl_any : fcl_all);
  }
}

void benchRobot(const RobotFile& robot) {
  const std::string name = robot.name.substr(0, robot.name.find('/'));
  for (const bool with_boxes : {false, true}) {
    Scene scene{setupWith(robot, with_boxes), {}, {}};
    fillStates(scene);
    std::printf("# %s: %zu bodies, %zu pairs\n", name.c_str(), scene.setup.bodies.size(),
                scene.setup.table.size());
    benchScene(name + (with_boxes ? "/boxes" : "/capsules"), scene);
  }
}

int run(std::vector<std::string> robots) {
  std::unique_ptr<OnlyInstructionSet> only;
  if (!takeOnly(robots, only)) {
    return 2;
  }
  for (const std::string& name : robots) {
    for (const RobotFile& robot : allRobotFiles()) {
      if (robot.name.rfind(name + "/", 0) == 0) {
        benchRobot(robot);
      }
    }
  }
  return 0;
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) { return collision_monitor::test::run({argv + 1, argv + argc}); }
