// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/pair_search/descend.h"

#include <algorithm>

namespace collision_monitor {
namespace {

/// The way down of one pair.
struct Descent {
  ProofTools& tools;
  LinkPairIndex pair;
  PlacedCell placed;
  JointCell at;  ///< `half` is the current step of each variable
  Touch touch{Touch::apart};
  double distance{kInfinity};
};

/// Whether the links are nearer in this state than in the best one so far, which it then replaces.
bool isNearer(const JointCell& cell, Descent& descent) {
  LinkPairMeasures& measures = descent.tools.measures;
  place(measures.setup.model, cell, descent.placed);
  const std::vector<Pose>& poses = descent.placed.world_from_link;
  if (bodyDistance(measures, descent.pair, poses).measured.distance >= descent.distance) {
    return false;  // the elements are no nearer than what encloses them
  }
  const PairDistance found = elementDistance(measures, descent.pair, poses, descent.distance);
  const Touch touch = touchOf(found);
  if (touch == Touch::apart && found.measured.distance >= descent.distance) {
    return false;
  }
  descent.touch = touch;
  descent.distance = found.measured.distance;
  descent.at.middle = cell.middle;
  return true;
}

/// Tries a step of each joint to both sides.
bool step(Descent& descent) {
  bool is_nearer = false;
  for (std::size_t i = 0; i < descent.at.middle.size(); ++i) {
    const JointRange& range = descent.placed.motion.ranges[i];
    for (const double side : {-1.0, 1.0}) {
      JointCell next = descent.at;
      next.middle[i] = std::clamp(next.middle[i] + side * next.half[i], range.lower, range.upper);
      if (next.middle[i] != descent.at.middle[i] && isNearer(next, descent)) {
        is_nearer = true;
        break;
      }
    }
    if (descent.touch != Touch::apart) {
      return true;
    }
  }
  return is_nearer;
}

}  // namespace

Touch descend(ProofTools& tools, LinkPairIndex pair, const PairMotion& motion,
              const std::vector<Pose>& world_from_root, JointPositions& state) {
  constexpr int kMostSteps = 200;
  constexpr int kHalvings = 10;
  const RobotModel& model = tools.measures.setup.model;
  Descent descent{tools, pair, makePlacedCell(model, motion, world_from_root), {}};
  for (const JointRange& range : motion.ranges) {
    descent.at.middle.push_back(state[model.joint(range.joint).first_variable]);
    descent.at.half.push_back(0.125 * (range.upper - range.lower));
  }
  forgetPair(tools, pair);
  isNearer(descent.at, descent);
  int halvings = 0;
  for (int i = 0; i < kMostSteps && halvings < kHalvings && descent.touch == Touch::apart; ++i) {
    if (!step(descent)) {
      ++halvings;
      for (double& half : descent.at.half) {
        half *= 0.5;
      }
    }
  }
  if (descent.touch != Touch::apart) {
    place(model, descent.at, descent.placed);
    state = descent.placed.state;
  }
  return descent.touch;
}

}  // namespace collision_monitor
