// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <string>
#include <unordered_map>
#include <vector>

#include "model/object_links.h"
#include "pipeline/data/cycle_data.h"
#include "ros_edge/poses/joint_reader.h"
#include "ros_edge/poses/transform_store.h"

namespace collision_monitor {

struct PoseReaderOptions {
  std::string world_frame;  ///< frame of all poses; empty: the root link of the first robot
  double max_age{0.5};      ///< [s] older data, or data farther in the future, are stale
};

/// Reads the poses of all links from a transform store. Joint states may replace tf where joints
/// place links.
///
/// Looks each link up once, relative to its parent link, and composes the chain here. tf may have
/// other frames between the two. Reads all moving links of a robot at one stamp: the newest that
/// all of them have, among those whose data are no older than `max_age`. At a link's newest stamp
/// its pose comes from the store's records. Between two samples tf2 interpolates; if they are more
/// than `max_age` apart, the link is stale. Links below a loop of frames are `missing`.
///
/// With joint states, the model's kinematics places links below fixed joints and joints with one
/// variable, at the same stamp and by the same rules. tf places roots and links below planar and
/// floating joints. Links placed only by static transforms have age 0. Links without geometry in
/// them or below them stay `missing` and delay no other link.
///
/// A link that cannot be placed relative to its parent link, or a root in the world, begins a
/// floating part (LinkPoses). Links below it are placed in that part as they would be in the world.
///
/// Objects follow the frame or link that carries them.
///
/// Robots keep their own stamps. LinkPoses::stamp_ns is the oldest of them. It is the time of the
/// call if nothing moves, and stays unchanged if nothing that moves is known. Ages of `missing`
/// links are infinite.
class PoseReader {
 public:
  /// @param joints nullptr: everything from tf
  /// @pre `model`, `store` and `joints` outlive the reader.
  PoseReader(const RobotModel& model, const TransformStore& store, const PoseReaderOptions& options,
             JointReader* joints = nullptr);

  /// Updates `poses` (sized for the model). Looks nothing up if no message came since the last
  /// call. Does not throw: a failed look-up leaves the link unknown.
  /// @return true if a stamp, or the status or part of a link changed.
  bool read(const ros::Time& now, LinkPoses& poses);

  /// Why the place of the link's part was unknown at the last read: "no transform for 0.52 s".
  std::string explain(LinkId link) const;

 private:
  /// What places one link: the transform from its parent link, or from the world for a root.
  struct Edge {
    const Joint* joint{nullptr};  ///< the joint that places the link; nullptr: tf does
    std::string parent_frame;
    std::string child_frame;
    bool is_needed{false};     ///< the link or one below it has geometry
    bool is_connected{false};  ///< the joint or tf connects the two frames
    /// Records of the frames between them: from the child up, then from the parent up.
    std::vector<std::size_t> path;
    std::size_t up_count{0};               ///< number of these above the child
    std::vector<std::size_t> moving_path;  ///< those that are not static
    std::int64_t newest_ns{0};             ///< newest stamp available on the whole path
    std::int64_t read_ns{-1};              ///< stamp of parent_from_child; -1: not read
    Pose parent_from_child;
    LinkStatus status{LinkStatus::missing};
    double age{0.0};
  };

  /// A frame whose parents form a loop.
  struct LoopFrame {
    std::size_t record;
    bool was_stale;  ///< when edges were connected
  };

  static bool isMoving(const Edge& edge);
  std::int64_t newestOf(const Edge& edge) const;
  bool isBad(const Edge& edge) const;
  bool isContradicted(const Edge& edge) const;
  void makeEdges();
  void refresh();
  void connectAll();
  void connect(Edge& edge) const;
  std::string parentOf(const std::string& frame) const;
  std::vector<std::string> chainUpTo(const std::string& last, const std::string& frame) const;
  std::vector<std::string> chainAbove(const std::string& frame) const;
  std::vector<std::string> loopAbove(const std::string& frame) const;
  void noteLoop(const std::string& frame);
  bool isStale(std::size_t frame) const;
  bool haveLoopsChanged() const;
  void judge(std::int64_t now_ns, Edge& edge) const;
  std::int64_t commonStamp(const Robot& robot) const;
  bool isAllKnown() const;
  bool readRobot(const Robot& robot, std::int64_t stamp_ns);
  void look(std::int64_t stamp_ns, Edge& edge) const;
  void lookUpTransform(std::int64_t stamp_ns, Edge& edge) const;
  bool compose(std::int64_t stamp_ns, Edge& edge) const;
  bool askBuffer(std::int64_t stamp_ns, bool is_newest, Edge& edge) const;
  bool hasGapAt(const Edge& edge, std::int64_t stamp_ns) const;
  bool placeLinks(LinkPoses& poses) const;
  void placeLink(std::size_t link, LinkPoses& poses) const;
  std::string explainJoint(const Edge& edge) const;
  std::string explainMissing(const Edge& edge) const;
  std::string explainContradiction(const Edge& edge) const;
  Refusal refusedAhead(const Edge& edge) const;
  double since(std::int64_t then_ns) const;
  bool isOfNow(std::int64_t then_ns) const;
  std::string explainBefore(const Refusal& refusal) const;
  std::string refused(const Refusals& refusals, const char* what, const char* reason) const;

  const RobotModel& model_;
  const TransformStore& store_;
  std::string world_frame_;
  double max_age_;
  std::int64_t now_ns_{0};  ///< of the last read
  JointReader* joints_;
  JointPositions positions_;  ///< of all joints at the current stamp
  std::vector<ObjectRun> objects_;
  std::vector<Edge> edges_;  ///< by LinkId
  std::vector<FrameRecord> records_;
  std::unordered_map<std::string, std::size_t> places_;  ///< indices of records, by frame
  std::vector<LoopFrame> loop_frames_;
  TransformStore::Version seen_;
  bool has_records_{false};
};

}  // namespace collision_monitor
