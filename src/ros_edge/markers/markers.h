// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ros_edge/markers/labels.h"
#include "ros_edge/markers/snapshot.h"

namespace collision_monitor {

/// The picture of a cycle for rviz. It is in the world frame with the stamp of the data. A floating
/// part is in the frame of its top link, without a stamp.
///
/// Namespaces: `shapes` (id = body; in the colour of the worst verdict of their link, those of
/// unknown links at the last known pose), `objects` (ids as in `shapes`; in their own colours,
/// unless they are in contact or unknown), `contacts` (ids 5 n for the points of body pair n, and
/// 5 n + 1 to 5 n + 4 for the normals at them; for the same pairs as the topic `contacts`),
/// `distances` (id = link pair), `labels` (same ids; of chooseLabelled) and `leaders` (same ids:
/// lines from pairs to their labels). A marker that no longer applies is deleted.
/// Shapes are triangulated once, at set-up.
class Markers {
 public:
  /// The first array deletes markers of an earlier set-up.
  explicit Markers(const MonitorSetup& setup);

  /// The array to publish now; valid until the next call.
  /// @pre the snapshot is of the same set-up
  const visualization_msgs::MarkerArray& draw(const Snapshot& snapshot);

 private:
  using Key = std::pair<std::string, int>;

  void keepShapes();
  void addShapes(const Snapshot& snapshot);
  void placeShapes(const Snapshot& snapshot);
  void addContact(const Snapshot& snapshot, const Snapshot::Contact& contact);
  void addDistances(const Snapshot& snapshot);
  void addLabels(const Snapshot& snapshot);
  void addDeletions();
  visualization_msgs::Marker& add(const char* name_space, int id, int type,
                                  const std_msgs::Header& header);
  visualization_msgs::Marker& addLine(const char* name_space, LinkPairIndex link_pair,
                                      const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                      const std_msgs::Header& header);
  const std::vector<Aabb>& boxesOf(const Snapshot& snapshot, PartId part);
  std_msgs::Header headerOf(const Snapshot& snapshot, LinkId link) const;

  std::vector<Pose> link_from_marker_;                       ///< by BodyId
  std::vector<std::optional<std_msgs::ColorRGBA>> colours_;  ///< by BodyId: of objects
  std::vector<visualization_msgs::Marker> unseen_;  ///< shapes not seen yet, in the body frame
  /// Shapes that were seen come first and stay: they are most of the bytes.
  visualization_msgs::MarkerArray array_;
  std::size_t shapes_{0};  ///< number of shapes among the array's markers
  std_msgs::Header header_;
  LabelPlaces label_places_;  ///< in this array
  std::vector<Aabb> boxes_;   ///< of boxesOf, for boxes_part_; empty: not made yet
  PartId boxes_part_{kWorldPart};
  std::set<Key> shown_;
  std::set<Key> drawn_;
  bool is_first_{true};
};

}  // namespace collision_monitor
