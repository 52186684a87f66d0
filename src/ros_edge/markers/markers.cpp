// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/markers/markers.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "ros_edge/markers/marker_shapes.h"
#include "ros_edge/outputs/conversions.h"

namespace collision_monitor {
namespace {

using visualization_msgs::Marker;

constexpr float kShapeAlpha = 0.45F;   // links: the robot shows through
constexpr float kObjectAlpha = 0.75F;  // objects that touch or are unknown
constexpr double kLineWidth = 0.004;
constexpr double kPointSize = 0.015;
constexpr double kNormalLength = 0.08;
constexpr double kNormalWidth = 0.006;
constexpr double kLift = 0.12;  // [m] of labels above their pair: points and normals stay visible

/// Numbers of a contact: its points, and the normal at each of them.
constexpr std::size_t kIdsPerContact = 1 + ContactManifold::kMaxPoints;

int idOfContact(PairId pair, std::size_t i) {
  return static_cast<int>(kIdsPerContact * index(pair) + i);
}

std_msgs::ColorRGBA white() {
  std_msgs::ColorRGBA colour;
  colour.r = colour.g = colour.b = colour.a = 1.0F;
  return colour;
}

}  // namespace

Markers::Markers(const Watch& watch) {
  for (ShownShape& shape : showShapes(*watch.fixed)) {
    unseen_.push_back(std::move(shape.marker));
    link_from_marker_.push_back(shape.link_from_marker);
    colours_.push_back(shape.own_colour);
  }
}

/// For a floating part, rviz must use tf's newest transform: tf may have none for the stamp of the
/// data.
std_msgs::Header Markers::headerOf(const Watch& watch, LinkId link) const {
  return watch.poses.part[index(link)] == kWorldPart
             ? header_
             : makeHeader(0, frameOf(*watch.fixed, watch.poses, link));
}

const visualization_msgs::MarkerArray& Markers::draw(const Watch& watch) {
  header_ = makeHeader(watch.poses.stamp_ns, watch.fixed->world_frame);
  drawn_.clear();
  keepShapes();
  addShapes(watch.buffers.body_poses);
  placeShapes(watch);
  addContacts(watch);
  addDistances(watch);
  addLabels(watch);
  addDeletions();
  if (is_first_) {
    Marker others;
    others.header = header_;
    others.action = Marker::DELETEALL;
    array_.markers.insert(array_.markers.begin(), others);
    is_first_ = false;
  }
  return array_;
}

void Markers::keepShapes() {
  auto& markers = array_.markers;
  if (!markers.empty() && markers.front().action == Marker::DELETEALL) {
    markers.erase(markers.begin());
  }
  markers.resize(shapes_);
}

/// A link that was never seen has no place.
void Markers::addShapes(const BodyPoses& poses) {
  const auto first_seen = std::stable_partition(
      unseen_.begin(), unseen_.end(),
      [&](const Marker& shape) { return poses.known[static_cast<std::size_t>(shape.id)] == 0; });
  std::move(first_seen, unseen_.end(), std::back_inserter(array_.markers));
  unseen_.erase(first_seen, unseen_.end());
  shapes_ = array_.markers.size();
}

void Markers::placeShapes(const Watch& watch) {
  std::vector<Verdict> verdicts;
  findWorstVerdicts(watch.setup(), watch.buffers.events, verdicts);
  const BodyPoses& poses = watch.buffers.body_poses;
  for (Marker& shape : array_.markers) {
    const auto body = static_cast<std::size_t>(shape.id);
    const bool is_known = poses.known[body] != 0;
    const LinkId link = watch.setup().bodies[body].link;
    if (is_known) {
      toMessage(watch.poses.world_from_link[index(link)] * link_from_marker_[body], shape.pose);
      shape.header = headerOf(watch, link);
    }
    const Verdict verdict = is_known ? verdicts[index(link)] : Verdict::unknown;
    const bool has_own = colours_[body] && verdict <= Verdict::warning;
    shape.color =
        has_own ? *colours_[body] : colourOf(verdict, colours_[body] ? kObjectAlpha : kShapeAlpha);
    shape.header.stamp = shape.header.frame_id == header_.frame_id ? header_.stamp : ros::Time();
  }
}

Marker& Markers::add(const char* name_space, int id, int type, const std_msgs::Header& header) {
  drawn_.emplace(name_space, id);
  array_.markers.emplace_back();
  Marker& marker = array_.markers.back();
  marker.header = header;
  marker.ns = name_space;
  marker.id = id;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  return marker;
}

void Markers::addContacts(const Watch& watch) {
  for (const PairDistance& distance : watch.buffers.distances.pairs) {
    if (isInContact(watch, distance)) {
      addContact(watch, distance, contactPointsOf(watch, distance));
    }
  }
  for (const PassedContact& passed : watch.buffers.distances.passed) {
    addContact(watch, passed.distance, onePointOf(passed.distance.measured));
  }
}

void Markers::addContact(const Watch& watch, const PairDistance& distance,
                         const ContactPoints& points) {
  const CycleSetup& setup = watch.setup();
  const std_msgs::Header header =
      headerOf(watch, setup.checked[setup.link_pair_of[index(distance.pair)]].a);
  Marker dots;
  toMessage(Eigen::Vector3d::Constant(kPointSize), dots.scale);
  dots.color = colourOf(Verdict::contact, 1.0F);
  for (std::size_t i = 0; i < points.size; ++i) {
    const Eigen::Vector3d& point = points.points[i];
    dots.points.emplace_back();
    toMessage(point, dots.points.back());
    Marker& normal = add("contacts", idOfContact(distance.pair, 1 + i), Marker::ARROW, header);
    normal.points.resize(2);
    toMessage(point, normal.points[0]);
    const Eigen::Vector3d end = point + kNormalLength * distance.measured.normal_a_to_b;
    toMessage(end, normal.points[1]);
    toMessage(Eigen::Vector3d(kNormalWidth, 3.0 * kNormalWidth, 5.0 * kNormalWidth), normal.scale);
    normal.color = white();
  }
  Marker& added = add("contacts", idOfContact(distance.pair, 0), Marker::SPHERE_LIST, header);
  added.points = std::move(dots.points);
  added.scale = dots.scale;
  added.color = dots.color;
}

Marker& Markers::addLine(const char* name_space, LinkPairIndex link_pair,
                         const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                         const std_msgs::Header& header) {
  Marker& line = add(name_space, static_cast<int>(link_pair), Marker::LINE_LIST, header);
  line.points.resize(2);
  toMessage(from, line.points[0]);
  toMessage(to, line.points[1]);
  return line;
}

void Markers::addDistances(const Watch& watch) {
  const CycleSetup& setup = watch.setup();
  const PairEvents& events = watch.buffers.events;
  for (const LinkPairIndex i : events.active) {
    const std::uint32_t place = events.closest[i];
    if (place == kNone) {
      continue;
    }
    const SignedDistance& measured = watch.buffers.distances.pairs[place].measured;
    if (place != events.closest_of_all && measured.distance > limitsOf(setup, i).report_distance) {
      continue;
    }
    Marker& line = addLine("distances", i, measured.point_on_a, measured.point_on_b,
                           headerOf(watch, setup.checked[i].a));
    line.scale.x = kLineWidth;
    line.color = colourOf(events.verdicts[i], 1.0F);
  }
}

void Markers::addLabels(const Watch& watch) {
  label_places_.clear();
  for (const LinkPairIndex i : chooseLabelled(watch, watch.fixed->parameters.marker_labels)) {
    const std_msgs::Header header = headerOf(watch, watch.setup().checked[i].a);
    const SignedDistance& measured =
        watch.buffers.distances.pairs[watch.buffers.events.closest[i]].measured;
    const Eigen::Vector3d middle = 0.5 * (measured.point_on_a + measured.point_on_b);
    const std::string text = labelText(watch, i);
    const Eigen::Vector3d place = label_places_.take(middle + Eigen::Vector3d(0, 0, kLift), text);
    Marker& label = add("labels", static_cast<int>(i), Marker::TEXT_VIEW_FACING, header);
    toMessage(place, label.pose.position);
    label.scale.z = kTextHeight;
    label.color = white();
    label.text = text;
    Marker& line = addLine("leaders", i, middle, place, header);
    line.scale.x = 0.25 * kLineWidth;
    line.color = white();
  }
}

void Markers::addDeletions() {
  for (const auto& [name_space, id] : shown_) {
    if (drawn_.count({name_space, id}) == 0) {
      array_.markers.emplace_back();
      array_.markers.back().header = header_;
      array_.markers.back().ns = name_space;
      array_.markers.back().id = id;
      array_.markers.back().action = Marker::DELETE;
    }
  }
  shown_ = drawn_;
}

}  // namespace collision_monitor
