// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fcl_elements.h"

#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <stdexcept>

#include "support_fcl/solid.h"

namespace collision_monitor::test {
namespace {

struct Objects {
  const FclObject* a;
  const FclObject* b;
};

/// Calls `query` for pair after pair until it returns false.
template <class Query>
void forPairs(const CycleSetup& setup, const FclObjects& objects, const Query& query) {
  for (const ElementPair& pair : setup.element_pairs) {
    const Objects both{objects[index(pair.a)].get(), objects[index(pair.b)].get()};
    if (both.a != nullptr && both.b != nullptr && !query(both)) {
      return;
    }
  }
}

/// FCL throws when its solver gives up.
void measure(const Objects& pair, fcl::DistanceResultd& result) {
  static const fcl::DistanceRequestd kRequest(true);
  try {
    fcl::distance(pair.a, pair.b, kRequest, result);
  } catch (const std::exception&) {
    return;
  }
}

}  // namespace

const CollisionElement& sourceOf(const RobotModel& model, const Element& element) {
  for (const CollisionElement& source : model.link(element.link).collisions) {
    if (source.name == element.name) {
      return source;
    }
  }
  throw std::runtime_error("no collision element is called " + element.name);
}

std::vector<FclGeometry> fclGeometries(const CycleSetup& setup) {
  std::vector<FclGeometry> geometries;
  for (const Element& element : setup.elements) {
    geometries.push_back(fclGeometryOf(sourceOf(setup.model, element).geometry));
  }
  return geometries;
}

FclObjects placeFcl(const std::vector<FclGeometry>& geometries, const std::vector<Pose>& poses) {
  FclObjects objects;
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    objects.push_back(
        geometries[i] == nullptr
            ? nullptr
            : std::make_unique<FclObject>(geometries[i], poses[i].rotation, poses[i].translation));
  }
  return objects;
}

std::size_t fclContacts(const CycleSetup& setup, const FclObjects& objects) {
  std::size_t contacts = 0;
  forPairs(setup, objects, [&](const Objects& pair) {
    contacts +=
        pair.a->getAABB().overlap(pair.b->getAABB()) && fclOverlap(*pair.a, *pair.b).value_or(false)
            ? 1
            : 0;
    return true;
  });
  return contacts;
}

double fclLeast(const CycleSetup& setup, const FclObjects& objects) {
  fcl::DistanceResultd result;
  forPairs(setup, objects, [&](const Objects& pair) {
    if (pair.a->getAABB().distance(pair.b->getAABB()) < result.min_distance) {
      measure(pair, result);
    }
    return result.min_distance > 0.0;
  });
  return result.min_distance;
}

double fclLeastOfEvery(const CycleSetup& setup, const FclObjects& objects) {
  double least = std::numeric_limits<double>::infinity();
  forPairs(setup, objects, [&](const Objects& pair) {
    fcl::DistanceResultd result;
    measure(pair, result);
    least = std::min(least, result.min_distance);
    return true;
  });
  return least;
}

}  // namespace collision_monitor::test
