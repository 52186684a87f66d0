// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>

#include "model/object_links.h"
#include "setup_parts.h"

namespace collision_monitor {
namespace {

/// The index of the first part that is of this link or a later one. Parts are in order of link.
template <class Part>
std::size_t firstFrom(const std::vector<Part>& parts, std::size_t link) {
  const auto place = std::partition_point(
      parts.begin(), parts.end(), [&](const Part& part) { return index(part.link) < link; });
  return static_cast<std::size_t>(place - parts.begin());
}

/// Marks objects that are in a checked pair.
void markChecked(const std::vector<CheckedLinkPair>& checked,
                 std::vector<CarriedObjects>& carried) {
  if (carried.empty()) {
    return;
  }
  const auto mark = [&](LinkId link) {
    const auto after = std::upper_bound(
        carried.begin(), carried.end(), index(link),
        [](std::size_t one, const CarriedObjects& objects) { return one < objects.first_link; });
    if (after != carried.begin() && index(link) < std::prev(after)->last_link) {
      std::prev(after)->is_checked = true;
    }
  };
  for (const CheckedLinkPair& pair : checked) {
    mark(pair.a);
    mark(pair.b);
  }
}

}  // namespace

std::vector<CarriedObjects> findCarried(const CycleSetup& setup) {
  // Fewer bodies are placed anew in each cycle: it takes a microsecond.
  constexpr std::size_t kMany = 64;
  std::vector<CarriedObjects> carried;
  for (const ObjectRun& run : objectRuns(setup.model)) {
    const CarriedObjects objects{run.first,
                                 run.last,
                                 firstFrom(setup.bodies, run.first),
                                 firstFrom(setup.bodies, run.last),
                                 firstFrom(setup.elements, run.first),
                                 firstFrom(setup.elements, run.last),
                                 false};
    if (objects.last_body - objects.first_body >= kMany) {
      carried.push_back(objects);
    }
  }
  markChecked(setup.checked, carried);
  return carried;
}

}  // namespace collision_monitor
