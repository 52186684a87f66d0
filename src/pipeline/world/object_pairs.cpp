// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/world/object_pairs.h"

#include <algorithm>
#include <string>
#include <unordered_map>

#include "geometry/interruption.h"
#include "model/rules/rigid_groups.h"

namespace collision_monitor {
namespace {

/// A pair that no rule has decided.
LinkPair pairOf(LinkId a, LinkId b, PairReason reason) {
  LinkPair pair{a, b};
  pair.reason = pair.without_rules = reason;
  return pair;
}

/// By object.
std::vector<std::vector<LinkId>> findTouchLinks(const RobotModel& model,
                                                const std::vector<ObjectLink>& objects) {
  std::unordered_map<std::string, LinkId> links;
  for (std::size_t i = 0; i < index(objects.front().link); ++i) {
    links.emplace(model.links[i].name, idAt<LinkId>(i));
  }
  std::vector<std::vector<LinkId>> touch_links(objects.size());
  for (std::size_t k = 0; k < objects.size(); ++k) {
    for (const std::string& name : objects[k].object->touch_links) {
      if (const auto link = links.find(name); link != links.end()) {
        touch_links[k].push_back(link->second);
      }
    }
    std::sort(touch_links[k].begin(), touch_links[k].end());
  }
  return touch_links;
}

}  // namespace

ObjectPairs::ObjectPairs(const CycleSetup& setup, const std::vector<ObjectLink>& objects)
    : setup_(setup),
      objects_(objects),
      group_of_(findRigidGroups(setup.model)),
      touch_links_(findTouchLinks(setup.model, objects)) {
  for (std::size_t k = 0; k < objects.size(); ++k) {
    if (objects[k].object->is_attached) {
      attached_.push_back(k);
    }
  }
}

PairReason ObjectPairs::reasonFor(LinkId link, std::size_t k) const {
  const ObjectLink& object = objects_[k];
  if (object.object->is_attached && group_of_[index(link)] == group_of_[index(object.link)]) {
    return PairReason::same_rigid_group;
  }
  const bool may_touch = std::binary_search(touch_links_[k].begin(), touch_links_[k].end(), link);
  return may_touch ? PairReason::touch_link : PairReason::checked;
}

/// Visits the pairs of a robot's link, in order.
template <class Visit>
void ObjectPairs::visitWithLink(LinkId link, const Visit& visit) const {
  throwIfInterrupted();
  if (hasShapes(setup_.model.link(link))) {
    for (std::size_t k = 0; k < objects_.size(); ++k) {
      visit(link, objects_[k].link, reasonFor(link, k));
    }
  }
}

/// Visits the pairs of two objects, in order.
template <class Visit>
void ObjectPairs::visitOfObjects(const Visit& visit) const {
  const auto visitOne = [&](std::size_t i, std::size_t k) {
    const LinkId a = objects_[i].link;
    const LinkId b = objects_[k].link;
    if (group_of_[index(a)] != group_of_[index(b)]) {
      visit(a, b, PairReason::checked);
    }
  };
  auto after = attached_.begin();
  for (std::size_t i = 0; i < objects_.size() && !attached_.empty(); ++i) {
    throwIfInterrupted();
    if (objects_[i].object->is_attached) {
      ++after;
      for (std::size_t k = i + 1; k < objects_.size(); ++k) {
        visitOne(i, k);
      }
      continue;
    }
    std::for_each(after, attached_.end(), [&](std::size_t k) { visitOne(i, k); });
  }
}

PairCounts ObjectPairs::count() const {
  PairCounts counts = countPairs(setup_);
  counts.link_pairs = setup_.link_pairs.size();
  const std::vector<std::uint64_t> bodies = countByLink(setup_.bodies, setup_.model);
  const std::vector<std::uint64_t> elements = countByLink(setup_.elements, setup_.model);
  const auto add = [&](LinkId a, LinkId b, PairReason reason) {
    ++counts.link_pairs;
    if (isChecked(reason)) {
      ++counts.checked;
      counts.body_pairs += bodies[index(a)] * bodies[index(b)];
      counts.element_pairs += elements[index(a)] * elements[index(b)];
      counts.object_element_pairs += elements[index(a)] * elements[index(b)];
    }
  };
  for (std::size_t i = 0; i < index(objects_.front().link); ++i) {
    visitWithLink(idAt<LinkId>(i), add);
  }
  visitOfObjects(add);
  return counts;
}

std::vector<LinkPair> ObjectPairs::merged(std::size_t count) const {
  std::vector<LinkPair> merged;
  merged.reserve(count);
  const auto add = [&](LinkId a, LinkId b, PairReason reason) {
    merged.push_back(pairOf(a, b, reason));
  };
  auto next = setup_.link_pairs.begin();
  for (std::size_t i = 0; i < index(objects_.front().link); ++i) {
    for (; next != setup_.link_pairs.end() && next->a == idAt<LinkId>(i); ++next) {
      merged.push_back(*next);
    }
    visitWithLink(idAt<LinkId>(i), add);
  }
  visitOfObjects(add);
  return merged;
}

}  // namespace collision_monitor
