// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/place.h"

namespace collision_monitor {

/// The only document of a text; null if there is none.
/// @throws YAML::Exception if the text is no YAML, is not in the encoding that it seems to have, or
/// has another document, which nobody would read.
YAML::Node loadYaml(const std::string& text);

/// Line of the document where a node begins, from 1; 0 if it has none.
int lineOf(const YAML::Node& node);

/// The value in the words of a message: "'abc'", "a list of 3".
std::string describe(const YAML::Node& node);

/// Undefined if the node is no map or has no such key.
YAML::Node childOf(const YAML::Node& node, const std::string& key);

/// The fields of a YAML map. Notes which keys were asked for, so that refuseOthers can report the
/// unknown ones. Each fault is added to the place, and the field then counts as absent.
class YamlFields {
 public:
  /// `what` describes the expected map if the node is none: "a rule with its fields".
  YamlFields(const YAML::Node& node, const Place& place, const std::string& what);

  /// Nothing if the key is absent.
  std::optional<YAML::Node> find(const std::string& key);
  std::optional<std::string> readText(const std::string& key, const std::string& accepted);
  std::optional<bool> readBool(const std::string& key);
  /// One word, or a list of them; never empty. Nodes keep their lines.
  std::vector<YAML::Node> readWords(const std::string& key, const std::string& accepted);
  /// `count` finite numbers from `least` to `greatest`: one as a scalar, several as a list.
  std::optional<Eigen::VectorXd> readNumbers(const std::string& key, int count, double least,
                                             double greatest);
  std::optional<double> readNumber(const std::string& key, double least, double greatest);
  /// The lengths that a `kind` of shape needs; ones after a fault.
  Eigen::VectorXd readLengths(const std::string& key, int count, double least, double greatest);
  void refuse(const std::string& key, const std::string& accepted);
  bool refuseOthers();  ///< @return whether there were others

 private:
  YAML::Node node_;
  const Place& place_;
  std::vector<std::string> asked_for_;
};

}  // namespace collision_monitor
