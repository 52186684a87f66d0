// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "peers/placed_states.h"

#include <algorithm>
#include <random>
#include <stdexcept>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/cycle/place_bodies.h"
#include "support/robots/robot_moves.h"

namespace collision_monitor::test {
namespace {

struct ToGeometry {
  const std::string& object;

  Geometry operator()(const SharedMesh& mesh) const { return *mesh; }
  Geometry operator()(const Cone&) const { return refuse("a cone"); }
  Geometry operator()(const Plane&) const { return refuse("a plane"); }
  template <class Primitive>
  Geometry operator()(const Primitive& primitive) const {
    return primitive;
  }

 private:
  Geometry refuse(const char* what) const {
    throw std::runtime_error("object " + object + ": " + what + " is not compared with FCL");
  }
};

}  // namespace

std::vector<Geometry> sourceGeometries(const CycleSetup& setup, const World& world) {
  std::vector<Geometry> geometries;
  std::size_t first = 0;  // of the link
  for (std::size_t i = 0; i < setup.elements.size(); ++i) {
    const Element& element = setup.elements[i];
    first = i > 0 && setup.elements[i - 1].link == element.link ? first : i;
    const Link& link = setup.model.link(element.link);
    if (element.padding != 0.0) {
      throw std::runtime_error(link.name + ": padding is not compared with FCL");
    }
    if (setup.model.robots[index(link.robot)].is_world) {
      const ObjectShapes& shapes = *world.objects.at(link.name)->shapes;
      geometries.push_back(std::visit(ToGeometry{link.name}, shapes[i - first].geometry));
    } else {
      geometries.push_back(sourceOf(setup.model, element).geometry);
    }
  }
  return geometries;
}

PlacedStates drawPlacedStates(const CycleSetup& setup, const std::vector<Geometry>& geometries,
                              std::size_t count) {
  PlacedStates states{setup, {}, {}, {}, {}};
  std::mt19937_64 random(20260101);
  std::vector<FclGeometry> for_fcl;
  for (const Geometry& geometry : geometries) {
    for_fcl.push_back(fclGeometryOf(geometry));
    states.insides.push_back(insideOf(geometry));
  }
  BodyPoses poses = makeBodyPoses(setup);
  for (std::size_t i = 0; i < (setup.model.variable_count == 0 ? 1 : count); ++i) {
    const JointPositions state = drawPositions(setup.model, random);
    const LinkPoses links = posesAt(setup.model, state);
    placeBodies(setup, links, poses);
    placeElements(setup, links, poses);
    states.positions.insert(states.positions.end(), state.begin(), state.end());
    states.world_from_element.push_back(poses.world_from_element);
    states.fcl.push_back(placeFcl(for_fcl, poses.world_from_element));
  }
  return states;
}

Holds holdsOneInOther(const PlacedStates& states, std::size_t state, const ElementPair& pair) {
  const std::vector<Pose>& poses = states.world_from_element[state];
  const std::size_t a = index(pair.a);
  const std::size_t b = index(pair.b);
  return std::max(holdsMarkOf(states.insides[a], poses[a], states.insides[b], poses[b]),
                  holdsMarkOf(states.insides[b], poses[b], states.insides[a], poses[a]));
}

}  // namespace collision_monitor::test
