// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "collision_monitor/pipeline/setup.h"

/// The pairs of a set-up as questions for a peer: FCL or Coal. Both keep a geometry and its pose in
/// an object that knows its box.
namespace collision_monitor::test {

/// By ElementId; nullptr where the peer has no geometry.
template <class Object>
using PeerObjects = std::vector<std::unique_ptr<Object>>;

/// At these poses, by ElementId.
template <class Object, class Geometry>
PeerObjects<Object> placePeer(const std::vector<Geometry>& geometries,
                              const std::vector<Pose>& poses) {
  PeerObjects<Object> objects;
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    objects.push_back(
        geometries[i] == nullptr
            ? nullptr
            : std::make_unique<Object>(geometries[i], poses[i].rotation, poses[i].translation));
  }
  return objects;
}

/// Calls `query` for pair after pair until it returns false.
template <class Object, class Query>
void forPairs(const CycleSetup& setup, const PeerObjects<Object>& objects, const Query& query) {
  for (const ElementPair& pair : setup.element_pairs) {
    const Object* a = objects[index(pair.a)].get();
    const Object* b = objects[index(pair.b)].get();
    if (a != nullptr && b != nullptr && !query(*a, *b)) {
      return;
    }
  }
}

/// The number of pairs for which `overlap` is true. It is asked only where boxes meet.
template <class Object, class Overlap>
std::size_t countContacts(const CycleSetup& setup, const PeerObjects<Object>& objects,
                          const Overlap& overlap) {
  std::size_t contacts = 0;
  forPairs(setup, objects, [&](const Object& a, const Object& b) {
    contacts += a.getAABB().overlap(b.getAABB()) && overlap(a, b) ? 1 : 0;
    return true;
  });
  return contacts;
}

/// [m] The least distance of all pairs; 0 or less if surfaces cross. `measure` lowers a `Result`,
/// so it is told the least distance so far. It is not asked where boxes are farther apart, nor
/// after a contact.
template <class Result, class Object, class Measure>
double leastDistance(const CycleSetup& setup, const PeerObjects<Object>& objects,
                     const Measure& measure) {
  Result result;
  forPairs(setup, objects, [&](const Object& a, const Object& b) {
    if (a.getAABB().distance(b.getAABB()) < result.min_distance) {
      measure(a, b, result);
    }
    return result.min_distance > 0.0;
  });
  return result.min_distance;
}

/// As leastDistance, with every pair measured alone.
template <class Result, class Object, class Measure>
double leastOfEveryDistance(const CycleSetup& setup, const PeerObjects<Object>& objects,
                            const Measure& measure) {
  double least = std::numeric_limits<double>::infinity();
  forPairs(setup, objects, [&](const Object& a, const Object& b) {
    Result result;
    measure(a, b, result);
    least = std::min(least, result.min_distance);
    return true;
  });
  return least;
}

}  // namespace collision_monitor::test
