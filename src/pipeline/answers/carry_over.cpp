// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/answers/carry_over.h"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <unordered_map>

#include "geometry/ball_motion.h"
#include "geometry/constants.h"
#include "model/object_links.h"
#include "pipeline/cycle/distance_cache.h"
#include "pipeline/objects/find_resting.h"

namespace collision_monitor {
namespace {

/// An object may have the name of a frame that carries others.
std::string keyOf(const RobotModel& model, std::size_t link) {
  return (isObject(model, idAt<LinkId>(link)) ? "object " : "frame ") + model.links[link].frame;
}

std::vector<std::uint32_t> planLinks(const RobotModel& from, const RobotModel& to) {
  std::unordered_map<std::string, std::uint32_t> places;
  for (std::size_t i = 0; i < from.links.size(); ++i) {
    places.emplace(keyOf(from, i), static_cast<std::uint32_t>(i));
  }
  std::vector<std::uint32_t> link_of(to.links.size(), kNone);
  for (std::size_t i = 0; i < to.links.size(); ++i) {
    const auto place = places.find(keyOf(to, i));
    link_of[i] = place == places.end() ? kNone : place->second;
  }
  return link_of;
}

/// Robots are the same if their roots are. One that objects of robots' links form is new each time;
/// its links do not move on their own.
std::vector<std::uint32_t> planRobots(const RobotModel& from, const RobotModel& to,
                                      const std::vector<std::uint32_t>& link_of) {
  std::vector<std::uint32_t> robot_of;
  for (const Robot& robot : to.robots) {
    const std::uint32_t root = link_of[index(robot.root)];
    robot_of.push_back(root == kNone ? kNone
                                     : static_cast<std::uint32_t>(index(from.links[root].robot)));
  }
  return robot_of;
}

/// The former pair of two former links; kNone if it is not checked.
/// @param likely mostly its place
LinkPairIndex findPair(const std::vector<CheckedLinkPair>& pairs, std::uint32_t one,
                       std::uint32_t other, LinkPairIndex likely) {
  if (one == kNone || other == kNone) {
    return kNone;
  }
  const auto wanted =
      std::make_tuple(idAt<LinkId>(std::min(one, other)), idAt<LinkId>(std::max(one, other)));
  const auto is_at = [&](auto place) {
    return place != pairs.end() && std::make_tuple(place->a, place->b) == wanted;
  };
  if (likely < pairs.size() && is_at(pairs.begin() + likely)) {
    return likely;
  }
  const auto place = std::lower_bound(pairs.begin(), pairs.end(), wanted,
                                      [](const CheckedLinkPair& pair, const auto& key) {
                                        return std::make_tuple(pair.a, pair.b) < key;
                                      });
  return is_at(place) ? static_cast<LinkPairIndex>(place - pairs.begin()) : kNone;
}

/// Where a link was in the last cycle, and how it moves.
struct LinkMotion {
  Pose world_from_link;
  bool is_known{false};
  PartId part{kWorldPart};
  Pose tracked;
  bool was_tracked{false};
  PartId tracked_part{kWorldPart};
  Twist twist;
  bool is_twist_known{false};
};

/// Parts are named by links: of a former link, the new one; kNone, which is kWorldPart, too, if
/// there is none.
PartId newPart(PartId former, const std::vector<std::uint32_t>& new_of) {
  return former == kWorldPart ? kWorldPart : new_of[former];
}

LinkMotion motionOf(std::uint32_t link, const FormerMotion& former,
                    const std::vector<std::uint32_t>& new_of) {
  LinkMotion motion;
  motion.world_from_link = former.poses.world_from_link[link];
  motion.part = newPart(former.poses.part[link], new_of);
  motion.is_known = former.last.stamp_ns > 0 && former.poses.status[link] == LinkStatus::known &&
                    (motion.part != kNone || former.poses.part[link] == kWorldPart);
  motion.tracked = former.tracker.world_from_link[link];
  motion.tracked_part = newPart(former.tracker.part[link], new_of);
  const bool has_part = motion.tracked_part != kNone || former.tracker.part[link] == kWorldPart;
  motion.was_tracked = has_part && former.tracker.was_known[link] != 0;
  motion.twist = former.tracker.filtered.of_link[link];
  motion.is_twist_known = has_part && former.tracker.filtered.known[link] != 0;
  return motion;
}

/// The motion of a frame that is new.
LinkMotion restingAt(const LinkPoses& poses, std::size_t link) {
  LinkMotion motion;
  motion.world_from_link = motion.tracked = poses.world_from_link[link];
  motion.is_known = motion.was_tracked = motion.is_twist_known =
      poses.status[link] == LinkStatus::known && poses.age[link] == 0.0 &&
      poses.part[link] == kWorldPart;
  return motion;
}

/// The motions of all links. Objects that stand together mostly have the carrier of the one before.
class LinkMotions {
 public:
  LinkMotions(const CarryPlan& plan, const RobotModel& model, const FormerMotion& former,
              const LinkPoses& poses)
      : plan_(plan),
        model_(model),
        former_(former),
        poses_(poses),
        new_of_(former.poses.status.size(), kNone) {
    for (std::size_t i = 0; i < plan.link_of.size(); ++i) {
      if (plan.link_of[i] != kNone) {
        new_of_[plan.link_of[i]] = static_cast<std::uint32_t>(i);
      }
    }
  }

