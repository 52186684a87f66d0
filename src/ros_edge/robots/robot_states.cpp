// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/robots/robot_states.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_monitor/geometry/ids.h"
#include "ros_edge/outputs/sentences.h"

namespace collision_monitor {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// What the pairs of one robot say.
struct RobotView {
  Verdict worst{Verdict::clear};
  LinkPairIndex speaker{kNone};  ///< the nearest pair with that verdict; kNone: none was measured
  double speaker_distance{kFar};
  std::size_t count{0};          ///< pairs with that verdict
  LinkPairIndex unknown{kNone};  ///< the first pair that is unknown
  std::uint32_t closest{kNone};  ///< index into the measured pairs
  double time_to_contact{kFar};
};

/// Collects the views of all robots: from what was measured, and from pairs that are not clear.
class RobotViews {
 public:
  explicit RobotViews(const Watch& watch)
      : watch_(watch), robots_(watch.buffers.robots), views_(robots_.scales.size()) {
    const CycleSetup& setup = watch.setup();
    const std::vector<PairDistance>& measured = watch.buffers.distances.pairs;
    for (std::uint32_t i = 0; i < measured.size(); ++i) {
      const CheckedLinkPair& links = setup.checked[setup.link_pair_of[index(measured[i].pair)]];
      addDistance(i, views_[robotOf(links.a)]);
      addDistance(i, views_[robotOf(links.b)]);
    }
    const PairEvents& events = watch.buffers.events;
    if (events.unknown == 0) {
      std::for_each(events.active.begin(), events.active.end(),
                    [&](LinkPairIndex pair) { addPair(pair); });
    } else {
      for (LinkPairIndex pair = 0; pair < setup.checked.size(); ++pair) {
        addPair(pair);
      }
    }
  }

  const RobotView& of(RobotId robot) const { return views_[index(robot)]; }

 private:
  std::uint32_t robotOf(LinkId link) const { return robots_.robot_of_link[index(link)]; }

  void addPair(LinkPairIndex pair) {
    const Verdict verdict = watch_.buffers.events.verdicts[pair];
    if (verdict == Verdict::clear) {
      return;
    }
    const CheckedLinkPair& links = watch_.setup().checked[pair];
    const std::uint32_t a = robotOf(links.a);
    const std::uint32_t b = robotOf(links.b);
    const bool is_unknown = verdict == Verdict::unknown;
    if (a == b || !is_unknown || robots_.is_excused[b] == 0) {
      addVerdict(pair, views_[a]);
    }
    if (a != b && (!is_unknown || robots_.is_excused[a] == 0)) {
      addVerdict(pair, views_[b]);
    }
  }

  void addDistance(std::uint32_t place, RobotView& view) {
    const std::vector<PairDistance>& measured = watch_.buffers.distances.pairs;
    if (view.closest == kNone ||
        measured[place].measured.distance < measured[view.closest].measured.distance) {
      view.closest = place;
    }
    view.time_to_contact = std::min(view.time_to_contact, measured[place].time_to_contact);
  }

  void addVerdict(LinkPairIndex pair, RobotView& view) {
    const Verdict verdict = watch_.buffers.events.verdicts[pair];
    if (verdict == Verdict::unknown && view.unknown == kNone) {
      view.unknown = pair;
    }
    if (verdict < view.worst) {
      return;
    }
    if (verdict > view.worst) {
      view.worst = verdict;
      view.speaker = kNone;
      view.count = 0;
    }
    ++view.count;
    const std::uint32_t place = speakerOf(watch_.setup(), watch_.buffers, pair);
    const double distance =
        place == kNone ? kFar : watch_.buffers.distances.pairs[place].measured.distance;
    if (place != kNone && (view.speaker == kNone || distance < view.speaker_distance)) {
      view.speaker = pair;
      view.speaker_distance = distance;
    }
  }

