// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/markers/markers.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "collision_monitor/geometry/ids.h"
#include "model/object_links.h"
#include "ros_edge/markers/marker_shapes.h"
#include "ros_edge/outputs/conversions.h"
#include "ros_edge/outputs/sentences.h"

namespace collision_monitor {
namespace {

using visualization_msgs::Marker;

constexpr float kShapeAlpha = 0.45F;
constexpr double kLineWidth = 0.004;
constexpr double kPointSize = 0.015;
constexpr double kNormalLength = 0.08;
constexpr double kTextHeight = 0.035;
constexpr double kTextWidth = 8.0 * kTextHeight;  // of ">= 35 mm", with a margin

/// Format: docs/interfaces.md. A lower bound may be less than the distance, an estimate more.
std::string labelOf(const PairDistance& distance) {
  const char* relation = distance.quality == Quality::lower_bound ? ">= "
                         : distance.quality == Quality::estimate  ? "<= "
                                                                  : "";
  const double value = distance.measured.distance;
  return relation + std::string(value < 0.0 ? "-" : "") + lengthText(value);
}

bool hides(const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
  return std::abs(one.z() - other.z()) < kTextHeight && (one - other).head<2>().norm() < kTextWidth;
}

/// A readable place for a label: above any labels that it would overlap. Marks it as taken.
Eigen::Vector3d takePlace(const Eigen::Vector3d& wanted, std::vector<Eigen::Vector3d>& taken) {
  std::sort(taken.begin(), taken.end(),
            [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.z() < b.z(); });
  Eigen::Vector3d place = wanted;
  for (const Eigen::Vector3d& other : taken) {
    if (hides(place, other)) {
      place.z() = other.z() + 1.2 * kTextHeight;
    }
  }
  taken.push_back(place);
  return place;
}

}  // namespace

Markers::Markers(const Watch& watch) {
  const CycleSetup& setup = watch.setup();
  for (const Body& body : setup.bodies) {
    const bool is_object = isObject(setup.model, body.link);
    colours_.push_back(is_object ? std::optional<std_msgs::ColorRGBA>(
                                       colourOf(watch.fixed->world, setup.model.link(body.link)))
                                 : std::nullopt);
    unseen_.push_back(makeShapeMarker(shownShape(setup, body)));
    unseen_.back().ns = is_object ? "objects" : "shapes";
    unseen_.back().id = static_cast<int>(unseen_.size()) - 1;
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
      toMessage(shownPose(watch.setup(), body, poses.world_from_body[body]), shape.pose);
      shape.header = headerOf(watch, link);
    }
    const Verdict verdict = is_known ? verdicts[index(link)] : Verdict::unknown;
    const bool has_own = colours_[body] && verdict <= Verdict::warning;
    shape.color = has_own ? *colours_[body] : colourOf(verdict, kShapeAlpha);
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
      addContact(watch, distance);
    }
  }
  for (const PassedContact& passed : watch.buffers.distances.passed) {
    addContact(watch, passed.distance);
  }
}

void Markers::addContact(const Watch& watch, const PairDistance& distance) {
  const CycleSetup& setup = watch.setup();
  const std_msgs::Header header =
      headerOf(watch, setup.checked[setup.link_pair_of[index(distance.pair)]].a);
  const SignedDistance& measured = distance.measured;
  const Eigen::Vector3d middle = 0.5 * (measured.point_on_a + measured.point_on_b);
  const int id = 2 * static_cast<int>(index(distance.pair));
  Marker& point = add("contacts", id, Marker::SPHERE, header);
  toMessage(middle, point.pose.position);
  toMessage(Eigen::Vector3d::Constant(kPointSize), point.scale);
  point.color = colourOf(Verdict::contact, 1.0F);
  Marker& normal = add("contacts", id + 1, Marker::ARROW, header);
  normal.points.resize(2);
  toMessage(middle, normal.points[0]);
  toMessage(middle + kNormalLength * measured.normal_a_to_b, normal.points[1]);
  toMessage(Eigen::Vector3d(kLineWidth, 2.0 * kLineWidth, 0.0), normal.scale);
  normal.color = colourOf(Verdict::contact, 1.0F);
}

void Markers::addDistances(const Watch& watch) {
  const CycleSetup& setup = watch.setup();
  const PairEvents& events = watch.buffers.events;
  label_places_.clear();
  for (std::size_t i = 0; i < setup.checked.size(); ++i) {
    const std::uint32_t place = events.closest[i];
    if (place == kNone) {
      continue;
    }
    const PairDistance& distance = watch.buffers.distances.pairs[place];
    const SignedDistance& measured = distance.measured;
    if (place != events.closest_of_all && measured.distance > limitsOf(setup, i).report_distance) {
      continue;
    }
    const std_msgs::Header header = headerOf(watch, setup.checked[i].a);
    Marker& line = add("distances", static_cast<int>(i), Marker::LINE_LIST, header);
    line.points.resize(2);
    toMessage(measured.point_on_a, line.points[0]);
    toMessage(measured.point_on_b, line.points[1]);
    line.scale.x = kLineWidth;
    line.color = colourOf(events.verdicts[i], 1.0F);
    if (events.verdicts[i] == Verdict::clear && place != events.closest_of_all) {
      continue;
    }
    Marker& label = add("labels", static_cast<int>(i), Marker::TEXT_VIEW_FACING, header);
    toMessage(takePlace(0.5 * (measured.point_on_a + measured.point_on_b), label_places_),
              label.pose.position);
    label.scale.z = kTextHeight;
    label.color.r = label.color.g = label.color.b = label.color.a = 1.0F;
    label.text = labelOf(distance);
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
