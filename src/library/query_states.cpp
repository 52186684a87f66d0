// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <atomic>
#include <thread>

#include "geometry/all_cores.h"
#include "library/query_parts.h"
#include "model/place.h"

namespace collision_monitor {
namespace {

/// States that a thread takes at once: some milliseconds, and whole blocks of kStateCount.
constexpr std::size_t kStatesAtOnce = 64;
static_assert(kStatesAtOnce % kStateCount == 0);

StatesWork makeWork(const QueryParts& parts) {
  StatesWork work =
      makeStatesWork(parts.setup, standingAt(parts.setup.model, parts.shared.world_from_root));
  work.refinement.is_independent = true;
  return work;
}

StateAnswer answerOf(const CycleSetup& setup, const StateCheck& check) {
  StateAnswer answer;
  answer.verdict = setup.checked.empty() ? Verdict::unknown : check.verdict;
  if (check.has_pair) {
    answer.quality = check.quality;
    answer.pair = setup.link_pair_of[index(check.pair)];
    answer.distance = check.distance;
  }
  return answer;
}

/// A call of RobotQuery::check: threads take parts of the states until none is left.
class ManyStates {
 public:
  ManyStates(QueryParts& parts, Numbers states, const StatesRequest& request,
             std::vector<StateAnswer>& answers)
      : parts_(parts), states_(states), request_(request), answers_(answers) {}

  void work(StatesWork& work) {
    JointPositions positions;
    std::vector<StateCheck> checks;
    const std::size_t n = work.plan.variable_count;
    for (std::size_t first = next_.fetch_add(kStatesAtOnce);
         first < answers_.size() && !is_given_up_; first = next_.fetch_add(kStatesAtOnce)) {
      const std::size_t count = std::min(kStatesAtOnce, answers_.size() - first);
      readPositions(Numbers(states_.data() + first * n, count * n), positions);
      checkStatesExactly(parts_.setup, positions, request_.question, work, checks);
      for (std::size_t i = 0; i < count; ++i) {
        answers_[first + i] = answerOf(parts_.setup, checks[i]);
      }
      done_ += count;
      tell();
    }
  }

  /// Another thread may have done the last part.
  void tellEnd() {
    if (told_ < 1.0 && !is_given_up_) {
      tell();
    }
  }

  bool isGivenUp() const { return is_given_up_; }

 private:
  void tell() {
    if (request_.progress && std::this_thread::get_id() == caller_) {
      told_ = static_cast<double>(done_) / static_cast<double>(answers_.size());
      is_given_up_ = !request_.progress(told_);
    }
  }

  QueryParts& parts_;
  Numbers states_;
  const StatesRequest& request_;
  std::vector<StateAnswer>& answers_;
  std::thread::id caller_{std::this_thread::get_id()};
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> done_{0};
  std::atomic<bool> is_given_up_{false};
  double told_{0.0};  ///< the caller's
};

/// The number of states. A monitor without variables has one.
std::size_t countStates(const QueryParts& parts, Numbers states) {
  const std::size_t n = parts.setup.model.variable_count;
  if (n == 0 ? states.size() != 0 : states.size() % n != 0) {
    throw ArgumentError({"the states have " + counted(states.size(), "number") +
                         " together; this monitor has " + counted(n, "variable") +
                         " for each state"});
  }
  return n == 0 ? 1 : states.size() / n;
}

std::size_t countThreads(unsigned wanted, std::size_t states) {
  const std::size_t threads = wanted != 0 ? wanted : std::thread::hardware_concurrency();
  const std::size_t parts = (states + kStatesAtOnce - 1) / kStatesAtOnce;
  return std::max<std::size_t>(1, std::min(threads, parts));
}

}  // namespace

std::vector<StateAnswer> RobotQuery::check(Numbers states, const StatesRequest& request) {
  QueryParts& parts = *parts_;
  std::vector<StateAnswer> answers(countStates(parts, states));
  const std::size_t threads = countThreads(request.threads, answers.size());
  while (parts.of_threads.size() < threads) {
    parts.of_threads.push_back(makeWork(parts));
  }
  ManyStates all(parts, states, request, answers);
  forEachOnAllCores(threads, [&](std::size_t i) { all.work(parts.of_threads[i]); });
  all.tellEnd();
  if (all.isGivenUp()) {
    answers.clear();
  }
  return answers;
}

Verdict RobotQuery::verdict(Numbers state) {
  QueryParts& parts = *parts_;
  checkStateSize(parts.monitor, state);
  readPositions(state, parts.state);
  if (parts.of_threads.empty()) {
    parts.of_threads.push_back(makeWork(parts));
  }
  checkStatesExactly(parts.setup, parts.state, StateQuestion::nearest, parts.of_threads.front(),
                     parts.checks);
  return answerOf(parts.setup, parts.checks.front()).verdict;
}

}  // namespace collision_monitor
