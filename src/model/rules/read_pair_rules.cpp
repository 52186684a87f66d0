// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "collision_monitor/model/pair_rules.h"
#include "model/object_links.h"
#include "model/rules/link_selection.h"
#include "model/rules/yaml_fields.h"

namespace collision_monitor {
namespace {

const char* const kSides = "names of links, patterns with * and ?, or groups as {group: NAME}";

/// The names of kLimitFields, and "check".
std::string settingNames() {
  std::vector<std::string> names{"check"};
  for (const LimitField& field : kLimitFields) {
    names.emplace_back(field.name);
  }
  return joined(names);
}

/// Finds the links of one side of a rule.
struct SideReader {
  const RobotModel& model;
  const std::vector<SrdfPairs>& srdfs;
  IdleRule idle;
  const Place& place;
  std::vector<bool>& links;

  void add(const std::vector<LinkId>& found) const {
    for (const LinkId link : found) {
      links[index(link)] = true;
    }
  }

  void tellIdle(const YAML::Node& node, const std::string& found,
                const std::string& accepted) const {
    if (idle == IdleRule::is_accepted) {
      return;
    }
    idle == IdleRule::is_error ? place.addError(lineOf(node), found, accepted)
                               : place.addWarning(lineOf(node), found, "known are " + accepted);
  }

  void addNamed(const YAML::Node& word) const {
    const std::string& name = word.Scalar();
    const std::vector<LinkId> found = findMatching(name, model);
    if (found.empty()) {
      const bool is_group = findGroup(name, model, srdfs).has_value();
      tellIdle(word, "link " + quoted(name) + ", which matches none",
               is_group ? "the group of that name, as {group: " + name + "}"
                        : (hasObjects(model) ? "links and objects: " : "links of the robots: ") +
                              linkNames(model));
    }
    add(found);
  }

  void addGroup(const YAML::Node& node) const {
    YamlFields fields(node, place, kSides);
    const auto name = fields.readText("group", "a group of an SRDF");
    fields.refuseOthers();
    if (!name) {
      if (!fields.find("group")) {
        place.addError(lineOf(node), describe(node), kSides);
      }
      return;
    }
    const auto group = findGroup(*name, model, srdfs);
    if (!group || group->empty()) {
      tellIdle(node, "group " + quoted(*name) + (group ? ", which is empty" : ", which is unknown"),
               "groups of the SRDFs: " + groupNames(srdfs));
      return;
    }
    add(*group);
  }

  void read(const YAML::Node& node) const {
    if (node.IsMap()) {
      addGroup(node);
    } else if (node.IsScalar() && !node.Scalar().empty()) {
      addNamed(node);
    } else {
      place.addError(lineOf(node), describe(node), kSides);
    }
  }
};

/// Reads the rules of one text.
class PairRuleReader {
 public:
  PairRuleReader(const RobotModel& model, const std::vector<SrdfPairs>& srdfs, IdleRule idle)
      : model_(model), srdfs_(srdfs), idle_(idle) {}

  PairRule read(const YAML::Node& node, const Place& place) const {
    PairRule rule;
    YamlFields fields(node, place, "a rule with its fields");
    rule.a = readSide("a", fields, node, place);
    rule.b = readSide("b", fields, node, place);
    if (!node.IsMap()) {
      return rule;
    }
    rule.is_checked = fields.readBool("check");
    bool sets_any = fields.find("check").has_value();
    for (std::size_t i = 0; i < kLimitFields.size(); ++i) {
      const LimitField& field = kLimitFields[i];
      rule.limits[i] = fields.readNumber(field.name, field.least, field.greatest);
      sets_any = sets_any || fields.find(field.name);
    }
    const bool may_be_misspelt = fields.refuseOthers();
    if (!sets_any && !may_be_misspelt) {
      place.addError(lineOf(node), "a rule that sets nothing", settingNames());
    }
    return rule;
  }

 private:
  std::vector<bool> readSide(const char* key, YamlFields& fields, const YAML::Node& rule,
                             const Place& place) const {
    std::vector<bool> links(model_.links.size(), false);
    const std::optional<YAML::Node> side = fields.find(key);
    if (!side) {
      if (rule.IsMap()) {
        place.addError(lineOf(rule), "a rule without '" + std::string(key) + "'", kSides);
      }
      return links;
    }
    const SideReader reader{model_, srdfs_, idle_, place, links};
    if (!side->IsSequence()) {
      reader.read(*side);
    } else if (side->size() == 0) {
      fields.refuse(key, kSides);
    } else {
      for (const YAML::Node& item : *side) {
        reader.read(item);
      }
    }
    return links;
  }

  const RobotModel& model_;
  const std::vector<SrdfPairs>& srdfs_;
  IdleRule idle_;
};

/// The list of rules; no sequence if there is none or after an error.
YAML::Node findPairRules(const std::string& yaml, const Place& place) {
  const std::string accepted = "YAML with a list of rules, alone or under 'pair_rules'";
  try {
    const YAML::Node document = loadYaml(yaml);
    if (document.IsSequence() || document.IsNull()) {
      return document;
    }
    YamlFields fields(document, place, accepted);
    const std::optional<YAML::Node> rules = fields.find("pair_rules");
    fields.refuseOthers();
    if (rules && !rules->IsSequence() && !rules->IsNull()) {
      fields.refuse("pair_rules", "a list of rules");
    } else if (document.IsMap() && !rules) {
      place.addError(lineOf(document), "no 'pair_rules'", accepted);
    }
    return rules ? *rules : YAML::Node();
  } catch (const YAML::Exception& fault) {
    place.addError(fault.mark.line + 1, "text that is no YAML: " + fault.msg,
                   accepted + "; patterns stand in quotes");
  }
  return {};
}

}  // namespace

std::vector<PairRule> readPairRules(const DocumentText& text, const RobotModel& model,
                                    const std::vector<SrdfPairs>& srdfs, IdleRule idle,
                                    SetupReport& report) {
  std::vector<PairRule> rules;
  Oddities oddities;
  const Place place(text.source, report, oddities);
  const YAML::Node list = findPairRules(text.text, place);
  const PairRuleReader reader(model, srdfs, idle);
  for (std::size_t i = 0; list.IsSequence() && i < list.size(); ++i) {
    const std::string number = "rule " + std::to_string(i + 1);
    rules.push_back(reader.read(list[i], place.within(number)));
    rules.back().where = text.source + " line " + std::to_string(lineOf(list[i])) + ", " + number;
    rules.back().yaml = YAML::Dump(list[i]);
  }
  return rules;
}

std::vector<PairRule> selectAnew(std::vector<PairRule> rules, const RobotModel& model,
                                 const std::vector<SrdfPairs>& srdfs) {
  SetupReport none;  // the rules were read before
  Oddities oddities;
  const PairRuleReader reader(model, srdfs, IdleRule::is_accepted);
  for (PairRule& rule : rules) {
    PairRule read = reader.read(YAML::Load(rule.yaml), Place(rule.where, none, oddities));
    rule.a = std::move(read.a);
    rule.b = std::move(read.b);
  }
  return rules;
}

}  // namespace collision_monitor
