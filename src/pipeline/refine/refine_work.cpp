// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "model/object_links.h"
#include "pipeline/data/activation_distance.h"
#include "pipeline/refine/recall_elements.h"
#include "pipeline/refine/refine_pairs.h"

namespace collision_monitor {
namespace {

/// What matters of an element. There are many pairs, and elements are large.
struct ElementTraits {
  const MeshTree* mesh;  ///< or nullptr
  bool has_convex;
  bool is_body;
};

/// Fronts are kept where a mesh is searched, against a mesh or a solid.
RefineKind refineKindOf(const ElementTraits& a, const ElementTraits& b) noexcept {
  const bool has_meshes = a.mesh != nullptr && b.mesh != nullptr;
  const bool has_front =
      (a.mesh != nullptr && !a.has_convex) || (b.mesh != nullptr && !b.has_convex);
  const bool has_depth = has_meshes && !(a.has_convex && b.has_convex);
  if (a.is_body && b.is_body) {
    return RefineKind::never;
  }
  if (has_front) {
    return has_depth ? RefineKind::both : RefineKind::front;
  }
  return has_depth ? RefineKind::depth : RefineKind::plain;
}

}  // namespace

std::uint32_t budgetOf(const RefineWork& work) noexcept {
  constexpr double kUsual = 0.004;            // [s] up to this time the budget is not raised
  constexpr std::size_t kBodiesBeside = 400;  // a period has time for these beside the budget
  constexpr double kMost = 4.0;
  constexpr double kAny = std::numeric_limits<std::uint32_t>::max();
  const double time = std::min(work.elapsed, work.limits.period);
  const double times = std::max(1.0, std::min(kMost, time / kUsual));
  const auto budget = static_cast<std::uint32_t>(std::min(kAny, times * work.limits.budget));
  // Two bodies are found, measured and judged in about the time of a node pair.
  const std::size_t counted = work.near_bodies - std::min(work.near_bodies, kBodiesBeside);
  return budget - static_cast<std::uint32_t>(std::min<std::size_t>(budget / 2, counted));
}

RefineWork makeRefineWork(const CycleSetup& setup) {
  RefineWork work;
  const std::size_t pairs = setup.element_pairs.size();
  work.limits = setup.refine;
  work.distances.push_back(nearActivationDistanceOf(setup, setup.limits));
  for (const OwnLimits& own : setup.own_limits) {
    work.distances.push_back(nearActivationDistanceOf(setup, own.limits));
  }
  work.tasks.reserve(pairs);
  work.task_of.resize(pairs, kNone);
  work.is_measured.resize(pairs, 0);
  work.is_passed.resize(pairs, 0);
  work.nearest.resize(setup.checked.size(), std::numeric_limits<double>::infinity());
  work.told_below.resize(setup.checked.size(), -std::numeric_limits<double>::infinity());
  for (const Element& element : setup.elements) {
    work.balls.push_back(ballOf(element));
  }
  work.scratch = std::make_unique<RefineScratch>();
  return work;
}

RefineStore makeRefineMemory(const CycleSetup& setup) {
  std::vector<ElementTraits> traits;
  traits.reserve(setup.elements.size());
  for (const Element& element : setup.elements) {
    traits.push_back({element.mesh.get(), element.convex.has_value(), element.is_body});
  }
  const LinkId first_of_world = firstOfWorld(setup.model);
  std::vector<RefineKind> kinds;
  kinds.reserve(setup.element_pairs.size());
  std::size_t probes = 0;
  std::vector<unsigned char> is_of_object(hasObjects(setup.model) ? setup.element_pairs.size() : 0,
                                          0);
  for (const ElementPair& pair : setup.element_pairs) {
    if (setup.checked[pair.link_pair].b >= first_of_world) {
      is_of_object[kinds.size()] = 1;
    }
    const ElementTraits& a = traits[index(pair.a)];
    const ElementTraits& b = traits[index(pair.b)];
    kinds.push_back(refineKindOf(a, b));
    if (kinds.back() == RefineKind::both) {
      probes = std::max(probes, countProbes(*a.mesh, *b.mesh));
    }
  }
  return RefineStore(std::move(kinds), probes, std::move(is_of_object));
}

}  // namespace collision_monitor
