// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/model/shape_rules.h"

#include <algorithm>
#include <cmath>

#include "model/rules/given_shape.h"
#include "model/rules/link_selection.h"
#include "model/rules/yaml_fields.h"

namespace collision_monitor {
namespace {

constexpr double kMaxShapes = 1000;
constexpr double kMaxPadding = 1e3;    // [m]
constexpr double kMaxOvershoot = 1e6;  // [m]

/// Reads the rules of one file in order and stores what they set for each link.
class RuleReader {
 public:
  RuleReader(const RobotModel& model, const std::vector<SrdfPairs>& srdfs,
             std::vector<LinkRules>& rules)
      : model_(model), srdfs_(srdfs), rules_(rules) {}

  void read(const YAML::Node& node, const std::string& source, const Place& place) {
    YamlFields fields(node, place, "a rule with its fields");
    if (!node.IsMap()) {
      return;
    }
    std::vector<LinkId> links = readLinks(fields, place, lineOf(node));
    LinkRules rule = readSettings(fields, place);
    const bool may_be_misspelt = fields.refuseOthers();
    if (rule.given) {
      rule.given->where = source + " line " + std::to_string(lineOf(node));
    }
    if (!may_be_misspelt && !hasAny(fields, {"kinds", "max_shapes", "target_overshoot", "padding",
                                             "refine", "shapes", "unproven"})) {
      place.addError(lineOf(node), "a rule that sets nothing",
                     "kinds, max_shapes, target_overshoot, padding, refine or shapes");
    }
    warnIfNothingToFit(links, rule, lineOf(node), place);
    for (const LinkId link : links) {
      merge(rule, rules_[index(link)]);
    }
  }

 private:
  static bool hasAny(YamlFields& fields, const std::vector<std::string>& keys) {
    return std::any_of(keys.begin(), keys.end(),
                       [&](const std::string& key) { return fields.find(key).has_value(); });
  }

  std::vector<LinkId> readLinks(YamlFields& fields, const Place& place, int line) const {
    const std::string accepted = "one of link, links and group";
    std::vector<LinkId> links;
    int selectors = 0;
    for (const char* key : {"link", "links", "group"}) {
      selectors += fields.find(key) ? 1 : 0;
    }
    if (selectors != 1) {
      place.addError(line, selectors == 0 ? "a rule without links" : "two selections of links",
                     accepted);
    }
    if (const auto name = fields.readText("link", "a link's name")) {
      addMatching(*name, false, *fields.find("link"), place, links);
    }
    for (const YAML::Node& word : fields.readWords("links", "names or patterns with * and ?")) {
      addMatching(word.Scalar(), true, word, place, links);
    }
    if (const auto name = fields.readText("group", "a group of an SRDF")) {
      const auto group = findGroup(*name, model_, srdfs_);
      if (!group && place.awaitsNames()) {
        return links;
      }
      if (!group) {
        fields.refuse("group", "a group of an SRDF: " + groupNames(srdfs_));
      } else if (group->empty()) {
        fields.refuse("group", "a group that has links");
      } else {
        links.insert(links.end(), group->begin(), group->end());
      }
    }
    return links;
  }

  void addMatching(const std::string& name, bool is_pattern, const YAML::Node& node,
                   const Place& place, std::vector<LinkId>& links) const {
    std::vector<LinkId> found = findMatching(name, model_);
    if (!is_pattern) {
      // Here the text is one exact name; stars in it are not patterns.
      found.erase(std::remove_if(found.begin(), found.end(),
                                 [&](LinkId link) {
                                   return model_.link(link).name != name &&
                                          urdfNameOf(model_, link) != name;
                                 }),
                  found.end());
    }
    if (found.empty() && !place.awaitsNames()) {
      const bool has_wildcard = name.find_first_of("*?") != std::string::npos;
      place.addError(lineOf(node),
                     (is_pattern && has_wildcard ? "links " + quoted(name) + ", which matches none"
                                                 : "link " + quoted(name) + ", which is unknown"),
                     "links of the robots: " + linkNames(model_) +
                         (!is_pattern && has_wildcard ? "; patterns go under 'links'" : ""));
    }
    links.insert(links.end(), found.begin(), found.end());
  }

  static LinkRules readSettings(YamlFields& fields, const Place& place) {
    LinkRules rule;
    rule.kinds = readKinds(fields);
    if (const auto count = fields.readNumber("max_shapes", 1.0, kMaxShapes)) {
      if (*count == std::floor(*count)) {
        rule.max_shapes = static_cast<std::uint32_t>(*count);
      } else {
        fields.refuse("max_shapes", "a whole number");
      }
    }
    rule.target_overshoot = fields.readNumber("target_overshoot", 0.0, kMaxOvershoot);
    rule.padding = fields.readNumber("padding", 0.0, kMaxPadding);
    rule.refine = readRefine(fields);
    rule.given = readGiven(fields, place);
    return rule;
  }

  static std::optional<RefineGeometry> readRefine(YamlFields& fields) {
    const std::string accepted = "mesh, hull or none";
    const std::optional<std::string> word = fields.readText("refine", accepted);
    if (!word) {
      return std::nullopt;
    }
    for (const auto& [name, geometry] :
         {std::pair{"mesh", RefineGeometry::mesh}, std::pair{"hull", RefineGeometry::hull},
          std::pair{"none", RefineGeometry::none}}) {
      if (*word == name) {
        return geometry;
      }
    }
    fields.refuse("refine", accepted);
    return std::nullopt;
  }

