// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "peers/fcl_elements.h"

#include <fcl/narrowphase/distance.h>

#include <exception>
#include <stdexcept>

#include "support_fcl/solid.h"

namespace collision_monitor::test {
namespace {

/// FCL throws when its solver gives up.
void measure(const FclObject& a, const FclObject& b, fcl::DistanceResultd& result) {
  static const fcl::DistanceRequestd kRequest(true);
  try {
    fcl::distance(&a, &b, kRequest, result);
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
  return placePeer<FclObject>(geometries, poses);
}

std::size_t fclContacts(const CycleSetup& setup, const FclObjects& objects) {
  return countContacts(setup, objects, [](const FclObject& a, const FclObject& b) {
    return fclOverlap(a, b).value_or(false);
  });
}

bool fclHasContact(const CycleSetup& setup, const FclObjects& objects) {
  bool has_contact = false;
  forPairs(setup, objects, [&](const FclObject& a, const FclObject& b) {
    has_contact = a.getAABB().overlap(b.getAABB()) && fclOverlap(a, b).value_or(false);
    return !has_contact;
  });
  return has_contact;
}

double fclLeast(const CycleSetup& setup, const FclObjects& objects) {
  return leastDistance<fcl::DistanceResultd>(setup, objects, measure);
}

double fclLeastOfEvery(const CycleSetup& setup, const FclObjects& objects) {
  return leastOfEveryDistance<fcl::DistanceResultd>(setup, objects, measure);
}

}  // namespace collision_monitor::test
