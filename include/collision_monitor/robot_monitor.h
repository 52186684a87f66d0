// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "collision_monitor/arguments.h"
#include "collision_monitor/geometry/interrupted.h"
#include "collision_monitor/model/document_text.h"
#include "collision_monitor/model/kinematics.h"
#include "collision_monitor/model/world.h"
#include "collision_monitor/pipeline/setup.h"

/// The library for those who have joint values and no tf. A RobotMonitor is made once; a RobotQuery
/// (robot_query.h) answers for joint values.
namespace collision_monitor {

struct MonitorParts;
struct QueryParts;

/// What a monitor is made with. The defaults do for most robots. Of a document with a source and no
/// text, the source is the path of a file, which is read while the monitor is made.
struct MonitorOptions {
  Limits limits;  ///< times, hysteresis and report_distance play no part: a query knows no past
  RefineGeometry detail{RefineGeometry::mesh};  ///< what is measured, where rules say nothing
  double distance_tolerance{0.0};               ///< [m] as RefineLimits::tolerance
  double padding{0.0};                          ///< [m] >= 0; added to every shape
  FitLimits fit{4, 0.01, {}};                   ///< of links for which the rules say nothing
  DocumentText shape_rules;                     ///< for single links; wins over the options here
  DocumentText pair_rules;  ///< for pairs, of objects too; wins over SRDFs and ignored_pairs
  DocumentText world;       ///< objects beside the robots, or attached to links; see withWorld
  std::vector<NamedPair> ignored_pairs;  ///< in addition to what SRDFs say
  bool ignore_default_overlap{true};     ///< as SetupOptions
  /// Where package://NAME/ is looked up, each a package or a folder of packages. What
  /// ROS_PACKAGE_PATH and AMENT_PREFIX_PATH name follows.
  std::vector<std::filesystem::path> package_roots;
  ResourceLoader load_resource;  ///< replaces the look-up above; may be empty
  MeshReading meshes;            ///< how mesh files are read
  /// Folder that keeps fits. "": that of the program `fit`, below $ROS_HOME or ~/.ros; "none": fits
  /// are not kept.
  std::string fit_cache;
  FitProgress fit_progress;  ///< may be empty
  /// Asked again and again while the monitor is made, on any thread, but never on two at once.
  /// False ends the work with Interrupted. It must not throw. May be empty.
  GoesOn goes_on;
  /// By robot: where its root link stands. Empty: all in the world's origin.
  std::vector<Pose> world_from_root;
};

/// One robot in files.
struct RobotFiles {
  std::filesystem::path urdf;    ///< path of the file
  std::filesystem::path srdf{};  ///< empty if there is none
  std::string prefix{};          ///< as RobotDescription::tf_prefix
};

/// One number of a state: the position of a joint, or a part of it.
struct JointVariable {
  std::string name;          ///< of the joint; planar and floating joints have an ending: "base/x"
  JointId joint{};           ///< in model()
  double lower{0.0};         ///< [rad] or [m]; -infinity if unlimited
  double upper{0.0};         ///< likewise
  double max_velocity{0.0};  ///< [rad/s] or [m/s]; infinity if unlimited
};

/// A shape that encloses a part of a link.
struct EnclosingShape {
  LinkId link{};         ///< to which it is fixed
  std::string name;      ///< unique within its link
  Shape shape;           ///< with the padding
  Pose link_from_shape;  ///< where the shape stands in the link
  Overshoot overshoot;   ///< [m] without the padding; NaN for given shapes: not measured
  bool is_exact{false};  ///< the shape is the geometry of the URDF
  bool is_proven{true};  ///< false: given shapes that their link may stick out of
};

/// Robots, their shapes and the pairs to be checked. Never changes, so threads may share it. Copies
/// are cheap and share what is inside, and so does each RobotQuery: it may outlive its monitor.
class RobotMonitor {
 public:
  /// Reads the robots, encloses their links in shapes and decides which pairs are checked.
  /// @throws SetupError with all faults of descriptions, meshes, rules and options
  /// @throws Interrupted if MonitorOptions::goes_on returned false
  explicit RobotMonitor(const std::vector<RobotDescription>& robots,
                        const MonitorOptions& options = {});
  /// The same for robots in files. A file that cannot be read is one more fault.
  static RobotMonitor fromFiles(const std::vector<RobotFiles>& robots,
                                const MonitorOptions& options = {});

  /// The same robots with these objects in place of those that they have, as for another scene.
  /// Robots are not read and fitted anew, and the rules for pairs are applied to the new objects.
  /// An object without frame stands in the world, as one in the frame "world" does if no link has
  /// that name. Others stand in the frame of a link, or are attached to a link. Each object is a
  /// link of its own in answers, and so is the world: "/world".
  /// @param world as MonitorOptions::world
  /// @throws SetupError with all faults of the objects
  RobotMonitor withWorld(const DocumentText& world) const;

  /// Robots, links and joints. RobotModel::variable_count is the length n of a state.
  const RobotModel& model() const noexcept;
  const std::vector<JointVariable>& variables() const noexcept;  ///< n, in the order of a state
  /// The state that defaultPositions gives: zeros as far as limits allow.
  const JointPositions& defaultState() const noexcept;
  /// A state with the named joints at these positions and all others as in the default state. A
  /// mimic joint follows its source and cannot be set.
  /// @throws ArgumentError that names every fault: sizes that differ, names that are unknown or
  /// stand twice, joints with no or several variables
  JointPositions stateOf(const std::vector<std::string>& joints, Numbers positions) const;

  /// The pairs of links that are checked. Answers name pairs by their index in here.
  const std::vector<CheckedLinkPair>& pairs() const noexcept;
  /// All pairs of links that have shapes, each with the reason why it is checked or not.
  const std::vector<LinkPair>& allPairs() const noexcept;
  const std::vector<EnclosingShape>& shapes() const noexcept;  ///< in order of link
  const std::vector<Problem>& warnings() const noexcept;       ///< of the set-up
  /// The distances that decide verdicts, as in the options.
  const Limits& limits() const noexcept;

 private:
  friend struct QueryParts;
  explicit RobotMonitor(std::shared_ptr<const MonitorParts> parts);

  std::shared_ptr<const MonitorParts> parts_;
};

}  // namespace collision_monitor
