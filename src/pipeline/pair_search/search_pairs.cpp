// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/pipeline/search_pairs.h"

#include <algorithm>
#include <map>
#include <utility>

#include "pipeline/pair_search/prove_apart.h"
#include "pipeline/setup/setup_parts.h"
#include "pipeline/states/states_block.h"

namespace collision_monitor {
namespace {

/// [m] Below it geometries are measured; larger than the threshold of touchOf.
constexpr double kNear = 2e-9;

/// The states of a link pair that were found.
struct Seen {
  bool is_fixed{false};  ///< the links do not move against each other: one state suffices
  bool is_apart{false};
  bool is_touching{false};
  bool is_unclear{false};
  JointPositions touching;  ///< the first touching state, or the first unclear one
  double nearest{std::numeric_limits<double>::infinity()};

  bool isDecided() const noexcept {
    return is_fixed ? is_apart || is_touching || is_unclear : is_apart && is_touching;
  }
};

/// Checks every link pair but adjacent ones, whatever the rules say.
CycleSetup checkingAll(CycleSetup setup) {
  for (LinkPair& pair : setup.link_pairs) {
    if (pair.reason != PairReason::adjacent) {
      pair.reason = PairReason::checked;
    }
  }
  listPairs(setup);
  return setup;
}

void keep(Touch touch, const JointPositions& state, Seen& seen) {
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

class Sampling {
 public:
  Sampling(const CycleSetup& setup, LinkPairMeasures& measures, std::vector<Seen>& seen)
      : setup_(setup),
        measures_(measures),
        seen_(seen),
        work_(makeStatesWork(
            setup, standingAt(setup.model, std::vector<Pose>(setup.model.robots.size())))),
        nearest_(setup.checked.size()) {}

  /// @param states at most kStateCount
  void look(const std::vector<JointPositions>& states) {
    measureShapes(states);
    for (std::size_t lane = 0; lane < states.size(); ++lane) {
      is_placed_ = false;
      for (LinkPairIndex pair = 0; pair < seen_.size(); ++pair) {
        if (!seen_[pair].isDecided()) {
          keep(touchIn(lane, pair), states[lane], seen_[pair]);
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

  Touch touchIn(std::size_t lane, LinkPairIndex pair) {
    const double distance = nearest_[pair].of[lane];
    seen_[pair].nearest = std::min(seen_[pair].nearest, distance);
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
  std::vector<Seen>& seen_;
  StatesWork work_;
  std::vector<StateNumber> nearest_;
  std::vector<Pose> world_from_link_;  ///< in the current state, if is_placed_
  bool is_placed_{false};
};

void drawStates(const PairSearchOptions& options, const std::vector<JointRange>& ranges,
                LinkPairMeasures& measures, std::vector<Seen>& seen) {
  const CycleSetup& setup = measures.setup;
  Sampling sampling(setup, measures, seen);
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

PairFound foundOf(const CheckedLinkPair& links, const Seen& seen) {
  PairFound found{links.a, links.b};
  if (seen.is_touching) {
    const bool is_always = !seen.is_apart && !seen.is_unclear;
    found.finding = is_always ? PairFinding::always : PairFinding::sometimes;
  } else {
    found.finding = seen.is_unclear ? PairFinding::unclear : PairFinding::never;
  }
  if (found.finding != PairFinding::always) {
    found.touching = seen.touching;
  }
  found.nearest = seen.nearest;
  return found;
}

/// Proves a finding, or finds a state that contradicts it.
void prove(const std::vector<JointRange>& ranges, std::size_t most_cells, LinkPairIndex pair,
           LinkPairMeasures& measures, PairFound& found) {
  if (found.finding == PairFinding::never) {
    const ApartProof proof = proveApart(measures, pair, ranges, most_cells);
    found.is_proven = proof.is_proven;
    if (proof.found != Touch::apart) {
      found.finding =
          proof.found == Touch::touching ? PairFinding::sometimes : PairFinding::unclear;
      found.touching = proof.state;
    }
  }
}

std::vector<JointId> jointsBetween(const RobotModel& model, const std::vector<JointRange>& ranges,
                                   const LinkPair& links) {
  std::vector<JointId> joints;
  for (const ChainJoint& joint : chainOf(model, ranges, links.a, links.b).joints) {
    joints.push_back(ranges[joint.path_joint].joint);
  }
  std::sort(joints.begin(), joints.end());
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  return joints;
}

}  // namespace

std::vector<PairFound> searchPairs(const CycleSetup& setup, const PairSearchOptions& options) {
  const CycleSetup all = checkingAll(setup);
  const std::vector<JointRange> ranges = jointRanges(all.model);
  LinkPairMeasures measures(all);
  std::vector<Seen> seen;
  for (const LinkPair& links : setup.link_pairs) {
    if (links.reason != PairReason::adjacent) {
      seen.emplace_back().is_fixed = links.reason == PairReason::same_rigid_group;
    }
  }
  drawStates(options, ranges, measures, seen);
  std::vector<PairFound> found;
  LinkPairIndex pair = 0;
  for (std::size_t i = 0; i < all.link_pairs.size(); ++i) {
    if (options.proof_progress) {
      options.proof_progress(i, all.link_pairs.size());
    }
    const LinkPair& links = all.link_pairs[i];
    if (links.reason == PairReason::adjacent) {
      found.push_back({links.a, links.b});
      continue;
    }
    found.push_back(foundOf(all.checked[pair], seen[pair]));
    found.back().joints = jointsBetween(all.model, ranges, links);
    if (seen[pair].is_fixed) {
      found.back().is_proven =
          found.back().finding == PairFinding::always || found.back().finding == PairFinding::never;
    } else {
      prove(ranges, options.most_cells, pair, measures, found.back());
    }
    ++pair;
  }
  if (options.proof_progress) {
    options.proof_progress(all.link_pairs.size(), all.link_pairs.size());
  }
  return found;
}

}  // namespace collision_monitor
