// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/pipeline/search_pairs.h"

#include <algorithm>
#include <utility>

#include "pipeline/pair_search/search_steps.h"
#include "pipeline/setup/setup_parts.h"

namespace collision_monitor {
namespace {

/// Checks every link pair but adjacent ones, whatever the rules say.
CycleSetup checkingAll(CycleSetup setup) {
  for (LinkPair& pair : setup.link_pairs) {
    if (pair.reason != PairReason::adjacent) {
      pair.reason = PairReason::checked;
    }
  }
  listPairs(setup);
  return setup;
}

PairFound foundOf(const CheckedLinkPair& links, const SeenPair& seen) {
  PairFound found{links.a, links.b};
  if (seen.is_touching) {
    const bool is_always = !seen.is_apart && !seen.is_unclear;
    found.finding = is_always ? PairFinding::always : PairFinding::sometimes;
  } else {
    found.finding = seen.is_unclear ? PairFinding::unclear : PairFinding::never;
  }
  found.touching = seen.touching;
  found.nearest = seen.nearest;
  return found;
}

bool isToProve(const PairFound& found) noexcept {
  return found.finding == PairFinding::always || found.finding == PairFinding::never;
}

/// Takes over what a proof found.
void conclude(const PairProof& proof, PairFound& found) {
  found.is_proven = proof.state == ProofState::proven;
  if (proof.state != ProofState::refuted) {
    return;
  }
  if (found.finding == PairFinding::always) {
    found.finding = PairFinding::sometimes;  // it touched in states, and is apart in `at`
  } else {
    found.finding = proof.found == Touch::touching ? PairFinding::sometimes : PairFinding::unclear;
    found.touching = proof.at;
  }
}

std::vector<JointId> jointsOf(const PairMotion& motion) {
  std::vector<JointId> joints;
  for (const JointRange& range : motion.ranges) {
    joints.push_back(range.joint);
  }
  std::sort(joints.begin(), joints.end());
  return joints;
}

Deadline deadlineOf(const PairSearchOptions& options) {
  using Clock = std::chrono::steady_clock;
  constexpr double kLongest = 1e8;  // [s]
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(
                            std::chrono::duration<double>(std::min(options.time_limit, kLongest)));
}

/// The pairs that are measured, by LinkPairIndex.
struct Search {
  const CycleSetup& setup;
  const PairSearchOptions& options;
  std::vector<JointRange> ranges;
  std::vector<Pose> world_from_root;
  std::vector<PairProof> proofs;
  std::vector<SeenPair> seen;
  std::vector<PairFound> found;
};

void begin(Search& search) {
  const CycleSetup& setup = search.setup;
  search.seen.resize(setup.checked.size());
  for (LinkPairIndex i = 0; i < setup.checked.size(); ++i) {
    const CheckedLinkPair& links = setup.checked[i];
    PairMotion motion = makePairMotion(setup.model, search.ranges, links.a, links.b);
    search.seen[i].is_fixed = motion.is_whole && motion.joints.empty();
    search.proofs.push_back(beginProof(setup, i, std::move(motion), search.world_from_root));
  }
}

/// Proves findings, or finds states that contradict them.
void prove(Deadline deadline, Search& search) {
  std::vector<PairProof> proofs;
  for (LinkPairIndex i = 0; i < search.found.size(); ++i) {
    PairFound& found = search.found[i];
    if (search.seen[i].is_fixed) {
      found.is_proven = isToProve(found);
    } else if (isToProve(found) && isUnderWay(search.proofs[i])) {
      search.proofs[i].of_touching = found.finding == PairFinding::always;
      proofs.push_back(std::move(search.proofs[i]));
    }
  }
  const std::size_t total = search.setup.link_pairs.size();
  const std::size_t settled = total - proofs.size();
  const WorkProgress& progress = search.options.proof_progress;
  const auto tell = [&](std::size_t done) {
    if (progress) {
      progress(settled + done, total);
    }
  };
  tell(0);
  proveAll(search.setup, search.options.most_cells, deadline, tell, proofs);
  for (const PairProof& proof : proofs) {
    conclude(proof, search.found[proof.pair]);
  }
  tell(proofs.size());
}

}  // namespace

std::vector<PairFound> searchPairs(const CycleSetup& setup, const PairSearchOptions& options) {
  const CycleSetup all = checkingAll(setup);
  Search search{all, options, jointRanges(all.model), options.world_from_root, {}, {}, {}};
  search.world_from_root.resize(all.model.robots.size());
  begin(search);
  LinkPairMeasures measures(all);
  drawStates(options, search.ranges, search.world_from_root, measures, search.seen);
  const Deadline deadline = deadlineOf(options);
  descendAll(all, search.proofs, deadline, search.seen);
  for (LinkPairIndex i = 0; i < all.checked.size(); ++i) {
    search.found.push_back(foundOf(all.checked[i], search.seen[i]));
    search.found.back().joints = jointsOf(search.proofs[i].motion);
  }
  prove(deadline, search);
  std::vector<PairFound> found;
  LinkPairIndex next = 0;
  for (const LinkPair& links : all.link_pairs) {
    if (links.reason == PairReason::adjacent) {
      found.push_back({links.a, links.b});
    } else {
      found.push_back(std::move(search.found[next++]));
      if (found.back().finding == PairFinding::always ||
          found.back().finding == PairFinding::never) {
        found.back().touching.clear();
      }
    }
  }
  return found;
}

}  // namespace collision_monitor