  const Watch& watch_;
  const RobotSpeeds& robots_;
  std::vector<RobotView> views_;
};

/// Why a pair is unknown.
std::string unknownPairSentence(const Watch& watch, LinkPairIndex pair) {
  const CheckedLinkPair& links = watch.setup().checked[pair];
  const MainPart main(watch.poses, watch.setup().checked);
  return unknownSentence(watch, main.has(links.a) ? links.b : links.a);
}

std::string sentenceOf(const Watch& watch, const RobotView& view) {
  switch (view.worst) {
    case Verdict::contact:
    case Verdict::warning:
      return view.speaker == kNone
                 ? std::to_string(view.count) + " pairs of links are near each other"
                 : pairSentence(watch, view.speaker) + andMore(view.count, "pair");
    case Verdict::unknown:
      return unknownPairSentence(watch, view.unknown) + andMore(view.count, "unknown pair");
    case Verdict::clear:
      break;
  }
  return view.closest == kNone
             ? "clear"
             : "clear; " +
                   distanceSentence(watch.setup(), watch.buffers.distances.pairs[view.closest]);
}

double ageOf(const Watch& watch, RobotId robot) {
  const Robot& of = watch.setup().model.robots[index(robot)];
  double age = 0.0;
  for (std::size_t i = of.first_link; i < of.first_link + of.link_count; ++i) {
    age = watch.poses.status[i] == LinkStatus::known ? std::max(age, watch.poses.age[i]) : age;
  }
  return age;
}

void fillJudged(const Watch& watch, RobotId robot, const RobotView& view, RobotState& state) {
  state.level = static_cast<std::uint8_t>(view.worst);
  state.sentence = sentenceOf(watch, view);
  state.speed_scale = watch.buffers.robots.scales[index(robot)];
  state.age = ageOf(watch, robot);
  if (view.closest != kNone) {
    state.distance = watch.buffers.distances.pairs[view.closest].measured.distance;
  }
  const bool has_unknown = view.unknown != kNone && view.time_to_contact == kFar;
  state.time_to_contact = has_unknown ? kUnknown : view.time_to_contact;
}

void raiseTo(Verdict verdict, RobotState& state) {
  state.level = std::max(state.level, static_cast<std::uint8_t>(verdict));
}

}  // namespace

bool isAnyAwaited(const MonitorSetup& setup) {
  return std::any_of(setup.listed.begin(), setup.listed.end(),
                     [](const ListedRobot& robot) { return !robot.id && !robot.may_be_absent; });
}

std::string missingSentence(const MonitorSetup& setup) {
  std::string text;
  std::size_t count = 0;
  for (const ListedRobot& robot : setup.listed) {
    if (!robot.id) {
      text = count == 0 ? "robot '" + robot.name + "' is missing: " + robot.missing : text;
      ++count;
    }
  }
  return text + andMore(count, "robot");
}

void fillRobotStates(const Watch& watch, const CycleFacts& facts, const std::string& blind_reason,
                     std::vector<RobotState>& states) {
  const std::vector<ListedRobot>& listed = watch.fixed->listed;
  states.resize(listed.size());
  const bool is_judged = blind_reason.empty() && !listed.empty();
  const std::optional<RobotViews> views =
      is_judged ? std::optional<RobotViews>(std::in_place, watch) : std::nullopt;
  const bool is_any_awaited = isAnyAwaited(*watch.fixed);
  for (std::size_t i = 0; i < listed.size(); ++i) {
    RobotState& state = states[i];
    state.name = listed[i].name;
    state.has_description = listed[i].id ? 1 : 0;
    state.level = static_cast<std::uint8_t>(Verdict::unknown);
    state.speed_scale = 0.0;
    state.distance = state.time_to_contact = kUnknown;
    state.age = 0.0;
    if (!listed[i].id) {
      state.sentence = listed[i].missing;
    } else if (!is_judged) {
      state.sentence = blind_reason;
    } else if (watch.is_robot_checked[index(*listed[i].id)] == 0) {
      state.sentence = "no pair of its links is checked, so nothing can be said";
    } else {
      fillJudged(watch, *listed[i].id, views->of(*listed[i].id), state);
      if (is_any_awaited) {
        raiseTo(Verdict::unknown, state);
        state.speed_scale = 0.0;
        state.sentence = missingSentence(*watch.fixed) + "; " + state.sentence;
      }
    }
    if (!facts.is_enabled) {
      raiseTo(Verdict::warning, state);
      state.speed_scale = 0.0;
    }
  }
}

}  // namespace collision_monitor
