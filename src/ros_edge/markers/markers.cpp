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

Markers::Markers(const MonitorSetup& setup) {
  for (ShownShape& shape : showShapes(setup)) {
    unseen_.push_back(std::move(shape.marker));
    link_from_marker_.push_back(shape.link_from_marker);
    colours_.push_back(shape.own_colour);
  }
}

/// For a floating part, rviz must use tf's newest transform: tf may have none for the stamp of the
/// data.
std_msgs::Header Markers::headerOf(const Snapshot& snapshot, LinkId link) const {
  const PartId part = snapshot.links[index(link)].part;
  return part == kWorldPart ? header_ : makeHeader(0, frameOf(*snapshot.fixed, part));
}

const visualization_msgs::MarkerArray& Markers::draw(const Snapshot& snapshot) {
  header_ = makeHeader(snapshot.stamp_ns, snapshot.fixed->world_frame);
  drawn_.clear();
  keepShapes();
  addShapes(snapshot);
  placeShapes(snapshot);
  for (const Snapshot::Contact& contact : snapshot.contacts) {
    addContact(snapshot, contact);
  }
  addDistances(snapshot);
  addLabels(snapshot);
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
void Markers::addShapes(const Snapshot& snapshot) {
  const std::vector<Body>& bodies = snapshot.fixed->setup.bodies;
  const auto first_seen =
      std::stable_partition(unseen_.begin(), unseen_.end(), [&](const Marker& shape) {
        return !snapshot.links[index(bodies[static_cast<std::size_t>(shape.id)].link)].is_known;
      });
  std::move(first_seen, unseen_.end(), std::back_inserter(array_.markers));
  unseen_.erase(first_seen, unseen_.end());
  shapes_ = array_.markers.size();
}

void Markers::placeShapes(const Snapshot& snapshot) {
  for (Marker& shape : array_.markers) {
    const auto body = static_cast<std::size_t>(shape.id);
    const LinkId link = snapshot.fixed->setup.bodies[body].link;
    const Snapshot::Link& place = snapshot.links[index(link)];
    if (place.is_known) {
      toMessage(place.world_from_link * link_from_marker_[body], shape.pose);
      shape.header = headerOf(snapshot, link);
    }
    const Verdict verdict = place.is_known ? place.worst : Verdict::unknown;
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

void Markers::addContact(const Snapshot& snapshot, const Snapshot::Contact& contact) {
  const CycleSetup& setup = snapshot.fixed->setup;
  const std_msgs::Header header =
      headerOf(snapshot, setup.checked[setup.link_pair_of[index(contact.pair)]].a);
  Marker dots;
  toMessage(Eigen::Vector3d::Constant(kPointSize), dots.scale);
  dots.color = colourOf(Verdict::contact, 1.0F);
  for (std::size_t i = 0; i < contact.points.size; ++i) {
    const Eigen::Vector3d& point = contact.points.points[i];
    dots.points.emplace_back();
    toMessage(point, dots.points.back());
    Marker& normal = add("contacts", idOfContact(contact.pair, 1 + i), Marker::ARROW, header);
    normal.points.resize(2);
    toMessage(point, normal.points[0]);
    const Eigen::Vector3d end = point + kNormalLength * contact.normal_a_to_b;
    toMessage(end, normal.points[1]);
    toMessage(Eigen::Vector3d(kNormalWidth, 3.0 * kNormalWidth, 5.0 * kNormalWidth), normal.scale);
    normal.color = white();
  }
  Marker& added = add("contacts", idOfContact(contact.pair, 0), Marker::SPHERE_LIST, header);
  added.points = std::move(dots.points);
  added.scale = dots.scale;
  added.color = dots.color;
}

/// Around all bodies of a part, in its frame.
const std::vector<Aabb>& Markers::boxesOf(const Snapshot& snapshot, PartId part) {
  if (boxes_.empty() || boxes_part_ != part) {
    boxes_.clear();
    boxes_part_ = part;
    for (const Body& body : snapshot.fixed->setup.bodies) {
      const Snapshot::Link& link = snapshot.links[index(body.link)];
      if (link.is_known && link.part == part) {
        boxes_.push_back(aabbOf(body.shape, link.world_from_link * body.link_from_body, 0.0));
      }
    }
  }
  return boxes_;
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

void Markers::addDistances(const Snapshot& snapshot) {
  for (const Snapshot::Line& shown : snapshot.lines) {
    const LinkId link = snapshot.fixed->setup.checked[shown.link_pair].a;
    Marker& line = addLine("distances", shown.link_pair, shown.point_on_a, shown.point_on_b,
                           headerOf(snapshot, link));
    line.scale.x = kLineWidth;
    line.color = colourOf(shown.verdict, 1.0F);
  }
}

void Markers::addLabels(const Snapshot& snapshot) {
  label_places_.clear();
  boxes_.clear();
  for (const Snapshot::Label& shown : snapshot.labels) {
    const CycleSetup& setup = snapshot.fixed->setup;
    const std_msgs::Header header = headerOf(snapshot, setup.checked[shown.link_pair].a);
    const std::string text = labelText(setup, shown);
    const PartId part = snapshot.links[index(setup.checked[shown.link_pair].a)].part;
    const Eigen::Vector3d place = label_places_.take(shown.middle + Eigen::Vector3d(0, 0, kLift),
                                                     text, boxesOf(snapshot, part));
    Marker& label =
        add("labels", static_cast<int>(shown.link_pair), Marker::TEXT_VIEW_FACING, header);
    toMessage(place, label.pose.position);
    label.scale.z = kTextHeight;
    label.color = white();
    label.text = text;
    const Eigen::Vector3d foot = place - Eigen::Vector3d(0, 0, 1.5 * kTextHeight);  // of two lines
    Marker& line = addLine("leaders", shown.link_pair, shown.middle, foot, header);
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
