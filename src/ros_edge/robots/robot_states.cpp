// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/robots/robot_states.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_monitor/geometry/ids.h"
#include "model/place.h"
#include "pipeline/cycle/scale_speed.h"
#include "ros_edge/outputs/sentences.h"
#include "ros_edge/robots/missing.h"

namespace collision_monitor {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// What the pairs of one robot say.
struct RobotView {
  Verdict worst{Verdict::clear};
  Speaker speaker;               ///< of the pairs with that verdict, unless it is `unknown`
  std::size_t unknowns{0};       ///< pairs that are unknown
  LinkPairIndex unknown{kNone};  ///< the first of them
  std::uint32_t closest{kNone};  ///< index into the measured pairs
  double time_to_contact{kFar};
  bool is_time_unknown{false};  ///< of a pair
};

/// Collects the views of all robots: from what was measured, from pairs that are not clear, and
/// from links whose motion is unknown. The last view is of what no robot moves.
class RobotViews {
 public:
  explicit RobotViews(const Watch& watch)
      : watch_(watch), speeds_(watch.buffers.robots), views_(watch.is_checked_between.size()) {
    const CycleSetup& setup = watch.setup();
    for (const PairDistance& distance : watch.buffers.distances.pairs) {
      const CheckedLinkPair& links = setup.checked[setup.link_pair_of[index(distance.pair)]];
      addTime(distance.time_to_contact, views_[robotOf(links.a)]);
      addTime(distance.time_to_contact, views_[robotOf(links.b)]);
    }
    for (const LinkPairIndex pair : watch.buffers.events.active) {
      addPair(pair);
    }
    const Unknowns& unknown = watch.unknown();
    for (std::size_t a = 0; a < views_.size(); ++a) {
      for (std::size_t b = 0; b < views_.size(); ++b) {
        addUnknown(unknown.between(a, b), a, b);
      }
    }
    addMotions();
  }

  const RobotView& of(RobotId robot) const { return views_[index(robot)]; }

 private:
  std::size_t robotOf(LinkId link) const { return speeds_.robot_of_link[index(link)]; }

  static void addTime(double time, RobotView& view) {
    view.is_time_unknown = view.is_time_unknown || std::isnan(time);
    view.time_to_contact = std::min(view.time_to_contact, time);  // not a number: stays
  }

  void addPair(LinkPairIndex pair) {
    const CheckedLinkPair& links = watch_.setup().checked[pair];
    const std::size_t a = robotOf(links.a);
    const std::size_t b = robotOf(links.b);
    addPair(pair, views_[a]);
    if (a != b) {
      addPair(pair, views_[b]);
    }
  }

  void addPair(LinkPairIndex pair, RobotView& view) const {
    const std::uint32_t closest = watch_.buffers.events.closest[pair];
    if (closest != kNone &&
        (view.closest == kNone || distanceAt(closest) < distanceAt(view.closest))) {
      view.closest = closest;
    }
    const Verdict verdict = watch_.buffers.events.verdicts[pair];
    if (verdict == Verdict::clear || verdict == Verdict::unknown || verdict < view.worst) {
      return;
    }
    if (verdict > view.worst) {
      view.worst = verdict;
      view.speaker = Speaker();
    }
    view.speaker.add(watch_, pair);
  }

  double distanceAt(std::uint32_t place) const {
    return watch_.buffers.distances.pairs[place].measured.distance;
  }

  /// The pairs whose links a and b these robots move.
  void addUnknown(const UnknownPairs& pairs, std::size_t a, std::size_t b) {
    if (pairs.count == 0) {
      return;
    }
    const UnknownPairs lost{pairs.first_lost == kNone ? 0U : 1U, pairs.first_lost,
                            pairs.first_lost};
    const auto add = [&](std::size_t robot, std::size_t other) {
      addUnknown(countsFor(speeds_, robot, other) ? pairs : lost, views_[robot]);
    };
    add(a, b);
    if (a != b) {
      add(b, a);
    }
  }

  static void addUnknown(const UnknownPairs& pairs, RobotView& view) {
    if (pairs.count == 0) {
      return;
    }
    view.worst = std::max(view.worst, Verdict::unknown);
    view.unknown = std::min(view.unknown, pairs.first);
    view.unknowns += pairs.count;
    view.is_time_unknown = true;
  }

  /// A link whose motion is unknown may meet each robot that it is checked with, from any distance.
  void addMotions() {
    std::vector<bool> is_unknown(views_.size());
    const auto look_at = [&](std::size_t link) {
      if (watch_.poses.velocities.known[link] == 0 && watch_.buffers.events.is_checked[link] != 0) {
        is_unknown[robotOf(idAt<LinkId>(link))] = true;
      }
    };
    forIndices(watch_.buffers.body_poses.moved.links, look_at);
    for (const CarriedObjects& objects : watch_.setup().carried) {
      if (objects.is_checked && watch_.poses.velocities.known[objects.first_link] == 0) {
        is_unknown[robotOf(idAt<LinkId>(objects.first_link))] = true;
      }
    }
    for (std::size_t a = 0; a < views_.size(); ++a) {
      for (std::size_t b = 0; b < views_.size(); ++b) {
        const bool meet = watch_.is_checked_between[a][b] && (is_unknown[a] || is_unknown[b]);
        views_[a].is_time_unknown = views_[a].is_time_unknown || (meet && countsFor(speeds_, a, b));
      }
    }
  }