  static std::optional<ShapeKinds> readKinds(YamlFields& fields) {
    const std::string accepted = "a list of sphere, capsule, box and rounded_box";
    const std::vector<YAML::Node> words = fields.readWords("kinds", accepted);
    ShapeKinds kinds{false, false, false, false};
    for (const YAML::Node& word : words) {
      const std::string& kind = word.Scalar();
      bool* const chosen = kind == "sphere"        ? &kinds.sphere
                           : kind == "capsule"     ? &kinds.capsule
                           : kind == "box"         ? &kinds.box
                           : kind == "rounded_box" ? &kinds.rounded_box
                                                   : nullptr;
      if (chosen == nullptr) {
        fields.refuse("kinds", accepted);
        return std::nullopt;
      }
      *chosen = true;
    }
    return words.empty() ? std::nullopt : std::optional<ShapeKinds>(kinds);
  }

  static std::optional<GivenShapes> readGiven(YamlFields& fields, const Place& place) {
    const std::optional<YAML::Node> list = fields.find("shapes");
    const std::optional<bool> is_unproven = fields.readBool("unproven");
    if (!list) {
      if (fields.find("unproven")) {
        fields.refuse("unproven", "beside 'shapes' in the same rule");
      }
      return std::nullopt;
    }
    if (!list->IsSequence() || list->size() == 0) {
      fields.refuse("shapes", "a list of one shape or more");
      return std::nullopt;
    }
    for (const char* key : {"kinds", "max_shapes", "target_overshoot", "refine"}) {
      if (fields.find(key)) {
        fields.refuse(key, "no limits of fits in a rule that gives the shapes itself");
      }
    }
    GivenShapes given;
    given.is_unproven = is_unproven.value_or(false);
    for (std::size_t i = 0; i < list->size(); ++i) {
      const auto shape = readGivenShape((*list)[i], place.within("shape " + std::to_string(i + 1)));
      if (shape) {
        given.shapes.push_back(*shape);
      }
    }
    return given.shapes.empty() ? std::nullopt : std::optional<GivenShapes>(given);
  }

  void warnIfNothingToFit(const std::vector<LinkId>& links, const LinkRules& rule, int line,
                          const Place& place) const {
    const bool is_in_vain =
        !links.empty() && !rule.given && std::all_of(links.begin(), links.end(), [&](LinkId link) {
          return model_.link(link).collisions.empty() && !rules_[index(link)].given;
        });
    if (is_in_vain) {
      place.addWarning(line, "links without geometry",
                       "the rule does nothing for them; 'shapes' would give them some");
    }
  }

  static void merge(const LinkRules& later, LinkRules& rules) {
    rules.kinds = later.kinds ? later.kinds : rules.kinds;
    rules.max_shapes = later.max_shapes ? later.max_shapes : rules.max_shapes;
    rules.target_overshoot =
        later.target_overshoot ? later.target_overshoot : rules.target_overshoot;
    rules.padding = later.padding ? later.padding : rules.padding;
    rules.given = later.given ? later.given : rules.given;
    rules.refine = later.refine ? later.refine : rules.refine;
  }

  const RobotModel& model_;
  const std::vector<SrdfPairs>& srdfs_;
  std::vector<LinkRules>& rules_;
};

/// The list under `shapes`; an undefined node after an error or a warning.
YAML::Node findRules(const std::string& yaml, const Place& place) {
  const std::string accepted = "YAML with a list of rules under 'shapes'";
  const char* const kNoRule = "rules stand in a list under 'shapes'";
  try {
    const YAML::Node document = loadYaml(yaml);
    if (document.IsNull()) {
      place.addWarning(0, "no rule", kNoRule);
      return {};
    }
    YamlFields fields(document, place, accepted);
    const std::optional<YAML::Node> rules = fields.find("shapes");
    fields.refuseOthers();
    if (rules && rules->IsSequence()) {
      return *rules;
    }
    if (document.IsMap() && rules && rules->IsNull()) {
      place.addWarning(lineOf(document), "no rule", kNoRule);
    } else if (rules) {
      fields.refuse("shapes", "a list of rules");
    } else if (document.IsMap()) {
      place.addError(lineOf(document), "no 'shapes'", accepted);
    }
  } catch (const YAML::Exception& fault) {
    place.addError(fault.mark.line + 1, "text that is no YAML: " + fault.msg, accepted);
  }
  return {};
}

}  // namespace

std::vector<LinkRules> readShapeRules(const DocumentText& text, const RobotModel& model,
                                      const std::vector<SrdfPairs>& srdfs, SetupReport& report) {
  std::vector<LinkRules> rules(model.links.size());
  if (text.source.empty() && text.text.empty()) {
    return rules;
  }
  Oddities oddities;
  const Place place(text.source, report, oddities);
  const YAML::Node list = findRules(text.text, place);
  RuleReader reader(model, srdfs, rules);
  for (std::size_t i = 0; list.IsSequence() && i < list.size(); ++i) {
    reader.read(list[i], text.source, place.within("rule " + std::to_string(i + 1)));
  }
  return rules;
}

}  // namespace collision_monitor
