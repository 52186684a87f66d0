// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/look_ahead/object_ranges.h"

#include <algorithm>
#include <cmath>

#include "geometry/constants.h"
#include "model/object_links.h"

namespace collision_monitor {
namespace {

std::uint32_t slotOf(const std::vector<LinkId>& links, LinkId link) {
  return static_cast<std::uint32_t>(std::lower_bound(links.begin(), links.end(), link) -
                                    links.begin());
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

double largerOf(const BodyRows& rows, const ObjectRange& range, std::size_t column) noexcept {
  return std::max(rows.at(column)[range.link], rows.at(column)[range.objects]);
}

double reachByMotion(const ActivationDistances& reaches, const ObjectRange& range,
                     double speed) noexcept {
  const double stop = reaches.of_limits[range.limits].stop;
  const double asked = stop + speed * largerOf(reaches.rows, range, link_column::time);
  const double came = reaches.of_limits[range.limits].contact +
                      reaches.rows.at(link_column::travel)[range.link] +
                      reaches.rows.at(link_column::travel)[range.objects];
  return std::max(std::isnan(asked) ? stop : asked, came);
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

std::vector<LinkId> firstCarried(const RobotModel& model) {
  std::vector<LinkId> first;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    first.push_back(idAt<LinkId>(i));
  }
  for (const ObjectRun& run : objectRuns(model)) {
    for (std::size_t i = run.first; i < run.last; ++i) {
      first[i] = idAt<LinkId>(run.first);
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
    if (!isObject(model, body.link)) {
      continue;
    }
    const LinkId first = first_of[index(body.link)];
    const std::uint32_t slot = slotOf(reaches.links, first);
    if (slot < reaches.links.size() && reaches.links[slot] == first) {
      const Pose first_from_body = poseBeside(model, first, body.link) * body.link_from_body;
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
  const LinkId first_of_world = firstOfWorld(model);
  const std::vector<LinkId> first_of = firstCarried(model);
  reaches.place_of.resize(setup.checked.size());
  for (LinkPairIndex i = 0; i < setup.checked.size(); ++i) {
    const CheckedLinkPair& pair = setup.checked[i];
    if (!isInRange(first_of_world, pair)) {
      reaches.place_of[i] = i;
      continue;
    }
    const LinkId objects = first_of[index(pair.b)];
    const bool goes_on = !reaches.ranges.empty() && reaches.ranges.back().last == i &&
                         reaches.links[reaches.ranges.back().link] == pair.a &&
                         reaches.links[reaches.ranges.back().objects] == objects &&
                         reaches.ranges.back().limits == pair.limits;
    if (!goes_on) {
      reaches.ranges.push_back({i, i, slotOf(reaches.links, pair.a), slotOf(reaches.links, objects),
                                kInfinity, pair.limits});
    }
    ObjectRange& range = reaches.ranges.back();
    range.last = i + 1;
    range.thickness = std::min(range.thickness, reaches.thickness[i]);
    reaches.place_of[i] =
        static_cast<std::uint32_t>(setup.checked.size() + reaches.ranges.size() - 1);
  }
  growBalls(setup, first_of, reaches);
}

void walkObjectRanges(const WalkQuestion& question, const LinkPoses& poses,
                      ActivationDistances& reaches, Farthest& farthest) noexcept {
  for (const ObjectRange& range : reaches.ranges) {
    const std::uint32_t place = reaches.place_of[range.first];
    reaches.speed[place] =
        travelOf(reaches.rows, range, link_column::velocity, link_column::center);
    reaches.motion[place] = reachByMotion(reaches, range, reaches.speed[place]);
    reaches.told[place] = std::min(reaches.of_limits[range.limits].all,
                                   largerOf(reaches.rows, range, link_column::distance));
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
