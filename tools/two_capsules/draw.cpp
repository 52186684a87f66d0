// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "draw.h"

#include <algorithm>

#include "ros_edge/markers/marker_shapes.h"
#include "ros_edge/outputs/conversions.h"

namespace collision_monitor::two_capsules {
namespace {

using Eigen::Vector3d;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr double kBoardSize = 2.0;
constexpr double kBoardThickness = 0.002;
constexpr double kPointSize = 0.02;
constexpr double kLineWidth = 0.008;
constexpr double kTextHeight = 0.08;
/// For overlapping capsules, so that their inside is visible.
constexpr float kOverlapAlpha = 0.35F;

std_msgs::ColorRGBA colour(float red, float green, float blue, float alpha = 1.0F) {
  std_msgs::ColorRGBA made;
  made.r = red;
  made.g = green;
  made.b = blue;
  made.a = alpha;
  return made;
}

/// Gives the marker the next id of its namespace.
void add(Marker marker, const char* name_space, MarkerArray& array) {
  const auto is_of_space = [&](const Marker& other) { return other.ns == name_space; };
  marker.header = array.markers.front().header;
  marker.ns = name_space;
  marker.id =
      static_cast<int>(std::count_if(array.markers.begin(), array.markers.end(), is_of_space));
  array.markers.push_back(std::move(marker));
}

Marker makePoints(int type, const Points& points, const std_msgs::ColorRGBA& its_colour) {
  Marker marker;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  marker.color = its_colour;
  toMessage(Vector3d::Constant(type == Marker::LINE_LIST ? kLineWidth : kPointSize), marker.scale);
  for (const Vector3d& point : points) {
    toMessage(point, marker.points.emplace_back());
  }
  return marker;
}

Marker makeText(const std::string& text, const Vector3d& place) {
  Marker marker;
  marker.type = Marker::TEXT_VIEW_FACING;
  marker.pose.orientation.w = 1.0;
  toMessage(place, marker.pose.position);
  marker.scale.z = kTextHeight;
  marker.color = colour(1.0F, 1.0F, 1.0F);
  marker.text = text;
  return marker;
}

Marker makeShape(const PosedShape& placed, const std_msgs::ColorRGBA& its_colour) {
  Marker marker = makeShapeMarker(placed.shape);
  toMessage(placed.geometry_from_body, marker.pose);
  marker.color = its_colour;
  return marker;
}

/// rviz draws transparent triangles in any order, near ones under far ones. With a color per
/// triangle it omits the lighting, and the order is not visible.
Marker makeCapsule(const PosedShape& placed, std_msgs::ColorRGBA its_colour, bool is_glass) {
  its_colour.a = is_glass ? kOverlapAlpha : 1.0F;
  Marker marker = makeShape(placed, its_colour);
  if (is_glass) {
    marker.colors.assign(marker.points.size(), its_colour);
  }
  return marker;
}

PosedShape board() {
  return {Box{0.5 * Vector3d(kBoardSize, kBoardSize, kBoardThickness)},
          {Eigen::Matrix3d::Identity(), {0.0, 0.0, -0.5 * kBoardThickness}}};
}

/// Adds a line in the verdict's color, and its length above both capsules.
void addDistance(const SignedDistance& found, const std::vector<PosedShape>& capsules,
                 MarkerArray& array) {
  const Points ends{found.point_on_a, found.point_on_b};
  const auto its_colour =
      colourOf(found.distance > 0.0 ? Verdict::warning : Verdict::contact, 1.0F);
  add(makePoints(Marker::LINE_LIST, ends, its_colour), "distance", array);
  add(makePoints(Marker::SPHERE_LIST, ends, its_colour), "distance", array);
  const double height = std::max(radiusOf(capsules[0].shape), radiusOf(capsules[1].shape));
  const Vector3d middle = 0.5 * (found.point_on_a + found.point_on_b);
  add(makeText(distanceText(found.distance), middle + (height + kTextHeight) * Vector3d::UnitZ()),
      "label", array);
}

}  // namespace

MarkerArray draw(const Exercise& exercise, const std::string& frame) {
  MarkerArray array;
  array.markers.emplace_back().header.frame_id = frame;
  array.markers.back().action = Marker::DELETEALL;

  add(makeShape(board(), colour(0.5F, 0.55F, 0.6F, 0.6F)), "board", array);
  add(makeText(promptOf(exercise), {0.0, 0.5 * kBoardSize + 2.0 * kTextHeight, kTextHeight}),
      "prompt", array);
  if (!exercise.clicks.empty()) {
    add(makePoints(Marker::SPHERE_LIST, exercise.clicks, colour(1.0F, 1.0F, 1.0F)), "clicks",
        array);
  }
  const std::vector<PosedShape> capsules = capsulesOf(exercise);
  const std::optional<SignedDistance> found = distanceOf(exercise);
  const bool is_glass = found && found->distance < 0.0;
  for (std::size_t i = 0; i < capsules.size(); ++i) {
    add(makeCapsule(capsules[i], i == 0 ? colour(0.25F, 0.55F, 1.0F) : colour(0.3F, 0.8F, 0.4F),
                    is_glass),
        "capsules", array);
  }
  if (found) {
    addDistance(*found, capsules, array);
  }
  return array;
}

}  // namespace collision_monitor::two_capsules
