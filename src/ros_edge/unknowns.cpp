// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/unknowns.h"

#include <algorithm>
#include <iterator>

#include "collision_monitor/geometry/ids.h"
#include "model/object_links.h"

namespace collision_monitor {

void Unknowns::find(const CycleSetup& setup, const LinkPoses& poses, const CycleBuffers& buffers) {
  const PairEvents& events = buffers.events;
  if (isUpToDate(poses, events)) {
    return;
  }
  judgements_ = events.complete_judgements;
  status_ = poses.status;
  part_ = poses.part;
  links_.clear();
  parts_.clear();
  lone_links_.clear();
  robots_ = robotCount(setup.model);
  between_.assign((robots_ + 1) * (robots_ + 1), UnknownPairs());
  main_.emplace(poses, setup.checked);
  if (events.unknown > 0) {
    addPairs(setup, events, buffers.memory.reported, buffers.robots);
    addParts(setup, poses);
  }
}

/// Which pairs are unknown changes where all are judged, or where a distance is not a number.
bool Unknowns::isUpToDate(const LinkPoses& poses, const PairEvents& events) const {
  return main_ && judgements_ == events.complete_judgements && events.unknown == events.unjoined &&
         status_ == poses.status && part_ == poses.part;
}

void Unknowns::addPairs(const CycleSetup& setup, const PairEvents& events,
                        const std::vector<Verdict>& reported, const RobotSpeeds& robots) {
  std::vector<bool> is_unknown(setup.model.links.size());
  const auto robot_of = [&](LinkId link) { return std::size_t{robots.robot_of_link[index(link)]}; };
  for (LinkPairIndex i = 0; i < setup.checked.size(); ++i) {
    if (events.verdicts[i] == Verdict::unknown) {
      const CheckedLinkPair& pair = setup.checked[i];
      is_unknown[index(pair.a)] = is_unknown[index(pair.b)] = true;
      UnknownPairs& of_robots = between_[robot_of(pair.a) * (robots_ + 1) + robot_of(pair.b)];
      of_robots.first = std::min(of_robots.first, i);
      if (reported[i] == Verdict::unknown) {
        of_robots.first_lost = std::min(of_robots.first_lost, i);
      }
      ++of_robots.count;
    }
  }
  for (std::size_t i = 0; i < is_unknown.size(); ++i) {
    if (is_unknown[i] && !main_->has(idAt<LinkId>(i))) {
      links_.push_back(idAt<LinkId>(i));
    }
  }
}

void Unknowns::addParts(const CycleSetup& setup, const LinkPoses& poses) {
  parts_ = findFloatingParts(poses, setup.checked);
  const auto has_none = [](const FloatingPart& part) { return part.own_pairs == 0; };
  parts_.erase(std::remove_if(parts_.begin(), parts_.end(), has_none), parts_.end());
  std::copy_if(links_.begin(), links_.end(), std::back_inserter(lone_links_), [&](LinkId link) {
    return std::none_of(parts_.begin(), parts_.end(), [&](const FloatingPart& part) {
      return poses.part[index(link)] == static_cast<PartId>(index(part.top));
    });
  });
}

LinkId Unknowns::unknownOf(const CheckedLinkPair& pair) const {
  return main_->has(pair.a) ? pair.b : pair.a;
}

}  // namespace collision_monitor
