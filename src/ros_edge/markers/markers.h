// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ros_edge/watch.h"

namespace collision_monitor {

/// The picture of a cycle for rviz, in the world frame and with the stamp of the data; of a part
/// that floats in the frame of its top link, without a stamp.
///
/// Namespaces: `shapes` (id = body; green clear, yellow warning, red contact, grey
/// unknown where the link was last seen), `contacts` (ids 2 n and 2 n + 1 = point and normal of
/// pair n of bodies, for the same pairs as the topic `contacts`), `distances` (id = pair of links)
/// and `labels` (the same; of pairs that are not clear and of the closest; ">= " stands before a
/// lower bound, "<= " before an estimate). A marker whose reason is gone is deleted. Shapes are
/// triangulated once, at set-up.
class Markers {
 public:
  /// The first array deletes what another set-up may have left.
  explicit Markers(const Watch& watch);

  /// The array to publish now; stays valid until the next call.
  const visualization_msgs::MarkerArray& draw(const Watch& watch);

 private:
  using Key = std::pair<std::string, int>;

  void keepShapes();
  void addShapes(const BodyPoses& poses);
  void placeShapes(const Watch& watch);
  void addContacts(const Watch& watch);
  void addContact(const Watch& watch, const PairDistance& distance);
  void addDistances(const Watch& watch);
  void addDeletions();
  visualization_msgs::Marker& add(const char* name_space, int id, int type,
                                  const std_msgs::Header& header);
  std_msgs::Header headerOf(const Watch& watch, LinkId link) const;

  std::vector<visualization_msgs::Marker> unseen_;  ///< shapes in the body frame
  /// Shapes that were seen come first and stay: they are most of its bytes.
  visualization_msgs::MarkerArray array_;
  std::size_t shapes_{0};  ///< of the array's markers
  std_msgs::Header header_;
  std::vector<Eigen::Vector3d> label_places_;  ///< of this array, in the world
  std::set<Key> shown_;
  std::set<Key> drawn_;
  bool is_first_{true};
};

}  // namespace collision_monitor
