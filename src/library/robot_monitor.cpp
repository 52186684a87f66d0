// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/robot_monitor.h"

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "library/monitor_parts.h"
#include "model/few_texts.h"
#include "model/mesh_files/regular_file.h"
#include "model/nearest_name.h"
#include "model/place.h"

namespace collision_monitor {
namespace {

/// Nothing, with one fault for the robot, if a file cannot be read.
std::optional<RobotDescription> describe(const RobotFiles& files, SetupReport& report) {
  RobotDescription description;
  description.source = files.urdf.string();
  description.tf_prefix = files.prefix;
  std::error_code ignored;
  description.directory = std::filesystem::absolute(files.urdf, ignored).parent_path().string();
  const char* what = "URDF";
  try {
    description.urdf_xml = readRegularFile(files.urdf);
    what = "SRDF";
    description.srdf_source = files.srdf.string();
    description.srdf_xml = files.srdf.empty() ? "" : readRegularFile(files.srdf);
  } catch (const std::runtime_error& fault) {
    report.errors.push_back({what, fault.what(), "a file that can be read"});
    return std::nullopt;
  }
  return description;
}

std::vector<std::string> variableNames(const MonitorParts& parts) {
  std::vector<std::string> names;
  for (const JointVariable& variable : parts.variables) {
    names.push_back(variable.name);
  }
  return names;
}

/// Why a state has no such joint.
std::string noVariable(const MonitorParts& parts, const std::string& name) {
  const auto id = parts.setup.model.findJoint(name);
  if (!id) {
    const std::vector<std::string> names = variableNames(parts);
    const std::string similar = suggestion(name, names);
    return "there is no joint " + quoted(name) +
           (similar.empty() ? "; accepted: " + someOf(names) : similar);
  }
  const Joint& joint = parts.setup.model.joint(*id);
  return "joint '" + name +
         (joint.mimic
              ? "' follows '" + parts.setup.model.joint(joint.mimic->source).name + "'; name that"
          : joint.type == JointType::fixed ? "' is fixed; leave it out"
                                           : "' has several variables; name one as '" +
                                                 variableNames(parts)[joint.first_variable] + "'");
}

}  // namespace

RobotMonitor::RobotMonitor(std::shared_ptr<const MonitorParts> parts) : parts_(std::move(parts)) {}

RobotMonitor::RobotMonitor(const std::vector<RobotDescription>& robots,
                           const MonitorOptions& options)
    : parts_(makeMonitorParts({robots, {}}, options)) {}

RobotMonitor RobotMonitor::fromFiles(const std::vector<RobotFiles>& robots,
                                     const MonitorOptions& options) {
  GivenRobots given;
  for (const RobotFiles& files : robots) {
    if (auto description = describe(files, given.report)) {
      given.descriptions.push_back(std::move(*description));
    }
  }
  return RobotMonitor(makeMonitorParts(given, options));
}

RobotMonitor RobotMonitor::withWorld(const DocumentText& world) const {
  return RobotMonitor(replaceWorld(*parts_, world));
}

const RobotModel& RobotMonitor::model() const noexcept { return parts_->setup.model; }

const std::vector<JointVariable>& RobotMonitor::variables() const noexcept {
  return parts_->variables;
}

const JointPositions& RobotMonitor::defaultState() const noexcept { return parts_->default_state; }

JointPositions RobotMonitor::stateOf(const std::vector<std::string>& joints,
                                     Numbers positions) const {
  if (joints.size() != positions.size()) {
    throw ArgumentError({counted(joints.size(), "joint") + " and " +
                         counted(positions.size(), "position") +
                         "; give one position for each joint"});
  }
  const std::vector<std::string> names = variableNames(*parts_);
  JointPositions state = parts_->default_state;
  std::set<std::string> seen;
  FewTexts faults;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto place = std::find(names.begin(), names.end(), joints[i]);
    if (place == names.end()) {
      faults.add([&] { return noVariable(*parts_, joints[i]); });
    } else if (!seen.insert(joints[i]).second) {
      faults.add([&] { return "joint " + quoted(joints[i]) + " stands twice; give it once"; });
    } else {
      state[static_cast<std::size_t>(place - names.begin())] = positions[i];
    }
  }
  if (std::vector<std::string> texts = faults.all(); !texts.empty()) {
    throw ArgumentError(std::move(texts));
  }
  return state;
}

const std::vector<CheckedLinkPair>& RobotMonitor::pairs() const noexcept {
  return parts_->setup.checked;
}

const std::vector<LinkPair>& RobotMonitor::allPairs() const noexcept {
  return parts_->setup.link_pairs;
}

const std::vector<EnclosingShape>& RobotMonitor::shapes() const noexcept { return parts_->shapes; }

const std::vector<Problem>& RobotMonitor::warnings() const noexcept {
  return parts_->setup.report.warnings;
}

const Limits& RobotMonitor::limits() const noexcept { return parts_->setup.limits; }

}  // namespace collision_monitor
