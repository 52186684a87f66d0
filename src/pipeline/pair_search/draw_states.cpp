// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "pipeline/pair_search/search_steps.h"
#include "pipeline/states/states_block.h"

namespace collision_monitor {
namespace {

/// [m] Below it geometries are measured; larger than the threshold of touchOf.
constexpr double kNear = 2e-9;

class Sampling {
 public:
  Sampling(const std::vector<Pose>& world_from_root, LinkPairMeasures& measures,
           std::vector<SeenPair>& seen)
      : setup_(measures.setup),
        measures_(measures),
        seen_(seen),
        work_(makeShapeStatesWork(setup_, standingAt(setup_.model, world_from_root))),
        nearest_(setup_.checked.size()) {}

  /// @param states at most kStateCount
  void look(const std::vector<JointPositions>& states) {
    measureShapes(states);
    for (std::size_t lane = 0; lane < states.size(); ++lane) {
      is_placed_ = false;
      for (LinkPairIndex pair = 0; pair < seen_.size(); ++pair) {
        if (!seen_[pair].isDecided()) {
          keep(touchIn(lane, pair, states[lane]), states[lane], seen_[pair]);
        }
      }
    }
  }

 private:
  /// Measures up to the least distance so far: larger ones are not reported.
  void measureShapes(const std::vector<JointPositions>& states) {
    JointPositions positions;
    for (const JointPositions& state : states) {
      positions.insert(positions.end(), state.begin(), state.end());
    }
    for (std::size_t pair = 0; pair < seen_.size(); ++pair) {
      const double reach =
          seen_[pair].isDecided() ? kNotAsked : std::max(seen_[pair].nearest, kNear);
      std::fill(std::begin(nearest_[pair].of), std::end(nearest_[pair].of), reach);
    }
    fillVariables(positions, 0, work_);
    placeStates(setup_, work_);
    measureLinkPairs(setup_, work_, nearest_);
  }

  Touch touchIn(std::size_t lane, LinkPairIndex pair, const JointPositions& state) {
    const double distance = nearest_[pair].of[lane];
    if (distance < seen_[pair].nearest) {
      seen_[pair].nearest = distance;
      seen_[pair].nearest_state = state;
    }
    if (distance >= kNear) {
      return Touch::apart;
    }
    if (!is_placed_) {
      readLinkPoses(work_, lane, world_from_link_);
      is_placed_ = true;
    }
    return touchOf(elementDistance(measures_, pair, world_from_link_, kNear));
  }

  const CycleSetup& setup_;
  LinkPairMeasures& measures_;
  std::vector<SeenPair>& seen_;
  StatesWork work_;
  std::vector<StateNumber> nearest_;
  std::vector<Pose> world_from_link_;  ///< in the current state, if is_placed_
  bool is_placed_{false};
};

}  // namespace

void keep(Touch touch, const JointPositions& state, SeenPair& seen) {
  seen.is_apart = seen.is_apart || touch == Touch::apart;
  const bool is_first = touch == Touch::touching
                            ? !seen.is_touching
                            : touch == Touch::unclear && !seen.is_touching && !seen.is_unclear;
  if (is_first) {
    seen.touching = state;
  }
  seen.is_touching = seen.is_touching || touch == Touch::touching;
  seen.is_unclear = seen.is_unclear || touch == Touch::unclear;
}

void drawStates(const PairSearchOptions& options, const std::vector<JointRange>& ranges,
                const std::vector<Pose>& world_from_root, LinkPairMeasures& measures,
                std::vector<SeenPair>& seen) {
  const CycleSetup& setup = measures.setup;
  Sampling sampling(world_from_root, measures, seen);
  std::mt19937_64 random(options.seed);
  std::vector<JointPositions> states;
  for (std::size_t i = 0; i < options.states; ++i) {
    states.push_back(i == 0 ? defaultPositions(setup.model)
                            : drawState(setup.model, ranges, random));
    if (states.size() == kStateCount || i + 1 == options.states) {
      sampling.look(states);
      states.clear();
      if (options.state_progress) {
        options.state_progress(i + 1, options.states);
      }
    }
  }
}

}  // namespace collision_monitor