  LinkMotion of(std::size_t link) {
    if (!isObject(model_, idAt<LinkId>(link))) {
      return plan_.link_of[link] == kNone ? restingAt(poses_, link)
                                          : motionOf(plan_.link_of[link], former_, new_of_);
    }
    const Joint& joint = model_.joint(*model_.links[link].parent_joint);
    if (carrier_ != joint.parent) {
      of_carrier_ = of(index(joint.parent));
      carrier_ = joint.parent;
    }
    LinkMotion motion = of_carrier_;
    motion.world_from_link = of_carrier_.world_from_link * joint.parent_from_joint;
    motion.tracked = of_carrier_.tracked * joint.parent_from_joint;
    return motion;
  }

 private:
  const CarryPlan& plan_;
  const RobotModel& model_;
  const FormerMotion& former_;
  const LinkPoses& poses_;
  std::vector<std::uint32_t> new_of_;  ///< by former link
  std::optional<LinkId> carrier_;
  LinkMotion of_carrier_;
};

/// Objects count as settled if they stood in the last cycle where the new set-up was prepared.
Rest restOf(std::size_t first_link, const LinkPoses& poses, const LastPoses& last,
            const VelocityTracker& tracker) {
  const bool rests = poses.status[first_link] == LinkStatus::known && last.known[first_link] != 0 &&
                     poses.part[first_link] == kWorldPart && last.part[first_link] == kWorldPart &&
                     isSame(poses.world_from_link[first_link], last.world_from_link[first_link]) &&
                     tracker.filtered.known[first_link] != 0 &&
                     isFaded(tracker.filtered.of_link[first_link]);
  return rests ? settledRest(tracker.filtered.of_link[first_link]) : Rest();
}

}  // namespace

CarryPlan planCarryOver(const CycleSetup& from, const CycleSetup& to) {
  CarryPlan plan;
  plan.link_of = planLinks(from.model, to.model);
  plan.robot_of = planRobots(from.model, to.model, plan.link_of);
  plan.pair_to.resize(from.checked.size(), kNone);
  plan.pair_of.reserve(to.checked.size());
  LinkPairIndex next = 0;
  for (const CheckedLinkPair& pair : to.checked) {
    const LinkPairIndex former =
        findPair(from.checked, plan.link_of[index(pair.a)], plan.link_of[index(pair.b)], next);
    if (former != kNone) {
      next = former + 1;
      plan.pair_to[former] = static_cast<LinkPairIndex>(plan.pair_of.size());
    }
    plan.pair_of.push_back(former);
  }
  return plan;
}

std::vector<LinkPairIndex> carryOver(const CarryPlan& plan, const PairMemory& reported,
                                     PairMemory& memory) {
  std::vector<LinkPairIndex> dropped;
  const auto carry = [&](LinkPairIndex former) {
    const LinkPairIndex pair = plan.pair_to[former];
    if (pair != kNone && isLively(reported, former)) {
      memory.reported[pair] = reported.reported[former];
      memory.contact_detail[pair] = reported.contact_detail[former];
      memory.speed.stopped[pair] = reported.speed.stopped[former];
      memory.lively.push_back(pair);
    } else if (pair == kNone && reported.reported[former] != Verdict::clear) {
      dropped.push_back(former);
    }
  };
  if (!reported.judges_all) {
    std::for_each(reported.lively.begin(), reported.lively.end(), carry);
  }
  for (LinkPairIndex i = 0; reported.judges_all && i < plan.pair_to.size(); ++i) {
    carry(i);
  }
  memory.speed.scale = reported.speed.scale;
  memory.speed.stamp_ns = reported.speed.stamp_ns;
  return dropped;
}

void carryMotion(const CarryPlan& plan, const CycleSetup& to, const FormerMotion& former,
                 const LinkPoses& poses, PairMemory& memory, VelocityTracker& tracker) {
  const RobotModel& model = to.model;
  LinkMotions motions(plan, model, former, poses);
  LastPoses& last = memory.last;
  bool has_changed = false;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const LinkMotion motion = motions.of(i);
    const unsigned char is_known = motion.is_known && hasShapes(model.links[i]) ? 1 : 0;
    has_changed |= is_known != last.known[i] || (is_known != 0 && motion.part != last.part[i]);
    last.world_from_link[i] = motion.world_from_link;
    last.known[i] = is_known;
    last.part[i] = motion.part;
    tracker.world_from_link[i] = motion.tracked;
    tracker.was_known[i] = motion.was_tracked ? 1 : 0;
    tracker.part[i] = motion.tracked_part;
    tracker.filtered.of_link[i] = motion.twist;
    tracker.filtered.known[i] = motion.is_twist_known ? 1 : 0;
  }
  for (std::size_t i = 0; i < to.carried.size(); ++i) {
    last.rests[i] = restOf(to.carried[i].first_link, poses, last, tracker);
  }
  last.stamp_ns = former.last.stamp_ns;
  for (std::size_t i = 0; i < model.robots.size(); ++i) {
    tracker.stamp_ns[i] = plan.robot_of[i] == kNone ? former.poses.stamp_ns
                                                    : former.tracker.stamp_ns[plan.robot_of[i]];
  }
  memory.judges_all = memory.judges_all || has_changed;
}

}  // namespace collision_monitor
