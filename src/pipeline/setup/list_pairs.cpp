// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "geometry/interruption.h"
#include "setup_parts.h"

namespace collision_monitor {
namespace {

/// The first body or element of each link; these are in order of link. One more entry at the end.
using FirstOfLinks = std::vector<std::size_t>;

template <class Part>
FirstOfLinks firstOfLinks(const std::vector<Part>& parts, std::size_t link_count) {
  FirstOfLinks first(link_count + 1, 0);
  for (const Part& part : parts) {
    ++first[index(part.link) + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  return first;
}

/// Fills the element pairs of all checked link pairs.
/// @return the first element pair of each link pair.
std::vector<std::uint32_t> listElementPairs(const FirstOfLinks& first, CycleSetup& setup) {
  std::vector<std::uint32_t> starts;
  starts.reserve(setup.checked.size());
  std::size_t count = 0;
  for (const CheckedLinkPair& pair : setup.checked) {
    const std::size_t a = index(pair.a);
    const std::size_t b = index(pair.b);
    starts.push_back(static_cast<std::uint32_t>(count));
    count += (first[a + 1] - first[a]) * (first[b + 1] - first[b]);
  }
  setup.element_pairs.clear();
  setup.element_pairs.reserve(count);
  for (std::size_t i = 0; i < setup.checked.size(); ++i) {
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

/// Calls `visit(a, b, i)` for the bodies of each checked link pair i, in order of a, then of b.
template <class Visit>
void visitBodyPairs(const CycleSetup& setup, const FirstOfLinks& first, const Visit& visit) {
  const std::vector<CheckedLinkPair>& checked = setup.checked;
  for (std::size_t i = 0; i < checked.size();) {
    throwIfInterrupted();
    const LinkId link = checked[i].a;
    std::size_t last = i;
    while (last < checked.size() && checked[last].a == link) {
      ++last;
    }
    for (std::size_t a = first[index(link)]; a < first[index(link) + 1]; ++a) {
      for (std::size_t k = i; k < last; ++k) {
        const std::size_t other = index(checked[k].b);
        for (std::size_t b = first[other]; b < first[other + 1]; ++b) {
          visit(a, b, k);
        }
      }
    }
    i = last;
  }
}

/// Lists pairs of bodies by counting sort: their ids follow the kinds of both cores, the simpler
/// one first, and then the bodies.
class BodyPairLister {
 public:
  explicit BodyPairLister(CycleSetup& setup)
      : setup_(setup),
        first_body_(firstOfLinks(setup.bodies, setup.model.links.size())),
        first_element_(firstOfLinks(setup.elements, setup.model.links.size())) {
    for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
      const Body& body = setup.bodies[i];
      kinds_.push_back(setup.cores[i].kind);
      element_in_link_.push_back(
          static_cast<std::uint32_t>(index(body.element) - first_element_[index(body.link)]));
    }
  }

  void list() {
    const std::size_t count = countKinds();
    const std::vector<std::uint32_t> first_pair = listElementPairs(first_element_, setup_);
    std::vector<BodyPair> pairs(count);
    setup_.link_pair_of.resize(count);
    setup_.element_pair_of.resize(count);
    visitBodyPairs(setup_, first_body_, [&](std::size_t a, std::size_t b, std::size_t i) {
      const std::size_t pair = next_[kindsOf(a, b)]++;
      pairs[pair] = {idAt<BodyId>(a), idAt<BodyId>(b)};
      setup_.link_pair_of[pair] = static_cast<std::uint32_t>(i);
      setup_.element_pair_of[pair] = first_pair[i] + placeOfElements(a, b, setup_.checked[i].b);
    });
    setup_.table = PairTable(std::move(pairs), setup_.bodies.size());
  }

 private:
  static constexpr std::size_t kKinds = static_cast<std::size_t>(CoreKind::box) + 1;

  std::size_t kindsOf(std::size_t a, std::size_t b) const {
    const auto [simpler, other] = std::minmax(kinds_[a], kinds_[b]);
    return kKinds * static_cast<std::size_t>(simpler) + static_cast<std::size_t>(other);
  }

  /// Among the element pairs of their links. `link` is that of body b.
  std::uint32_t placeOfElements(std::size_t a, std::size_t b, LinkId link) const {
    const std::size_t count = first_element_[index(link) + 1] - first_element_[index(link)];
    return element_in_link_[a] * static_cast<std::uint32_t>(count) + element_in_link_[b];
  }

  /// Fills setup.ranges, and where the pairs of each kind begin.
  /// @return the number of pairs
  std::size_t countKinds() {
    std::array<std::size_t, kKinds * kKinds> counts{};
    visitBodyPairs(setup_, first_body_, [&](std::size_t a, std::size_t b, std::size_t /*i*/) {
      ++counts[kindsOf(a, b)];
    });
    std::size_t all = 0;
    setup_.ranges.clear();
    for (std::size_t kinds = 0; kinds < counts.size(); ++kinds) {
      next_[kinds] = all;
      all += counts[kinds];
      if (counts[kinds] > 0) {
        setup_.ranges.push_back({static_cast<CoreKind>(kinds / kKinds),
                                 static_cast<CoreKind>(kinds % kKinds), next_[kinds], all});
      }
    }
    return all;
  }

  CycleSetup& setup_;
  FirstOfLinks first_body_;
  FirstOfLinks first_element_;
  // By body. Bodies themselves are large, and there are many pairs.
  std::vector<CoreKind> kinds_;
  std::vector<std::uint32_t> element_in_link_;
  std::array<std::size_t, kKinds * kKinds> next_{};  ///< by both kinds: the next pair
};

}  // namespace

CycleSetup withoutTables(const CycleSetup& setup, RobotModel model) {
  CycleSetup copy;
  copy.model = std::move(model);
  copy.bodies = setup.bodies;
  copy.labels = setup.labels;
  copy.elements = setup.elements;
  copy.link_pairs = setup.link_pairs;
  copy.limits = setup.limits;
  copy.own_limits = setup.own_limits;
  copy.refine = setup.refine;
  copy.is_continuous = setup.is_continuous;
  copy.ahead = setup.ahead;
  copy.least_horizon = setup.least_horizon;
  copy.memory_limit = setup.memory_limit;
  copy.velocity_names = setup.velocity_names;
  copy.srdfs = setup.srdfs;
  copy.pair_rules = setup.pair_rules;
  copy.report = setup.report;
  return copy;
}

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
  BodyPairLister(setup).list();
  setup.blocks = makeBlocks(setup.table, setup.cores);
  setup.carried = findCarried(setup);
}

}  // namespace collision_monitor
