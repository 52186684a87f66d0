// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <vector>

#include "peer_times.h"
#include "peers/placed_states.h"
#include "pipeline/states/check_states.h"
#include "product_bench.h"
#include "product_coal.h"
#include "thread_time.h"

namespace collision_monitor::test {
namespace {

constexpr std::size_t kStates = 200;
constexpr double kTouch = 1e-6;  // [m] FCL's tolerance: nearer to 0, either verdict is right

template <class Query>
void timeFcl(const std::string& name, const PlacedStates& scene, const Query& query) {
  timePeer(name, scene.size(), [&](std::size_t state) { query(scene.setup, scene.fcl[state]); });
}

std::vector<StateCheck> timeOurs(const std::string& name, const PlacedStates& scene,
                                 StateQuestion question, StatesWork& work) {
  constexpr int kCalls = 50;  // of light robots they take as long as those of FCL
  std::vector<StateCheck> checks;
  const auto check = [&] {
    checkStatesExactly(scene.setup, scene.positions, question, work, checks);
  };
  check();  // fills memories
  print(name, 1e-3 * medianTimeOf(kCalls, check) / static_cast<double>(scene.size()), "us");
  return checks;
}

/// Whether surfaces meet in a state, by FCL, or else one element is inside another.
struct Truth {
  bool meets{false};
  bool holds{false};

  bool isContact() const { return meets || holds; }
};

/// Tests for elements inside others only where surfaces do not meet.
Truth truthOf(const PlacedStates& scene, std::size_t state) {
  const std::vector<ElementPair>& pairs = scene.setup.element_pairs;
  Truth truth;
  truth.meets = fclContacts(scene.setup, scene.fcl[state]) > 0;
  truth.holds =
      !truth.meets && std::any_of(pairs.begin(), pairs.end(), [&](const ElementPair& pair) {
        return holdsOneInOther(scene, state, pair) != Holds::no;
      });
  return truth;
}

bool isTouch(const StateCheck& nearest) {
  return nearest.has_pair && nearest.quality == Quality::exact &&
         std::abs(nearest.distance) <= kTouch;
}

double exactDistanceOf(const StateCheck& nearest) {
  return nearest.has_pair && nearest.quality == Quality::exact ? std::max(0.0, nearest.distance)
                                                               : 0.0;
}

/// Numbers of states whose verdict contradicts the truth.
struct Differences {
  std::size_t contacts{0};  ///< in truth
  std::size_t inside{0};    ///< of these, without surfaces that meet: FCL does not see them
  std::size_t missed{0};    ///< surfaces meet, and we say nothing
  std::size_t missed_inside{0};
  std::size_t untrue{0};  ///< we say contact, and there is none

  void add(const Truth& truth, bool ours) {
    contacts += truth.isContact() ? 1 : 0;
    inside += truth.holds ? 1 : 0;
    missed += !ours && truth.meets ? 1 : 0;
    missed_inside += !ours && truth.holds ? 1 : 0;
    untrue += ours && !truth.isContact() ? 1 : 0;
  }

  void print(const std::string& question) const {
    test::print("states_" + question + "_missed", missed);
    test::print("states_" + question + "_missed_inside", missed_inside);
    test::print("states_" + question + "_untrue", untrue);
  }
};

/// Prints how often we are wrong.
/// @return what is known of each state
std::vector<KnownState> compare(const PlacedStates& scene, const std::vector<StateCheck>& contact,
                                const std::vector<StateCheck>& nearest) {
  Differences of_contact;
  Differences of_nearest;
  std::vector<KnownState> known(scene.size());
  for (std::size_t i = 0; i < scene.size(); ++i) {
    if (!isTouch(nearest[i])) {
      const Truth truth = truthOf(scene, i);
      of_contact.add(truth, contact[i].verdict == Verdict::contact);
      of_nearest.add(truth, nearest[i].verdict == Verdict::contact);
      known[i] = {true, truth.meets, exactDistanceOf(nearest[i])};
    }
  }
  print("states_in_contact", of_contact.contacts);
  print("states_inside", of_contact.inside);
  of_contact.print("contact");
  of_nearest.print("nearest");
  return known;
}

}  // namespace

void measureStates(const CycleSetup& setup) {
  const PlacedStates scene = drawPlacedStates(setup, sourceGeometries(setup, {}), kStates);
  StatesWork work =
      makeStatesWork(setup, standingAt(setup.model, std::vector<Pose>(setup.model.robots.size())));
  print("states", scene.size());
  const auto contact = timeOurs("states_contact", scene, StateQuestion::contact, work);
  const auto nearest = timeOurs("states_nearest", scene, StateQuestion::nearest, work);
  timeFcl("states_fcl_collide", scene, fclContacts);
  timeFcl("states_fcl_least", scene, fclLeast);
  timeFcl("states_fcl_every_distance", scene, fclLeastOfEvery);
  [[maybe_unused]] const std::vector<KnownState> known = compare(scene, contact, nearest);
#ifdef COLLISION_MONITOR_HAS_COAL
  measureCoal(setup, scene.world_from_element, known);
#endif
}

}  // namespace collision_monitor::test
