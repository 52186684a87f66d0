// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "pipeline/blocks/contact_of_pairs.h"
#include "pipeline/states/states_block.h"

namespace collision_monitor {
namespace {

/// Whether geometries must decide. The nearest bodies may not be the ones in contact, nor those
/// that are a warning by limits of their own.
bool isOpen(const CycleSetup& setup, const StateCheck& check) noexcept {
  const bool is_contact = check.verdict == Verdict::contact;
  const bool is_near = is_contact || check.verdict == Verdict::warning;
  if (!is_near || check.quality != Quality::exact) {
    return is_near;
  }
  const std::uint32_t link_pair = setup.link_pair_of[index(check.pair)];
  return check.distance > (is_contact ? contactOfBodies(setup, check.pair)
                                      : limitsOf(setup, link_pair).warning_distance);
}

/// Answers open states by enclosing shapes. Those that need geometries stay open.
void settleApart(const CycleSetup& setup, StatesWork& work, OpenStates& open,
                 BlockChecks& checks) noexcept {
  StateNumber asked;
  for (std::size_t lane = 0; lane < kStateCount; ++lane) {
    asked.of[lane] = open[lane] ? kContactsAsked : kNotAsked;
  }
  StatesBlock block;
  judgeNearest(setup, asked, work, block);
  for (std::size_t lane = 0; lane < kStateCount; ++lane) {
    if (open[lane]) {
      checks[lane] = checkOf(setup, block, lane);
      open[lane] = isOpen(setup, checks[lane]);
    }
  }
}

void settleNearest(const CycleSetup& setup, StatesWork& work, OpenStates& open,
                   BlockChecks& checks) noexcept {
  refineNearest(setup, open, work, checks);
  open.fill(false);
}

void decideContacts(const CycleSetup& setup, StatesWork& work, OpenStates& open,
                    BlockChecks& checks) noexcept {
  refineContacts(setup, open, work, checks);
  open.fill(false);
}

/// Places the open states from `first` on, as many as a block takes.
void placeOpen(const JointPositions& positions, std::size_t first, StatesWork& work) noexcept {
  const auto begin = work.open.begin() + static_cast<std::ptrdiff_t>(first);
  const auto left = static_cast<std::size_t>(work.open.end() - begin);
  const auto end = begin + static_cast<std::ptrdiff_t>(std::min(kStateCount, left));
  if (std::equal(begin, end, work.placed.begin(), work.placed.end())) {
    return;
  }
  work.placed.assign(begin, end);
  fillPlaced(positions, work);
  placeFrames(work.plan, work.variables, work.frames);
  placeCenters(work);
}

using Stage = void (*)(const CycleSetup&, StatesWork&, OpenStates&, BlockChecks&) noexcept;

/// Lets a stage answer the open states, block by block. What it leaves open fills new blocks, with
/// what is known so far.
void runStage(const CycleSetup& setup, const JointPositions& positions, Stage stage,
              StatesWork& work, std::vector<StateCheck>& checks) noexcept {
  std::size_t left = 0;
  for (std::size_t first = 0; first < work.open.size(); first += kStateCount) {
    placeOpen(positions, first, work);
    OpenStates open{};
    BlockChecks of_block;
    for (std::size_t lane = 0; lane < work.placed.size(); ++lane) {
      open[lane] = true;
      of_block[lane] = checks[work.placed[lane]];
    }
    stage(setup, work, open, of_block);
    for (std::size_t lane = 0; lane < work.placed.size(); ++lane) {
      checks[work.placed[lane]] = of_block[lane];
      if (open[lane]) {
        work.open[left++] = work.placed[lane];
      }
    }
  }
  work.open.resize(left);
}

/// Opens those of the states [first, last) whose numbers are finite; others are unknown.
void openStates(const JointPositions& positions, std::size_t first, std::size_t last,
                StatesWork& work) noexcept {
  const std::size_t variables = work.plan.variable_count;
  work.placed.clear();
  work.open.clear();
  for (std::size_t state = first; state < last; ++state) {
    const double* const numbers = positions.data() + state * variables;
    if (std::all_of(numbers, numbers + variables, [](double one) { return std::isfinite(one); })) {
      work.open.push_back(static_cast<std::uint32_t>(state));
    }
  }
}

}  // namespace

void checkStatesExactly(const CycleSetup& setup, const JointPositions& positions,
                        StateQuestion question, StatesWork& work, std::vector<StateCheck>& checks) {
  checks.assign(countStates(positions, work), StateCheck());
  const auto run = [&](Stage stage) { runStage(setup, positions, stage, work, checks); };
  for (std::size_t first = 0; first < checks.size(); first += kOpenStates) {
    openStates(positions, first, std::min(checks.size(), first + kOpenStates), work);
    if (question == StateQuestion::contact) {
      run(decideContacts);
      continue;
    }
    // Contacts settle most states that have some. What is left goes to ever dearer searches. With
    // one limit for all, the nearest of bodies that are their elements tells of contacts, too.
    if (work.refinement.has_geometries || !setup.own_limits.empty()) {
      run(settleContacts);
    }
    run(settleApart);
    run(settleNearest);
  }
  addUnknown(work, checks);
}

}  // namespace collision_monitor
