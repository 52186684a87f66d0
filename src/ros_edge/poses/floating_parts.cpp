// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/poses/floating_parts.h"

#include <algorithm>
#include <iterator>

#include "model/object_links.h"

namespace collision_monitor {
namespace {

bool isKnown(const LinkPoses& poses, LinkId link) {
  return poses.status[index(link)] == LinkStatus::known;
}

LinkId topOf(const LinkPoses& poses, LinkId link) {
  const PartId part = poses.part[index(link)];
  return isKnown(poses, link) && part != kWorldPart ? idAt<LinkId>(part) : link;
}

}  // namespace

MainPart::MainPart(const LinkPoses& poses, const std::vector<CheckedLinkPair>& pairs)
    : poses_(poses) {
  for (const CheckedLinkPair& pair : pairs) {
    for (const LinkId link : {pair.a, pair.b}) {
      if (isKnown(poses, link) && poses.part[index(link)] == kWorldPart) {
        part_ = kWorldPart;
        return;
      }
    }
    consider(pair);
  }
}

/// @pre no link is known in the world
void MainPart::consider(const CheckedLinkPair& pair) {
  if (poses_.robot_stamp_ns.size() > 1) {
    if (!part_ && isJoined(poses_, pair.a, pair.b)) {
      part_ = poses_.part[index(pair.a)];
    }
    return;
  }
  for (const LinkId link : {pair.a, pair.b}) {
    if (isKnown(poses_, link) && (!topmost_ || link < *topmost_)) {
      topmost_ = link;
      part_ = poses_.part[index(link)];
    }
  }
}

bool MainPart::has(LinkId link) const {
  return isKnown(poses_, link) && poses_.part[index(link)] == part_;
}

std::vector<FloatingPart> findFloatingParts(const LinkPoses& poses,
                                            const std::vector<CheckedLinkPair>& pairs) {
  const MainPart main(poses, pairs);
  std::vector<FloatingPart> of_top(poses.status.size());
  const auto part_of = [&](LinkId link) -> FloatingPart& {
    const LinkId top = topOf(poses, link);
    FloatingPart& part = of_top[index(top)];
    const bool is_new = part.own_pairs + part.other_pairs == 0;
    part.top = top;
    part.first = is_new ? link : std::min(part.first, link);
    return part;
  };
  for (const CheckedLinkPair& pair : pairs) {
    const bool is_joined = isJoined(poses, pair.a, pair.b);
    if (is_joined && !main.has(pair.a)) {
      ++part_of(pair.a).own_pairs;
    }
    for (const LinkId link : {pair.a, pair.b}) {
      if (!is_joined && !main.has(link)) {
        ++part_of(link).other_pairs;
      }
    }
  }
  std::vector<FloatingPart> parts;
  std::copy_if(of_top.begin(), of_top.end(), std::back_inserter(parts),
               [](const FloatingPart& part) { return part.other_pairs > 0; });
  return parts;
}

std::string unknownText(const RobotModel& model, LinkId link, const std::string& reason) {
  const char* kind = isOfWorld(model, link) ? "" : "link ";
  return kind + nameInText(model, link) + " is unknown: " + reason;
}

std::string floatingText(const RobotModel& model, const FloatingPart& part,
                         const std::string& reason) {
  if (part.own_pairs == 0) {
    return unknownText(model, part.first, reason);
  }
  const Link& top = model.link(part.top);
  const Robot& robot = model.robots[index(top.robot)];
  // Identical robots differ only in their prefixes.
  return "the part of robot '" + (robot.tf_prefix.empty() ? robot.name : robot.tf_prefix) +
         "' from link '" + top.name + "' on floats: " + reason;
}

std::string floatingPartsText(const RobotModel& model, const LinkPoses& poses,
                              const std::vector<CheckedLinkPair>& pairs,
                              const std::vector<std::string>& reasons) {
  const std::vector<FloatingPart> parts = findFloatingParts(poses, pairs);
  if (parts.empty()) {
    return "";
  }
  const std::size_t top = index(parts.front().top);
  const bool is_told = top < reasons.size() && !reasons[top].empty();
  const std::size_t more = parts.size() - 1;
  return floatingText(model, parts.front(),
                      is_told ? reasons[top] : "it is not known where it stands") +
         (more == 0 ? "" : " (and " + std::to_string(more) + " more)");
}

}  // namespace collision_monitor
