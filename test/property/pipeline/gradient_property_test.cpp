// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iostream>

#include "collision_monitor/model/kinematics.h"
#include "pipeline/answers/gradient_row.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/measure_pairs.h"
#include "pipeline/cycle/place_bodies.h"
#include "pipeline/look_ahead/find_closings.h"
#include "pipeline/look_ahead/link_velocities.h"
#include "support/fixed_seed.h"
#include "support/random_poses.h"
#include "support/robots/hand_made_setup.h"

// Derivatives against central differences of the distance, on random trees of links with joints of
// every type.
namespace collision_monitor::gradient_laws {
namespace {

using test::Random;

constexpr double kStep = 1e-6;
constexpr double kAllowed = 1e-6;

bool hasOneVariable(const Joint& joint) { return freedomOf(joint) == 1; }

/// A joint between random links; one in four follows an earlier joint.
Joint randomJoint(std::size_t child, const RobotModel& model, Random& random) {
  constexpr JointType kTypes[] = {JointType::revolute, JointType::continuous, JointType::prismatic,
                                  JointType::planar,   JointType::floating,   JointType::fixed};
  Joint joint;
  joint.name = "joint_" + std::to_string(child);
  joint.type = kTypes[random() % 6];
  joint.parent = idAt<LinkId>(random() % child);
  joint.child = idAt<LinkId>(child);
  joint.parent_from_joint = test::randomPose(random, 0.2);
  joint.axis = test::randomRotation(random).col(0);
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& source = model.joints[i];
    if (hasOneVariable(joint) && hasOneVariable(source) && !source.mimic && random() % 4 == 0) {
      joint.mimic = Mimic{idAt<JointId>(i), test::uniform(random, -2, 2), 0.1};
      joint.first_variable = source.first_variable;
    }
  }
  return joint;
}

/// Free links of a random set-up made into a tree.
CycleSetup randomRobot(unsigned seed) {
  Random random(seed);
  CycleSetup setup = test::randomSetup(6, seed);
  RobotModel& model = setup.model;
  for (std::size_t child = 1; child < model.links.size(); ++child) {
    Joint joint = randomJoint(child, model, random);
    if (!joint.mimic) {
      joint.first_variable = model.variable_count;
      model.variable_count += joint.type == JointType::floating ? 7 : freedomOf(joint);
    }
    model.links[child].parent_joint = idAt<JointId>(model.joints.size());
    model.joints.push_back(joint);
  }
  model.robots[0].joint_count = model.joints.size();
  return setup;
}

JointPositions randomPositions(const RobotModel& model, Random& random) {
  JointPositions positions(model.variable_count);
  for (double& position : positions) {
    position = test::uniform(random, -0.5, 0.5);
  }
  for (const Joint& joint : model.joints) {
    if (joint.type == JointType::floating) {
      Eigen::Map<Eigen::Vector4d>(positions.data() + joint.first_variable + 3).normalize();
    }
  }
  return positions;
}

/// Where the joints get in `time` at unit speed of velocity `k` of `joint`.
JointPositions moved(const Joint& joint, std::size_t k, double time, JointPositions positions) {
  double* variables = positions.data() + joint.first_variable;
  if (joint.type == JointType::floating && k >= 3) {
    const Eigen::AngleAxisd turn(time, Eigen::Vector3d::Unit(static_cast<Eigen::Index>(k - 3)));
    Eigen::Map<Eigen::Quaterniond> rotation(variables + 3);
    rotation = Eigen::Quaterniond(turn) * rotation;
  } else {
    variables[k] += time;
  }
  return positions;
}

/// The robot at joint positions, every pair measured.
struct Scene {
  explicit Scene(unsigned seed)
      : setup(randomRobot(seed)),
        poses(test::knownPoses(setup)),
        buffers(makeBuffers(setup, BroadPhaseKind::brute_force)) {
    for (std::size_t i = 0; i < setup.table.size(); ++i) {
      pairs.push_back(idAt<PairId>(i));
    }
  }

  const std::vector<PairDistance>& measureAt(const JointPositions& positions) {
    placeLinks(setup.model, positions, {Pose()}, poses.world_from_link);
    placeBodies(setup, poses, buffers.body_poses);
    measurePairs(setup, buffers.body_poses, pairs, buffers.distances);
    return buffers.distances.pairs;
  }
  std::vector<double> distancesAt(const JointPositions& positions) {
    std::vector<double> distances;
    for (const PairDistance& distance : measureAt(positions)) {
      distances.push_back(distance.measured.distance);
    }
    return distances;
  }

