// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/robots/rules_text.h"

#include "support/robots/urdf_text.h"

namespace collision_monitor::test {
namespace {

const char* const kSrdf =
    "<robot name='r'><group name='tip'><link name='hand'/><link name='tool'/></group>"
    "<group name='void'/></robot>";

RobotDescription describeArm(const std::string& prefix) {
  const std::string ball = "<sphere radius='0.1'/>";
  RobotDescription description = describeText(robotXml(
      linkXml("base", ball) + linkXml("arm_1", ball) + linkXml("arm_2", ball) +
      linkXml("hand", ball) + "<link name='tool'/>" +
      jointXml("j1", "continuous", "base", "arm_1") +
      jointXml("j2", "continuous", "arm_1", "arm_2") +
      jointXml("j3", "continuous", "arm_2", "hand") + jointXml("j4", "fixed", "hand", "tool")));
  description.srdf_xml = kSrdf;
  description.tf_prefix = prefix;
  return description;
}

/// One robot per prefix.
std::vector<SrdfPairs> readArms(const std::vector<std::string>& prefixes, RobotModel& model) {
  std::vector<RobotDescription> robots;
  for (const std::string& prefix : prefixes) {
    robots.push_back(describeArm(prefix));
  }
  SetupReport ignored;
  model = readRobots(robots, textLoader({}), ignored);
  std::vector<SrdfPairs> srdfs;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    srdfs.push_back(readSrdf(robots[i], idAt<RobotId>(i), model, ignored));
  }
  return srdfs;
}

std::vector<std::string> textsOf(const std::vector<Problem>& problems) {
  std::vector<std::string> texts;
  for (const Problem& problem : problems) {
    texts.push_back(toString(problem));
  }
  return texts;
}

}  // namespace

const LinkRules& ReadRules::of(const std::string& link) const {
  return rules.at(index(model.findLink(link).value()));
}

std::vector<std::string> ReadRules::withMaximum() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (rules[i].max_shapes) {
      names.push_back(model.links[i].name);
    }
  }
  return names;
}

ReadRules readRules(const std::string& yaml, const std::vector<std::string>& prefixes) {
  ReadRules read;
  const std::vector<SrdfPairs> srdfs = readArms(prefixes, read.model);
  SetupReport report;
  read.rules = readShapeRules({"rules.yaml", yaml}, read.model, srdfs, report);
  read.errors = textsOf(report.errors);
  read.warnings = textsOf(report.warnings);
  return read;
}

std::vector<std::string> ReadPairRulesText::names(const std::vector<bool>& side) const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < side.size(); ++i) {
    if (side[i]) {
      names.push_back(model.links[i].name);
    }
  }
  return names;
}

ReadPairRulesText readPairs(const std::string& yaml, IdleRule idle) {
  ReadPairRulesText read;
  const std::vector<SrdfPairs> srdfs = readArms({""}, read.model);
  SetupReport report;
  read.rules = readPairRules({"rules.yaml", yaml}, read.model, srdfs, idle, report);
  read.errors = textsOf(report.errors);
  read.warnings = textsOf(report.warnings);
  return read;
}

ReadRules readFields(const std::string& fields) {
  return readRules("shapes:\n  - link: arm_1\n    " + fields + "\n");
}

}  // namespace collision_monitor::test
