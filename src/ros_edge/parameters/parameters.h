// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/model/problems.h"
#include "collision_monitor/model/robot_model.h"
#include "pipeline/cycle/cycle_buffers.h"
#include "ros_edge/parameters/resource_loader.h"

namespace collision_monitor {

/// Source of one robot's description: a parameter or a file.
struct RobotSource {
  std::string name;           ///< its name in errors
  std::string description;    ///< parameter that holds the URDF
  std::string semantic;       ///< parameter that holds the SRDF, "" for none
  std::string file;           ///< URDF file or package:// URI; replaces `description`
  std::string semantic_file;  ///< SRDF file or package:// URI; replaces `semantic`
  std::string tf_prefix;      ///< as in RobotDescription
  std::string joint_states;   ///< topic of its joint states; "": that for all robots
  bool may_be_absent{true};   ///< as in ListedRobot
};

/// A robot as the user lists it, whether it is there or not.
struct ListedRobot {
  std::string name;           ///< as in the parameter `robots`; of a single robot, as in its URDF
  std::optional<RobotId> id;  ///< none: its URDF has not come yet
  std::string missing;        ///< what is missing then: "no URDF in parameter /right/urdf"
  /// Other robots may go on while nothing of it is known: State says which.
  bool may_be_absent{false};
  bool has_come{false};  ///< its URDF is there, but cannot be taken in: the robot is not absent
};

enum class Trigger : unsigned char {
  timer,  ///< `rate` times a second
  pose,   ///< at each new complete stamp of a robot, at most 1.01 `rate` times a second
};

enum class PoseSource : unsigned char {
  tf,            ///< all links
  joint_states,  ///< links below fixed joints and joints with one variable; tf places others
};

/// The private parameters of the node; config/monitor.yaml explains them.
struct Parameters {
  std::vector<RobotSource> robots;  ///< empty: one robot, from robot_description
  std::string mesh_directory;       ///< base of relative mesh names, for URDFs that are not files
  LoadRules loading;  ///< of robots, meshes and rules; `setup` has the limits of reading meshes
  bool obey_up_axis{false};   ///< as RobotDescription::obeys_up_axis
  bool is_strict{false};      ///< as in RobotDescription
  std::string world_frame;    ///< empty: the root link of the first robot
  double rate{100.0};         ///< [Hz]
  int real_time_priority{2};  ///< of the cycle's thread, 0: none
  Trigger trigger{Trigger::timer};
  PoseSource pose_source{PoseSource::tf};
  double max_age{0.5};                       ///< [s]
  double clock_timeout{1.0};                 ///< [s] of wall time
  std::string joint_states{"joint_states"};  ///< topic; "": none
  double velocity_filter{0.02};              ///< [s] as VelocityOptions::time_constant
  double heartbeat_rate{2.0};                ///< [Hz]
  double marker_rate{30.0};                  ///< [Hz]
  std::size_t marker_labels{6};              ///< most labels in the markers
  SetupOptions setup;       ///< its texts and folders are filled in when the set-up is built
  std::string shape_rules;  ///< file or package:// URI, "" for none
  std::string pair_rules;   ///< the same; "" if `setup` has the rules themselves, or for none
  std::string fit_cache;    ///< folder; "": the default; "none": none
  BroadPhaseKind broad_phase{BroadPhaseKind::automatic};
  std::string world;                 ///< objects in YAML, "" for none
  std::string world_file;            ///< file or package:// URI with objects, "" for none
  double disable_timeout{60.0};      ///< [s]
  double wait_for_description{5.0};  ///< [s]
};

/// Reads the parameters from the struct that the parameter server has for a namespace. Unknown
/// names, and values of a wrong type or out of range, are all added to `report`; faulty values keep
/// their defaults. `where` is the namespace, for messages.
Parameters readParameters(const XmlRpc::XmlRpcValue& values, const std::string& where,
                          SetupReport& report);

}  // namespace collision_monitor
