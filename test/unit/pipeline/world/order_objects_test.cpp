// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/world/order_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "support/random_poses.h"

namespace collision_monitor::test {
namespace {

std::vector<WorldObject> objectsAt(std::size_t count, unsigned seed) {
  Random random(seed);
  std::vector<WorldObject> objects(count);
  for (WorldObject& object : objects) {
    object.frame_from_object.translation = randomPoint(random, 1.0);
  }
  return objects;
}

std::vector<const WorldObject*> pointersTo(const std::vector<WorldObject>& objects) {
  std::vector<const WorldObject*> all;
  std::transform(objects.begin(), objects.end(), std::back_inserter(all),
                 [](const WorldObject& object) { return &object; });
  return all;
}

/// [m] The mean distance from one to the next.
double meanStep(const std::vector<const WorldObject*>& objects) {
  double length = 0.0;
  for (std::size_t i = 1; i < objects.size(); ++i) {
    length +=
        (objects[i]->frame_from_object.translation - objects[i - 1]->frame_from_object.translation)
            .norm();
  }
  return length / static_cast<double>(objects.size() - 1);
}

TEST(OrderByPlace, manyObjects_allStandBesideNearOnes) {
  const std::vector<WorldObject> objects = objectsAt(4096, 1);
  std::vector<const WorldObject*> ordered = pointersTo(objects);
  orderByPlace(ordered);
  EXPECT_LT(meanStep(ordered), 0.2 * meanStep(pointersTo(objects)));
  std::sort(ordered.begin(), ordered.end());
  EXPECT_EQ(ordered, pointersTo(objects)) << "each once";
}

TEST(OrderByPlace, fewObjectsAndThoseAtOnePlace_keepTheirOrder) {
  const std::vector<WorldObject> few = objectsAt(63, 2);
  const std::vector<WorldObject> heap(100);
  for (const std::vector<WorldObject>* objects : {&few, &heap}) {
    std::vector<const WorldObject*> ordered = pointersTo(*objects);
    orderByPlace(ordered);
    EXPECT_EQ(ordered, pointersTo(*objects));
  }
}

}  // namespace
}  // namespace collision_monitor::test
