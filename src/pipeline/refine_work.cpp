// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <utility>

#include "collision_monitor/pipeline/refine_pairs.h"
#include "pipeline/recall_elements.h"

namespace collision_monitor {
namespace {

bool isMeasuredAsMesh(const Element& element) noexcept {
  return element.mesh && (!element.convex || std::holds_alternative<ConvexHull>(*element.convex));
}

}  // namespace

RefineWork makeRefineWork(const CycleSetup& setup) {
  RefineWork work;
  const std::size_t pairs = setup.element_pairs.size();
  work.limits = setup.refine;
  work.tasks.reserve(pairs);
  work.task_of.resize(pairs, kNone);
  work.is_measured.resize(pairs, 0);
  work.nearest.resize(setup.checked.size(), std::numeric_limits<double>::infinity());
  for (const Element& element : setup.elements) {
    work.balls.push_back(ballOf(element));
  }
  work.scratch = std::make_unique<RefineScratch>();
  return work;
}

std::vector<RefineMemory> makeRefineMemory(const CycleSetup& setup) {
  std::vector<RefineMemory> memory(setup.element_pairs.size());
  for (std::size_t pair = 0; pair < memory.size(); ++pair) {
    const Element& a = setup.elements[index(setup.element_pairs[pair].a)];
    const Element& b = setup.elements[index(setup.element_pairs[pair].b)];
    if (isMeasuredAsMesh(a) && isMeasuredAsMesh(b)) {
      memory[pair].front = std::make_unique<MeshFront>();
    }
    if (a.mesh && b.mesh && !(a.convex && b.convex)) {
      memory[pair].depth = std::make_unique<KeptDepth>();
    }
  }
  return memory;
}

void forget(std::vector<RefineMemory>& memory) noexcept {
  for (RefineMemory& pair : memory) {
    std::unique_ptr<MeshFront> front = std::move(pair.front);
    std::unique_ptr<KeptDepth> depth = std::move(pair.depth);
    pair = RefineMemory();
    pair.front = std::move(front);
    pair.depth = std::move(depth);
    if (pair.front) {
      pair.front->a_from_b.reset();
      pair.front->nearest.a = MeshFront::kNone;
    }
    if (pair.depth) {
      forget(*pair.depth);
    }
  }
}

}  // namespace collision_monitor
