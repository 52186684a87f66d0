// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "read_numbers.h"

#include <algorithm>
#include <cstdio>
#include <optional>

#include "model/nearest_name.h"
#include "model/number_text.h"
#include "model/place.h"

namespace collision_monitor::explain_tool {
namespace {

/// "NAME=VALUE"
struct Assignment {
  std::string name;
  std::optional<double> value;  ///< none: no number stands there
};

Assignment split(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  Eigen::VectorXd value(1);
  const bool is_number = sign != std::string::npos && !parseNumbers(text.substr(sign + 1), value);
  return {text.substr(0, sign), is_number ? std::optional<double>(value[0]) : std::nullopt};
}

/// Tells of positions that the joint does not reach.
void warnOfLimits(const Joint& joint, double position) {
  if (position < joint.lower || position > joint.upper) {
    std::fprintf(stderr, "warning: joint '%s' does not reach %s, but %s to %s\n",
                 joint.name.c_str(), shortText(position).c_str(), shortText(joint.lower).c_str(),
                 shortText(joint.upper).c_str());
  }
}

bool isOne(const Joint& joint) {
  return !joint.mimic &&
         (joint.type == JointType::revolute || joint.type == JointType::continuous ||
          joint.type == JointType::prismatic);
}

}  // namespace

Limits readLimits(const std::vector<std::string>& texts, SetupReport& report) {
  std::vector<std::string> names;
  names.reserve(kLimitFields.size());
  for (const LimitField& field : kLimitFields) {
    names.emplace_back(field.name);
  }
  Limits limits;
  for (const std::string& text : texts) {
    const Assignment read = split(text);
    const auto* const field =
        std::find_if(kLimitFields.begin(), kLimitFields.end(),
                     [&](const LimitField& one) { return one.name == read.name; });
    if (field == kLimitFields.end()) {
      report.errors.push_back({"option --limit", quoted(text) + suggestion(read.name, names),
                               "NAME=VALUE, with a name of " + joined(names)});
    } else if (!read.value || *read.value < field->least || *read.value > field->greatest) {
      report.errors.push_back({"option --limit", quoted(text),
                               "a number from " + shortText(field->least) + " to " +
                                   shortText(field->greatest) + field->unit});
    } else {
      limits.*field->value = *read.value;
    }
  }
  return limits;
}

void readJoints(const RobotModel& model, const std::vector<std::string>& texts,
                JointPositions& positions, SetupReport& report) {
  std::vector<std::string> names;
  for (const Joint& joint : model.joints) {
    if (isOne(joint)) {
      names.push_back(joint.name);
    }
  }
  for (const std::string& text : texts) {
    const Assignment read = split(text);
    const std::optional<JointId> joint = model.findJoint(read.name);
    if (!joint || !isOne(model.joint(*joint)) || !read.value) {
      report.errors.push_back({"option --joint",
                               quoted(text) + (joint ? "" : suggestion(read.name, names)),
                               "NAME=POSITION of a joint that turns or slides and mimics no "
                               "other"});
      continue;
    }
    positions[model.joint(*joint).first_variable] = *read.value;
    warnOfLimits(model.joint(*joint), *read.value);
  }
}

}  // namespace collision_monitor::explain_tool
