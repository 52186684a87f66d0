// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "peers/coal_elements.h"

#include "peers/fcl_elements.h"

namespace collision_monitor::test {
namespace {

void measure(const CoalObject& a, const CoalObject& b, coal::DistanceResult& result) {
  static const coal::DistanceRequest kRequest = coalRequest(false);
  lowerByCoal(a, b, kRequest, result);
}

}  // namespace

std::vector<CoalGeometry> coalGeometries(const CycleSetup& setup) {
  std::vector<CoalGeometry> geometries;
  for (const Element& element : setup.elements) {
    geometries.push_back(coalGeometryOf(sourceOf(setup.model, element).geometry));
  }
  return geometries;
}

CoalObjects placeCoal(const std::vector<CoalGeometry>& geometries, const std::vector<Pose>& poses) {
  return placePeer<CoalObject>(geometries, poses);
}

std::size_t coalContacts(const CycleSetup& setup, const CoalObjects& objects) {
  return countContacts(setup, objects, coalOverlap);
}

double coalLeast(const CycleSetup& setup, const CoalObjects& objects) {
  return leastDistance<coal::DistanceResult>(setup, objects, measure);
}

double coalLeastOfEvery(const CycleSetup& setup, const CoalObjects& objects) {
  return leastOfEveryDistance<coal::DistanceResult>(setup, objects, measure);
}

}  // namespace collision_monitor::test