  CycleSetup setup;
  LinkPoses poses;
  CycleBuffers buffers;
  std::vector<PairId> pairs;
};

double valueOf(const GradientRow& row, std::size_t variable) {
  for (const GradientEntry& entry : row) {
    if (entry.variable == variable) {
      return entry.value;
    }
  }
  return 0.0;
}

struct Counts {
  std::size_t apart{0};
  std::size_t overlapping{0};
  std::size_t followed{0};  ///< of both, by a joint that mimic joints follow
  std::size_t kinks{0};
  double worst{0.0};  ///< difference from a slope
};

bool isFollowed(const RobotModel& model, const Joint& joint) {
  return std::any_of(model.joints.begin(), model.joints.end(), [&](const Joint& other) {
    return other.mimic && &model.joint(other.mimic->source) == &joint;
  });
}

void checkRows(Scene& scene, const JointPositions& positions, Counts& counts) {
  const std::vector<double> here = scene.distancesAt(positions);
  GradientRows rows_here(scene.setup, scene.poses);
  std::vector<GradientRow> rows;
  for (std::size_t i = 0; i < here.size(); ++i) {
    rows.push_back(rows_here.of(scene.buffers.distances.pairs[i]));
  }
  for (const Joint& joint : scene.setup.model.joints) {
    for (std::size_t k = 0; !joint.mimic && k < freedomOf(joint); ++k) {
      const auto before = scene.distancesAt(moved(joint, k, -kStep, positions));
      const auto after = scene.distancesAt(moved(joint, k, kStep, positions));
      for (std::size_t i = 0; i < here.size(); ++i) {
        // A kink between the three points: the derivative is another one on each side.
        if (std::abs(after[i] - 2.0 * here[i] + before[i]) > 1e-4 * kStep) {
          ++counts.kinks;
          continue;
        }
        const double slope = (after[i] - before[i]) / (2.0 * kStep);
        const double fault = std::abs(valueOf(rows[i], joint.first_variable + k) - slope);
        RC_ASSERT(fault <= kAllowed);
        counts.worst = std::max(counts.worst, fault);
        ++(here[i] > 0.0 ? counts.apart : counts.overlapping);
        counts.followed += isFollowed(scene.setup.model, joint) ? 1 : 0;
      }
    }
  }
}

TEST(GradientLaws, rowsAreCentralDifferencesOfTheDistance) {
  Counts counts;
  const bool holds = rc::check("gradient rows", [&counts] {
    const auto seed = *rc::gen::arbitrary<unsigned>();
    Scene scene(seed);
    Random random(seed);
    checkRows(scene, randomPositions(scene.setup.model, random), counts);
  });
  EXPECT_TRUE(holds);
  std::cout << counts.apart << " slopes apart and " << counts.overlapping << " overlapping, "
            << counts.followed << " by followed joints, worst difference " << counts.worst << ", "
            << counts.kinks << " kinks\n";
  EXPECT_GT(counts.apart, 1000U);
  EXPECT_GT(counts.overlapping, 100U);
  EXPECT_GT(counts.followed, 100U);
  EXPECT_LT(10 * counts.kinks, counts.apart + counts.overlapping);
}

/// All joints at once: positions after `time` at the given velocities.
JointPositions advanced(const RobotModel& model, const JointVelocities& velocities, double time,
                        JointPositions positions) {
  for (const Joint& joint : model.joints) {
    for (std::size_t k = 0; !joint.mimic && k < freedomOf(joint); ++k) {
      positions = moved(joint, k, time * velocities[joint.first_variable + k], positions);
    }
  }
  return positions;
}

TEST(GradientLaws, rowTimesVelocities_isTheClosingSpeedOfTheLinks) {
  EXPECT_TRUE(rc::check("closing speeds", [] {
    const auto seed = *rc::gen::arbitrary<unsigned>();
    Scene scene(seed);
    Random random(seed);
    const RobotModel& model = scene.setup.model;
    JointVelocities velocities(model.variable_count);
    for (double& velocity : velocities) {
      velocity = test::uniform(random, -2, 2);
    }
    scene.measureAt(randomPositions(model, random));
    scene.poses.velocities.known[0] = 1;  // the root, which stands still
    applyJointVelocities(model, velocities, scene.poses);
    findClosings(scene.setup, scene.poses, scene.buffers.distances);
    GradientRows rows(scene.setup, scene.poses);
    for (const PairDistance& distance : scene.buffers.distances.pairs) {
      double rate = 0.0;
      for (const GradientEntry& entry : rows.of(distance)) {
        rate += entry.value * velocities[entry.variable];
      }
      RC_ASSERT(std::abs(rate + distance.closing_speed) <= 1e-12);
    }
  }));
}

TEST(GradientLaws, linkVelocitiesOfJointsAndOfTwoStamps_agree) {
  EXPECT_TRUE(rc::check("link velocities", [] {
    const auto seed = *rc::gen::arbitrary<unsigned>();
    Scene scene(seed);
    Random random(seed);
    const RobotModel& model = scene.setup.model;
    const JointPositions positions = randomPositions(model, random);
    JointVelocities velocities(model.variable_count);
    for (double& velocity : velocities) {
      velocity = test::uniform(random, -2, 2);
    }
    VelocityTracker tracker = makeVelocityTracker(model);
    const VelocityOptions unfiltered{0.0, 0.5};
    constexpr double kHalf = 1e-5;
    for (const int side : {-1, 1}) {
      scene.measureAt(advanced(model, velocities, side * kHalf, positions));
      scene.poses.robot_stamp_ns[0] += static_cast<std::int64_t>(2e9 * kHalf);
      trackVelocities(model, unfiltered, tracker, scene.poses);
    }
    const LinkVelocities tracked = scene.poses.velocities;
    scene.measureAt(positions);
    applyJointVelocities(model, velocities, scene.poses);
    for (std::size_t link = 0; link < model.links.size(); ++link) {
      const Twist difference = tracked.of_link[link] - scene.poses.velocities.of_link[link];
      RC_ASSERT(tracked.known[link] != 0);
      RC_ASSERT(difference.linear.norm() + difference.angular.norm() <= 1e-6);
    }
  }));
}

}  // namespace
}  // namespace collision_monitor::gradient_laws