  const Watch& watch_;
  const RobotSpeeds& speeds_;
  std::vector<RobotView> views_;
};

/// Why a pair is unknown.
std::string unknownPairSentence(const Watch& watch, LinkPairIndex pair) {
  return unknownSentence(watch, watch.unknown().unknownOf(watch.setup().checked[pair]));
}

/// Of the closest pair; empty if nothing was measured.
std::string closestSentence(const Watch& watch, const RobotView& view) {
  return view.closest == kNone
             ? ""
             : distanceSentence(watch.setup(), watch.buffers.distances.pairs[view.closest]);
}

/// "; absent, so only links with known poses count: robot 'right'", of robots whose unknown pairs
/// do not count for this one.
std::string absentText(const Watch& watch, const ListedRobot& listed) {
  std::vector<std::string> names;
  const std::size_t own = index(*listed.id);
  const auto counts = [&](std::size_t other) {
    return watch.buffers.robots.is_excused[other] == 0 ||
           watch.unknown().between(own, other).first_lost != kNone ||
           watch.unknown().between(other, own).first_lost != kNone;
  };
  for (const ListedRobot& robot : watch.fixed->listed) {
    if (&robot != &listed && !(robot.id ? counts(index(*robot.id)) : isAwaited(robot))) {
      names.push_back("robot '" + robot.name + "'");
    }
  }
  return names.empty() ? "" : "; absent, so only links with known poses count: " + joined(names);
}

std::string sentenceOf(const Watch& watch, const RobotView& view) {
  switch (view.worst) {
    case Verdict::contact:
    case Verdict::warning:
      return pairsSentence(watch, view.speaker);
    case Verdict::unknown:
      return unknownPairSentence(watch, view.unknown) + andMore(view.unknowns, "unknown pair");
    case Verdict::clear:
      break;
  }
  return clearText(closestSentence(watch, view));
}

double ageOf(const Watch& watch, RobotId robot) {
  const Robot& of = watch.setup().model.robots[index(robot)];
  double age = 0.0;
  for (std::size_t i = of.first_link; i < of.first_link + of.link_count; ++i) {
    age = watch.poses.status[i] == LinkStatus::known ? std::max(age, watch.poses.age[i]) : age;
  }
  return age;
}

void raiseTo(Verdict verdict, RobotState& state) {
  state.level = std::max(state.level, static_cast<std::uint8_t>(verdict));
}

void fillJudged(const Watch& watch, const ListedRobot& listed, const RobotView& view,
                RobotState& state) {
  const RobotId robot = *listed.id;
  state.level = static_cast<std::uint8_t>(view.worst);
  state.sentence = sentenceOf(watch, view) + absentText(watch, listed);
  state.speed_scale = watch.buffers.robots.scales[index(robot)];
  state.age = ageOf(watch, robot);
  if (view.closest != kNone) {
    state.distance = watch.buffers.distances.pairs[view.closest].measured.distance;
  }
  state.time_to_contact =
      view.is_time_unknown && std::isinf(view.time_to_contact) ? kUnknown : view.time_to_contact;
}

/// Others wait for a robot, which may be about to touch this one.
void fillAwaiting(const Watch& watch, const RobotView& view, RobotState& state) {
  const std::string judged =
      view.worst == Verdict::clear ? closestSentence(watch, view) : state.sentence;
  raiseTo(Verdict::unknown, state);
  state.speed_scale = 0.0;
  state.sentence = awaitedSentence(*watch.fixed) + (judged.empty() ? "" : "; ") + judged;
  if (std::isinf(state.time_to_contact)) {
    state.time_to_contact = kUnknown;
  }
}

bool isChecked(const Watch& watch, RobotId robot) {
  const std::vector<bool>& others = watch.is_checked_between[index(robot)];
  return std::find(others.begin(), others.end(), true) != others.end();
}

}  // namespace

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
    } else if (!isChecked(watch, *listed[i].id)) {
      state.sentence = "no pair of its links is checked, so nothing can be said";
    } else {
      const RobotView& view = views->of(*listed[i].id);
      fillJudged(watch, listed[i], view, state);
      if (is_any_awaited) {
        fillAwaiting(watch, view, state);
      }
    }
    if (!facts.is_enabled) {
      raiseTo(Verdict::warning, state);
      state.speed_scale = 0.0;
      state.sentence = offText(facts) + state.sentence;
    }
  }
}

}  // namespace collision_monitor
