// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <vector>

#include "pipeline/cycle/cycle_buffers.h"
#include "pipeline/cycle/run_cycle.h"
#include "product_bench.h"
#include "support/robots/robot_moves.h"
#include "thread_time.h"

namespace collision_monitor::test {
namespace {

constexpr double kSpeed = 1.0;    // [rad/s]
constexpr double kLongest = 6e9;  // [ns] limit for cycles without a budget
constexpr std::uint32_t kNoBudget = 1'000'000'000;

/// The result of a cycle about contacts.
struct Said {
  std::vector<bool> contacts;  ///< by LinkPairIndex
  Verdict overall{Verdict::unknown};
};

Said whatIsSaid(const PairEvents& events) {
  Said said{{}, events.overall};
  for (const Verdict verdict : events.verdicts) {
    said.contacts.push_back(verdict == Verdict::contact);
  }
  return said;
}

/// Cycles of a moving robot. Each runs twice and the shorter time counts, because other programs
/// rarely disturb both. Then the same without budget and tolerance, to compare results.
class Cycles {
 public:
  /// @param tells_all somebody listens to distances
  Cycles(const CycleSetup& setup, double rate, bool tells_all)
      : setup_(setup),
        mover_(setup.model, rate, kSpeed),
        buffers_(makeBuffers(setup, BroadPhaseKind::automatic)),
        unlimited_(makeBuffers(setup, BroadPhaseKind::automatic)) {
    buffers_.refine.tells_all = tells_all;
    unlimited_.refine.limits.budget = kNoBudget;
    unlimited_.refine.limits.tolerance = 0.0;
  }

  void run(std::size_t cycles) {
    while (times_.size() < cycles) {
      std::vector<LinkPoses> move = mover_.next();
      move.resize(std::min(move.size(), std::max<std::size_t>(2, cycles - times_.size())));
      time(move);
      if (taken_without_ < kLongest) {
        compare(move);
      }
    }
  }

  void print(const std::string& name) const {
    std::vector<double> sorted = times_;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t count = sorted.size();
    test::print(name, count);
    test::print(name + "_median", sorted[count / 2], "us");
    test::print(name + "_p999", sorted[std::min(count - 1, count * 999 / 1000)], "us");
    test::print(name + "_worst", sorted.back(), "us");
    test::print(name + "_worst_later", worst_later_, "us");
    test::print(name + "_learning", learning_, "us");
    test::print(name + "_contacts", contacts_);
    test::print(name + "_compared", compared_);
    test::print(name + "_differing", differing_);
    test::print(name + "_alarms", alarms_);
    test::print(name + "_missed", missed_);
  }

 private:
  void time(const std::vector<LinkPoses>& move) {
    std::vector<double> times(move.size(), std::numeric_limits<double>::infinity());
    for (int pass = 0; pass < 2; ++pass) {
      resetMemory(buffers_);
      said_.clear();
      learn(move.front());
      for (std::size_t i = 0; i < move.size(); ++i) {
        const double taken = timeOf([&] { runCycle(setup_, move[i], buffers_); });
        times[i] = std::min(times[i], 1e-3 * taken);
        said_.push_back(whatIsSaid(buffers_.events));
      }
    }
    times_.insert(times_.end(), times.begin(), times.end());
    worst_later_ = std::max(worst_later_, *std::max_element(times.begin() + 1, times.end()));
  }

  /// As the node does when links become known.
  void learn(const LinkPoses& poses) {
    learning_ = std::max(learning_, 1e-3 * timeOf([&] { learnPairs(setup_, poses, buffers_); }));
  }

  void compare(const std::vector<LinkPoses>& move) {
    resetMemory(unlimited_);
    for (std::size_t i = 0; i < move.size(); ++i) {
      taken_without_ += timeOf([&] { runCycle(setup_, move[i], unlimited_); });
      const Said truth = whatIsSaid(unlimited_.events);
      const bool is_alarm = hasMore(said_[i], truth);
      const bool is_missed = hasMore(truth, said_[i]);
      ++compared_;
      contacts_ += truth.overall == Verdict::contact ? 1 : 0;
      differing_ += truth.overall != said_[i].overall || is_alarm || is_missed ? 1 : 0;
      alarms_ += is_alarm ? 1 : 0;
      missed_ += is_missed ? 1 : 0;
    }
  }

  /// Whether a pair is in contact in the first and not in the second.
  static bool hasMore(const Said& first, const Said& second) {
    for (std::size_t pair = 0; pair < first.contacts.size(); ++pair) {
      if (first.contacts[pair] && !second.contacts[pair]) {
        return true;
      }
    }
    return false;
  }

  const CycleSetup& setup_;
  Mover mover_;
  CycleBuffers buffers_;
  CycleBuffers unlimited_;
  std::vector<double> times_;  ///< [us]
  double worst_later_{0.0};    ///< [us] without the first cycles of moves
  double learning_{0.0};       ///< [us] greatest time before the first cycle of a move
  std::vector<Said> said_;     ///< in the last move
  double taken_without_{0.0};  ///< [ns]
  std::size_t compared_{0};    ///< cycles; of these:
  std::size_t contacts_{0};    ///< something is in contact without a budget
  std::size_t differing_{0};   ///< the level or a contact differs without a budget
  std::size_t alarms_{0};      ///< a contact is reported that vanishes without a budget
  std::size_t missed_{0};      ///< a contact is not reported that appears without a budget
};

}  // namespace

void measureCycles(const CycleSetup& setup, std::size_t cycles) {
  constexpr std::size_t kFewer = 10;  // cycles at 50 Hz then have nearly as many moves
  const auto measureAt = [&](double rate, bool tells_all, std::size_t count, const char* name) {
    Cycles run(setup, rate, tells_all);
    run.run(count);
    run.print(name);
  };
  const std::size_t fewer = std::max<std::size_t>(1, cycles / kFewer);
  measureAt(1000.0, false, cycles, "cycle_1000Hz");
  measureAt(1000.0, true, cycles, "cycle_1000Hz_told");
  measureAt(50.0, false, fewer, "cycle_50Hz");
  measureAt(50.0, true, fewer, "cycle_50Hz_told");
}

}  // namespace collision_monitor::test
