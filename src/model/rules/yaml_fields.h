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

/// Line of the document that a node starts in, from 1; 0 if it has none.
int lineOf(const YAML::Node& node);

/// The value as a person would call it: "'abc'", "a list of 3".
std::string describe(const YAML::Node& node);

/// The fields of a YAML map. Notes which keys it was asked for, so that those nobody knows can be
/// told. Each fault is added to the place; the field then counts as absent.
class YamlFields {
 public:
  /// `what` is named where the node is no map: "a rule with its fields".
  YamlFields(const YAML::Node& node, const Place& place, const std::string& what);

  /// Nothing for a key that is absent.
  std::optional<YAML::Node> find(const std::string& key);
  std::optional<std::string> readText(const std::string& key, const std::string& accepted);
  std::optional<bool> readBool(const std::string& key);
  /// One word, or a list of them; never empty. Lines as of the words.
  std::vector<YAML::Node> readWords(const std::string& key, const std::string& accepted);
  /// `count` finite numbers from `least` to `greatest`: one as it is, several as a list.
  std::optional<Eigen::VectorXd> readNumbers(const std::string& key, int count, double least,
                                             double greatest);
  std::optional<double> readNumber(const std::string& key, double least, double greatest);
  void refuse(const std::string& key, const std::string& accepted);
  void refuseOthers();

 private:
  YAML::Node node_;
  const Place& place_;
  std::vector<std::string> asked_for_;
};

}  // namespace collision_monitor
