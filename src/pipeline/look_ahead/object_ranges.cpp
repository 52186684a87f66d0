// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/look_ahead/object_ranges.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/constants.h"
#include "model/object_links.h"

namespace collision_monitor {
namespace {

std::uint32_t slotOf(const std::vector<LinkId>& links, LinkId link) {
  return static_cast<std::uint32_t>(std::lower_bound(links.begin(), links.end(), link) -
                                    links.begin());
}

const Joint& jointOf(const RobotModel& model, LinkId object) {
  return model.joint(*model.link(object).parent_joint);
}

Eigen::Vector3d vectorAt(const BodyRows& rows, std::size_t c, std::size_t slot) noexcept {
  return {rows.at(c)[slot], rows.at(c + 1)[slot], rows.at(c + 2)[slot]};
}

/// [m] or [m/s] How far the ball of the link moves relative to the objects.
/// @param c first column of a twist, @param center of the ball
double travelOf(const BodyRows& rows, const ObjectRange& range, std::size_t c,
                std::size_t center) noexcept {
  const Eigen::Vector3d linear = vectorAt(rows, c, range.link) - vectorAt(rows, c, range.objects);
  const Eigen::Vector3d angular =
      vectorAt(rows, c + 3, range.link) - vectorAt(rows, c + 3, range.objects);
  return (linear + angular.cross(vectorAt(rows, center, range.link))).norm() +
         angular.norm() * rows.at(link_column::radius)[range.link];
}

double reachByMotion(const WalkQuestion& question, const ActivationDistances& reaches,
                     const ObjectRange& range) noexcept {
  const double speed = travelOf(reaches.rows, range, link_column::velocity, link_column::center);
  const double asked = reaches.of_limits[range.limits].stop + speed * question.horizon;
  const double came = reaches.of_limits[range.limits].contact +
                      reaches.rows.at(link_column::travel)[range.link] +
                      reaches.rows.at(link_column::travel)[range.objects];
  return asked <= std::numeric_limits<double>::max() ? std::max(asked, came) : kInfinity;
}

void findFarther(const ActivationDistances& reaches, const ObjectRange& range, std::size_t twist,
                 FarthestPair& farthest) noexcept {
  const double share =
      travelOf(reaches.rows, range, twist, link_column::last_center) / range.thickness;
  if (share > farthest.share) {
    farthest = {share, range.first};
  }
}

}  // namespace

bool isInRange(const RobotModel& model, const CheckedLinkPair& pair) {
  return isOfWorld(model, pair.b) && !isOfWorld(model, pair.a);
}

std::vector<LinkId> firstCarried(const RobotModel& model) {
  std::vector<LinkId> first(model.links.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    const LinkId link = idAt<LinkId>(i);
    first[i] = link;
    if (i > 0 && isObject(model, link) && isObject(model, idAt<LinkId>(i - 1)) &&
        jointOf(model, link).parent == jointOf(model, idAt<LinkId>(i - 1)).parent) {
      first[i] = first[i - 1];
    }
  }
  return first;
}

namespace {

/// Makes the ball of each range's first object hold all objects of its carrier.
void growBalls(const CycleSetup& setup, const std::vector<LinkId>& first_of,
               ActivationDistances& reaches) {
  const RobotModel& model = setup.model;
  for (const Body& body : setup.bodies) {
    if (!isOfWorld(model, body.link)) {
      continue;
    }
    const LinkId first = first_of[index(body.link)];
    const std::uint32_t slot = slotOf(reaches.links, first);
    if (slot < reaches.links.size() && reaches.links[slot] == first) {
      const Pose first_from_body = inverse(jointOf(model, first).parent_from_joint) *
                                   jointOf(model, body.link).parent_from_joint *
                                   body.link_from_body;
      Ball& ball = reaches.balls[slot];
      ball.radius = std::max(
          ball.radius, (first_from_body.translation - ball.center).norm() + body.bounding_radius);
      reaches.rows.at(link_column::radius)[slot] = ball.radius;
    }
  }
}

}  // namespace

void makeObjectRanges(const CycleSetup& setup, ActivationDistances& reaches) {
  const RobotModel& model = setup.model;
  const std::vector<LinkId> first_of = firstCarried(model);
  for (LinkPairIndex i = 0; i < setup.checked.size(); ++i) {
    const CheckedLinkPair& pair = setup.checked[i];
    if (!isInRange(model, pair)) {
      continue;
    }
    const std::uint32_t link = slotOf(reaches.links, pair.a);
    const std::uint32_t objects = slotOf(reaches.links, first_of[index(pair.b)]);
    const bool goes_on = !reaches.ranges.empty() && reaches.ranges.back().last == i &&
                         reaches.ranges.back().link == link &&
                         reaches.ranges.back().objects == objects &&
                         reaches.ranges.back().limits == pair.limits;
    if (!goes_on) {
      reaches.ranges.push_back({i, i, link, objects, kInfinity, pair.limits});
    }
    ObjectRange& range = reaches.ranges.back();
    range.last = i + 1;
    range.thickness = std::min(range.thickness, reaches.thickness[i]);
  }
  growBalls(setup, first_of, reaches);
}

void walkObjectRanges(const WalkQuestion& question, const LinkPoses& poses,
                      ActivationDistances& reaches, Farthest& farthest) noexcept {
  for (const ObjectRange& range : reaches.ranges) {
    const double reach = reachByMotion(question, reaches, range);
    const PairReach& at_rest = reaches.of_limits[range.limits];
    std::fill(reaches.of_pair.begin() + range.first, reaches.of_pair.begin() + range.last,
              std::max(at_rest.all, reach));
    std::fill(reaches.near_of_pair.begin() + range.first, reaches.near_of_pair.begin() + range.last,
              std::max(at_rest.near, reach));
    const bool is_joined = poses.part[index(reaches.links[range.link])] ==
                           poses.part[index(reaches.links[range.objects])];
    if (question.has_step && is_joined) {
      findFarther(reaches, range, link_column::moved, farthest.moved);
      if (question.has_bends) {
        findFarther(reaches, range, link_column::bent, farthest.bent);
      }
    }
  }
}

}  // namespace collision_monitor
