// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numeric>
#include <tuple>

#include "geometry/interruption.h"
#include "setup_parts.h"

namespace collision_monitor {
namespace {

struct ListedPair {
  CoreKind kind_a;  ///< the simpler of the two kinds
  CoreKind kind_b;
  BodyPair bodies;
  std::uint32_t link_pair;

  auto order() const { return std::make_tuple(kind_a, kind_b, bodies.a, bodies.b); }
};

/// The index of the first body or element of each link; these are in order of link.
template <class Part>
std::vector<std::size_t> firstOfLinks(const std::vector<Part>& parts, std::size_t link_count) {
  std::vector<std::size_t> first(link_count + 1, 0);
  for (const Part& part : parts) {
    ++first[index(part.link) + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  return first;
}

ListedPair listedPair(const CycleSetup& setup, std::size_t a, std::size_t b,
                      std::size_t link_pair) {
  const auto [simpler, other] =
      std::minmax({coreKindOf(setup.bodies[a].shape), coreKindOf(setup.bodies[b].shape)});
  return {
      simpler, other, {idAt<BodyId>(a), idAt<BodyId>(b)}, static_cast<std::uint32_t>(link_pair)};
}

/// The number of pairs of bodies or elements of all checked link pairs.
std::size_t countPairs(const CycleSetup& setup, const std::vector<std::size_t>& first) {
  std::size_t count = 0;
  for (const CheckedLinkPair& pair : setup.checked) {
    const std::size_t a = index(pair.a);
    const std::size_t b = index(pair.b);
    count += (first[a + 1] - first[a]) * (first[b + 1] - first[b]);
  }
  return count;
}

std::vector<ListedPair> listBodyPairs(const CycleSetup& setup) {
  const std::vector<std::size_t> first = firstOfLinks(setup.bodies, setup.model.links.size());
  std::vector<ListedPair> listed;
  listed.reserve(countPairs(setup, first));
  for (std::size_t i = 0; i < setup.checked.size(); ++i) {
    throwIfInterrupted();
    const std::size_t link_a = index(setup.checked[i].a);
    const std::size_t link_b = index(setup.checked[i].b);
    for (std::size_t a = first[link_a]; a < first[link_a + 1]; ++a) {
      for (std::size_t b = first[link_b]; b < first[link_b + 1]; ++b) {
        listed.push_back(listedPair(setup, a, b, i));
      }
    }
  }
  std::sort(listed.begin(), listed.end(), [](const ListedPair& one, const ListedPair& other) {
    return one.order() < other.order();
  });
  return listed;
}

/// Fills the element pairs of all checked link pairs.
/// @return the first element pair of each link pair.
std::vector<std::size_t> listElementPairs(CycleSetup& setup) {
  const std::vector<std::size_t> first = firstOfLinks(setup.elements, setup.model.links.size());
  std::vector<std::size_t> starts;
  starts.reserve(setup.checked.size());
  setup.element_pairs.clear();
  setup.element_pairs.reserve(countPairs(setup, first));
  for (std::size_t i = 0; i < setup.checked.size(); ++i) {
    starts.push_back(setup.element_pairs.size());
    const std::size_t link_a = index(setup.checked[i].a);
    const std::size_t link_b = index(setup.checked[i].b);
    for (std::size_t a = first[link_a]; a < first[link_a + 1]; ++a) {
      for (std::size_t b = first[link_b]; b < first[link_b + 1]; ++b) {
        setup.element_pairs.push_back(
            {idAt<ElementId>(a), idAt<ElementId>(b), static_cast<std::uint32_t>(i)});
      }
    }
  }
  return starts;
}

/// Fills the pair of elements of each pair of bodies, by PairId.
void linkBodiesToElements(CycleSetup& setup) {
  const std::vector<std::size_t> starts = listElementPairs(setup);
  setup.element_pair_of.clear();
  setup.element_pair_of.reserve(setup.table.size());
  for (std::size_t i = 0; i < setup.table.size(); ++i) {
    throwIfInterrupted();
    const BodyPair& bodies = setup.table.pairs()[i];
    const ElementId a = setup.bodies[index(bodies.a)].element;
    const ElementId b = setup.bodies[index(bodies.b)].element;
    std::size_t pair = starts[setup.link_pair_of[i]];
    while (setup.element_pairs[pair].a != a || setup.element_pairs[pair].b != b) {
      ++pair;
    }
    setup.element_pair_of.push_back(static_cast<ElementPairIndex>(pair));
  }
}

void extendRanges(const ListedPair& pair, std::size_t position, std::vector<PairRange>& ranges) {
  if (ranges.empty() || ranges.back().a != pair.kind_a || ranges.back().b != pair.kind_b) {
    ranges.push_back({pair.kind_a, pair.kind_b, position, position});
  }
  ranges.back().last = position + 1;
}

/// Fills the ranges and the link pairs of body pairs. @return the body pairs in order.
std::vector<BodyPair> takeBodyPairs(CycleSetup& setup) {
  const std::vector<ListedPair> listed = listBodyPairs(setup);
  std::vector<BodyPair> pairs;
  pairs.reserve(listed.size());
  setup.ranges.clear();
  setup.link_pair_of.clear();
  setup.link_pair_of.reserve(listed.size());
  for (const ListedPair& pair : listed) {
    extendRanges(pair, pairs.size(), setup.ranges);
    pairs.push_back(pair.bodies);
    setup.link_pair_of.push_back(pair.link_pair);
  }
  return pairs;
}

}  // namespace

void listPairs(CycleSetup& setup) {
  setup.checked.clear();
  setup.checked.reserve(static_cast<std::size_t>(
      std::count_if(setup.link_pairs.begin(), setup.link_pairs.end(),
                    [](const LinkPair& pair) { return isChecked(pair.reason); })));
  for (const LinkPair& pair : setup.link_pairs) {
    if (isChecked(pair.reason)) {
      setup.checked.push_back({pair.a, pair.b, pair.limits});
    }
  }
  setup.cores.clear();
  for (const Body& body : setup.bodies) {
    setup.cores.push_back(coreOf(body.shape));
  }
  setup.table = PairTable(takeBodyPairs(setup), setup.bodies.size());
  setup.blocks = makeBlocks(setup.table, setup.cores);
  linkBodiesToElements(setup);
  setup.carried = findCarried(setup);
}

}  // namespace collision_monitor
