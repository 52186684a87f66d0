// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene_verdicts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/run_cycle.h"
#include "support/robots/robot_moves.h"
#include "surface_gap.h"

namespace collision_monitor::test {
namespace {

constexpr double kTouch = 1e-6;  // [m] FCL's tolerance
constexpr std::uint32_t kNoBudget = 1000000000;

/// What is known of a pair of links in one state.
struct PairAnswer {
  bool fcl_touches{false};
  bool fcl_gave_up{false};
  Holds holds{Holds::no};
};

class Comparer {
 public:
  Comparer(const PlacedStates& states, const std::vector<Geometry>& geometries)
      : states_(states),
        setup_(states.setup),
        geometries_(geometries),
        buffers_(makeBuffers(states.setup, BroadPhaseKind::automatic)),
        answers_(states.setup.checked.size()) {
    buffers_.refine.limits.budget = kNoBudget;
  }

  void compareState(std::size_t state) {
    const auto variables = static_cast<std::ptrdiff_t>(setup_.model.variable_count);
    const auto first = states_.positions.begin() + static_cast<std::ptrdiff_t>(state) * variables;
    resetMemory(buffers_);
    runCycle(setup_, posesAt(setup_.model, JointPositions(first, first + variables)), buffers_);
    askFcl(state);
    Truth worst = Truth::clear;
    for (std::size_t i = 0; i < setup_.checked.size(); ++i) {
      worst = std::max(worst, comparePair(state, i));
    }
    result_.states.push_back(worst);
  }

  SceneVerdicts result() { return std::move(result_); }

 private:
  /// Whether one is inside the other is asked only where FCL sees no contact.
  void askFcl(std::size_t state) {
    std::fill(answers_.begin(), answers_.end(), PairAnswer());
    for (const ElementPair& pair : setup_.element_pairs) {
      const FclObject* a = states_.fcl[state][index(pair.a)].get();
      const FclObject* b = states_.fcl[state][index(pair.b)].get();
      PairAnswer& answer = answers_[pair.link_pair];
      if (a == nullptr || b == nullptr || answer.fcl_touches ||
          !a->getAABB().overlap(b->getAABB())) {
        continue;
      }
      const std::optional<bool> touches = fclOverlap(*a, *b);
      answer.fcl_gave_up = answer.fcl_gave_up || !touches;
      answer.fcl_touches = touches.value_or(false);
      if (!answer.fcl_touches) {
        answer.holds = std::max(answer.holds, holdsOneInOther(states_, state, pair));
      }
    }
  }

  Truth comparePair(std::size_t state, std::size_t i) {
    const bool ours = buffers_.events.verdicts[i] == Verdict::contact;
    const PairAnswer& answer = answers_[i];
    ++result_.compared;
    result_.contacts += ours ? 1 : 0;
    const bool is_inside = !answer.fcl_touches && answer.holds != Holds::no;
    const bool differs = ours != answer.fcl_touches || answer.fcl_gave_up;
    if (!differs && !is_inside) {
      return ours ? Truth::contact : Truth::clear;
    }
    result_.different += differs ? 1 : 0;
    const double gap = gapOf(state, i);
    Truth truth = gap < -kTouch ? Truth::contact : gap <= kTouch ? Truth::either : Truth::clear;
    const Truth held = answer.holds == Holds::yes         ? Truth::contact
                       : answer.holds == Holds::undecided ? Truth::either
                                                          : Truth::clear;
    result_.inside += differs && truth == Truth::clear && held != Truth::clear ? 1 : 0;
    result_.touching += differs && truth == Truth::either ? 1 : 0;
    truth = std::max(truth, held);
    if (truth != Truth::either && ours != (truth == Truth::contact)) {
      ++result_.ours_wrong;
      tell(state, i, ours, gap);
    } else if (differs && truth != Truth::either && held == Truth::clear) {
      ++result_.fcl_wrong;
    }
    return truth;
  }

  double gapOf(std::size_t state, std::size_t i) const {
    double least = std::numeric_limits<double>::infinity();
    const std::vector<Pose>& poses = states_.world_from_element[state];
    for (const ElementPair& pair : setup_.element_pairs) {
      if (pair.link_pair == i) {
        const std::size_t a = index(pair.a);
        const std::size_t b = index(pair.b);
        least = std::min(least, surfaceGap(geometries_[a], poses[a], geometries_[b], poses[b]));
      }
    }
    return least;
  }

  void tell(std::size_t state, std::size_t i, bool ours, double gap) const {
    const CheckedLinkPair& pair = setup_.checked[i];
    const std::uint32_t place = buffers_.events.closest[i];
    const PairDistance nearest = place == kNone ? PairDistance() : buffers_.distances.pairs[place];
    std::fprintf(stderr, "state %zu: %s - %s: ours %s (%.9g m, quality %d), surfaces %.9g m\n",
                 state, setup_.model.link(pair.a).name.c_str(),
                 setup_.model.link(pair.b).name.c_str(), ours ? "contact" : "clear",
                 nearest.measured.distance, static_cast<int>(nearest.quality), gap);
  }

  const PlacedStates& states_;
  const CycleSetup& setup_;
  const std::vector<Geometry>& geometries_;
  CycleBuffers buffers_;
  std::vector<PairAnswer> answers_;  ///< by LinkPairIndex
  SceneVerdicts result_;
};

}  // namespace

SceneVerdicts compareVerdicts(const PlacedStates& states, const std::vector<Geometry>& geometries) {
  Comparer comparer(states, geometries);
  for (std::size_t state = 0; state < states.size(); ++state) {
    comparer.compareState(state);
  }
  return comparer.result();
}

std::size_t countWrong(const std::vector<StateCheck>& checks, const std::vector<Truth>& states) {
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const bool ours = checks[i].verdict == Verdict::contact;
    wrong += states[i] != Truth::either && ours != (states[i] == Truth::contact) ? 1 : 0;
  }
  return wrong;
}

}  // namespace collision_monitor::test
