// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/outputs/conversions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "collision_monitor/geometry/ids.h"
#include "pipeline/data/activation_distance.h"
#include "ros_edge/outputs/sentences.h"

namespace collision_monitor {
namespace {

static_assert(LinkDistance::EXACT == static_cast<int>(Quality::exact) &&
              LinkDistance::LOWER_BOUND == static_cast<int>(Quality::lower_bound) &&
              LinkDistance::UNKNOWN == static_cast<int>(Quality::unknown) &&
              LinkDistance::ESTIMATE == static_cast<int>(Quality::estimate));

void nameLinks(const CycleSetup& setup, LinkId a, LinkId b, LinkDistance& message) {
  message.link_a = setup.model.link(a).name;
  message.link_b = setup.model.link(b).name;
  message.shape_a.clear();
  message.shape_b.clear();
  message.frame_id.clear();
}

/// Does not fill the gradient row.
void fillNumbers(const SignedDistance& measured, LinkDistance& message) {
  message.closing_speed = kUnknown;
  message.time_to_contact = kUnknown;
  message.distance = measured.distance;
  toMessage(measured.point_on_a, message.point_on_a);
  toMessage(measured.point_on_b, message.point_on_b);
  toMessage(measured.normal_a_to_b, message.normal);
}

SignedDistance unknownDistance(double distance) {
  const Eigen::Vector3d nowhere = Eigen::Vector3d::Constant(kUnknown);
  return {distance, nowhere, nowhere, nowhere};
}

}  // namespace

const PassedContact* passedOf(const Watch& watch, LinkPairIndex link_pair) {
  const PairEvents& events = watch.buffers.events;
  const PairDistances& distances = watch.buffers.distances;
  if (events.passed[link_pair] == kNone) {
    return nullptr;
  }
  const std::uint32_t closest = events.closest[link_pair];
  const Limits& limits = limitsOf(watch.setup(), link_pair);
  // With several shapes, one may have passed while another touches.
  const bool touches =
      events.estimated[link_pair] != kNone ||
      (closest != kNone && isTouching(distances.pairs[closest], limits.contact_distance));
  return touches ? nullptr : &distances.passed[events.passed[link_pair]];
}

double passedAt(const Watch& watch, LinkPairIndex link_pair) {
  const PassedContact* passed = passedOf(watch, link_pair);
  return passed == nullptr ? kUnknown : passed->time * watch.buffers.sweep.elapsed;
}

const std::string& shapeName(const CycleSetup& setup, const PairDistance& distance, BodyId body) {
  return distance.is_refined ? setup.elements[index(setup.bodies[index(body)].element)].name
                             : setup.labels[index(body)].shape_name;
}

std_msgs::Header makeHeader(std::int64_t stamp_ns, const std::string& frame) {
  std_msgs::Header header;
  header.stamp.fromNSec(static_cast<std::uint64_t>(std::max<std::int64_t>(0, stamp_ns)));
  header.frame_id = frame;
  return header;
}

void toMessage(const Eigen::Vector3d& point, geometry_msgs::Point& message) {
  message.x = point.x();
  message.y = point.y();
  message.z = point.z();
}

void toMessage(const Eigen::Vector3d& vector, geometry_msgs::Vector3& message) {
  message.x = vector.x();
  message.y = vector.y();
  message.z = vector.z();
}

void toMessage(const Pose& pose, geometry_msgs::Pose& message) {
  toMessage(pose.translation, message.position);
  const Eigen::Quaterniond rotation(pose.rotation);
  message.orientation.x = rotation.x();
  message.orientation.y = rotation.y();
  message.orientation.z = rotation.z();
  message.orientation.w = rotation.w();
}

void nameBodies(const CycleSetup& setup, const PairDistance& distance, LinkDistance& message) {
  const BodyPair& pair = setup.table[distance.pair];
  message.link_a = setup.model.link(setup.bodies[index(pair.a)].link).name;
  message.link_b = setup.model.link(setup.bodies[index(pair.b)].link).name;
  message.shape_a = shapeName(setup, distance, pair.a);
  message.shape_b = shapeName(setup, distance, pair.b);
}

void fillNumbers(const PairDistance& distance, LinkDistance& message) {
  message.quality = static_cast<std::uint8_t>(distance.quality);
  fillNumbers(distance.measured, message);
  message.closing_speed = distance.closing_speed;
  message.time_to_contact = distance.time_to_contact;
  message.passed_at = kUnknown;
}

void nameJoints(const CycleSetup& setup, const GradientRow& row, LinkDistance& message) {
  message.gradient_joints.resize(row.size());
  for (std::size_t i = 0; i < row.size(); ++i) {
    message.gradient_joints[i] = setup.velocity_names[row[i].variable];
  }
}

void fillNumbers(const GradientRow& row, LinkDistance& message) {
  message.gradient_values.resize(row.size());
  for (std::size_t i = 0; i < row.size(); ++i) {
    message.gradient_values[i] = row[i].value;
  }
}

std::string frameOf(const MonitorSetup& setup, const LinkPoses& poses, LinkId link) {
  return frameOf(setup, poses.part[index(link)]);
}

std::string frameOf(const MonitorSetup& setup, PartId part) {
  return part == kWorldPart ? setup.world_frame
                            : stripLeadingSlash(setup.setup.model.links[part].frame);
}

void toMessage(const MonitorSetup& setup, const LinkPoses& poses, const PairDistance& distance,
               LinkDistance& message) {
  const CycleSetup& cycle = setup.setup;
  nameBodies(cycle, distance, message);
  fillNumbers(distance, message);
  const BodyPair& pair = cycle.table[distance.pair];
  message.frame_id = frameOf(setup, poses, cycle.bodies[index(pair.a)].link);
}

void toMessage(const CycleSetup& setup, const GradientRow& row, LinkDistance& message) {
  nameJoints(setup, row, message);
  fillNumbers(row, message);
}

void toUnknownMessage(LinkDistance& message) {
  message = LinkDistance();
  message.quality = LinkDistance::UNKNOWN;
  fillNumbers(unknownDistance(kUnknown), message);
  message.passed_at = kUnknown;
}

void toUnknownMessage(const CycleSetup& setup, LinkId a, LinkId b, LinkDistance& message) {
  toUnknownMessage(message);
  nameLinks(setup, a, b, message);
}

void toMessage(const Watch& watch, LinkPairIndex link_pair, LinkDistance& message) {
  const CycleSetup& setup = watch.setup();
  const CheckedLinkPair& pair = setup.checked[link_pair];
  const PairEvents& events = watch.buffers.events;
  if (events.verdicts[link_pair] == Verdict::unknown) {
    toUnknownMessage(setup, pair.a, pair.b, message);
  } else if (speakerOf(setup, watch.buffers, link_pair) == kNone) {
    nameLinks(setup, pair.a, pair.b, message);
    message.quality = LinkDistance::LOWER_BOUND;
    fillNumbers(unknownDistance(activationDistanceOf(limitsOf(setup, link_pair))), message);
  } else {
    const std::uint32_t speaker = speakerOf(setup, watch.buffers, link_pair);
    toMessage(*watch.fixed, watch.poses, watch.buffers.distances.pairs[speaker], message);
  }
  message.passed_at = passedAt(watch, link_pair);
}

}  // namespace collision_monitor
