// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "peer_times.h"
#include "peers/fcl_elements.h"
#include "pipeline/cycle/place_bodies.h"
#include "pipeline/states/check_states.h"
#include "product_bench.h"
#include "product_coal.h"
#include "support/robots/robot_moves.h"
#include "support_fcl/solid.h"
#include "thread_time.h"

namespace collision_monitor::test {
namespace {

constexpr std::size_t kStates = 200;
constexpr double kTouch = 1e-6;  // [m] FCL's tolerance: nearer to 0, either verdict is right

/// The same states for us and for FCL.
struct Scene {
  const CycleSetup& setup;
  JointPositions positions;
  std::vector<std::vector<Pose>> world_from_element;  ///< by state and ElementId
  std::vector<FclObjects> fcl;                        ///< by state
  std::vector<Inside> insides;                        ///< by ElementId

  std::size_t size() const { return fcl.size(); }
};

/// A model without moving joints has one state.
Scene makeScene(const CycleSetup& setup) {
  Scene scene{setup, {}, {}, {}, {}};
  std::mt19937_64 random(20260101);
  const std::vector<FclGeometry> geometries = fclGeometries(setup);
  BodyPoses poses = makeBodyPoses(setup);
  for (std::size_t i = 0; i < (setup.model.variable_count == 0 ? 1 : kStates); ++i) {
    const JointPositions state = drawPositions(setup.model, random);
    const LinkPoses links = posesAt(setup.model, state);
    placeBodies(setup, links, poses);
    placeElements(setup, links, poses);
    scene.positions.insert(scene.positions.end(), state.begin(), state.end());
    scene.world_from_element.push_back(poses.world_from_element);
    scene.fcl.push_back(placeFcl(geometries, poses.world_from_element));
  }
  for (const Element& element : setup.elements) {
    scene.insides.push_back(insideOf(sourceOf(setup.model, element).geometry));
  }
  return scene;
}

template <class Query>
void timeFcl(const std::string& name, const Scene& scene, const Query& query) {
  timePeer(name, scene.size(), [&](std::size_t state) { query(scene.setup, scene.fcl[state]); });
}

std::vector<StateCheck> timeOurs(const std::string& name, const Scene& scene,
                                 StateQuestion question, StatesWork& work) {
  constexpr int kCalls = 5;
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

bool isInside(const Scene& scene, const std::vector<Pose>& poses, const ElementPair& pair) {
  const std::size_t a = index(pair.a);
  const std::size_t b = index(pair.b);
  return holdsMarkOf(scene.insides[a], poses[a], scene.insides[b], poses[b]) != Holds::no ||
         holdsMarkOf(scene.insides[b], poses[b], scene.insides[a], poses[a]) != Holds::no;
}

/// Tests for elements inside others only where surfaces do not meet.
Truth truthOf(const Scene& scene, std::size_t state) {
  const std::vector<ElementPair>& pairs = scene.setup.element_pairs;
  Truth truth;
  truth.meets = fclContacts(scene.setup, scene.fcl[state]) > 0;
  truth.holds =
      !truth.meets && std::any_of(pairs.begin(), pairs.end(), [&](const ElementPair& pair) {
        return isInside(scene, scene.world_from_element[state], pair);
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
std::vector<KnownState> compare(const Scene& scene, const std::vector<StateCheck>& contact,
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
  const Scene scene = makeScene(setup);
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
