// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <mutex>

#include "geometry/all_cores.h"
#include "pipeline/pair_search/descend.h"
#include "pipeline/pair_search/search_steps.h"

namespace collision_monitor {
namespace {

/// Tools for as many threads as work at a time. Making them takes longer than a short job.
class ToolPool {
 public:
  ToolPool(const CycleSetup& setup, const std::vector<ElementCover>& covers)
      : setup_(setup), covers_(covers) {}

  std::unique_ptr<ProofTools> take() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<ProofTools> tools = std::move(idle_.back());
        idle_.pop_back();
        return tools;
      }
    }
    return std::make_unique<ProofTools>(setup_, covers_);
  }

  void giveBack(std::unique_ptr<ProofTools> tools) {
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(tools));
  }

 private:
  const CycleSetup& setup_;
  const std::vector<ElementCover>& covers_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<ProofTools>> idle_;
};

bool isOver(Deadline deadline) noexcept { return std::chrono::steady_clock::now() > deadline; }

/// Counts proofs that are done, and tells.
class DoneCount {
 public:
  explicit DoneCount(const std::function<void(std::size_t)>& progress) : progress_(progress) {}

  void add() {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++done_;
    if (progress_) {
      progress_(done_);
    }
  }

 private:
  const std::function<void(std::size_t)>& progress_;
  std::mutex mutex_;
  std::size_t done_{0};
};

std::vector<std::size_t> underWay(const std::vector<PairProof>& proofs) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < proofs.size(); ++i) {
    if (isUnderWay(proofs[i])) {
      found.push_back(i);
    }
  }
  return found;
}

}  // namespace

void descendAll(const CycleSetup& setup, const std::vector<PairProof>& proofs, Deadline deadline,
                std::vector<SeenPair>& seen) {
  const std::vector<ElementCover> covers = coverElements(setup);
  ToolPool pool(setup, covers);
  forEachOnAllCores(proofs.size(), [&](std::size_t i) {
    SeenPair& pair = seen[i];
    if (pair.is_touching || pair.is_unclear || pair.nearest_state.empty() || isOver(deadline)) {
      return;
    }
    std::unique_ptr<ProofTools> tools = pool.take();
    JointPositions state = pair.nearest_state;
    keep(descend(*tools, proofs[i].pair, proofs[i].motion, proofs[i].world_from_root, state), state,
         pair);
    pool.giveBack(std::move(tools));
  });
}

void proveAll(const CycleSetup& setup, std::size_t most_cells, Deadline deadline,
              const std::function<void(std::size_t)>& progress, std::vector<PairProof>& proofs) {
  constexpr std::size_t kFirstCells = 256;
  const std::vector<ElementCover> covers = coverElements(setup);
  ToolPool pool(setup, covers);
  DoneCount done(progress);
  std::size_t cells = std::min(kFirstCells, most_cells);
  std::vector<std::size_t> open = underWay(proofs);
  while (!open.empty() && !isOver(deadline)) {
    forEachOnAllCores(open.size(), [&](std::size_t i) {
      std::unique_ptr<ProofTools> tools = pool.take();
      PairProof& proof = proofs[open[i]];
      advance(*tools, cells, deadline, proof);
      pool.giveBack(std::move(tools));
      if (!isUnderWay(proof) || proof.cells >= most_cells) {
        done.add();
      }
    });
    open = cells == most_cells ? std::vector<std::size_t>() : underWay(proofs);
    cells = std::min(2 * cells, most_cells);
  }
}

}  // namespace collision_monitor
