// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <string>
#include <vector>

#include "collision_monitor/model/problems.h"

namespace collision_monitor {

/// Accepted range of a number. An open end is not itself accepted.
struct NumberRange {
  double least;
  double greatest;
  bool is_least_open{false};
  bool is_whole{false};  ///< only whole numbers
};

constexpr NumberRange wholeNumbers(double least, double greatest) {
  return {least, greatest, false, true};
}

/// Reads one struct of parameters field by field. Notes which names were read, so that the others
/// can be refused. A missing or faulty field leaves the value unchanged; a faulty one also adds a
/// problem.
class ParameterStruct {
 public:
  ParameterStruct(const XmlRpc::XmlRpcValue& values, std::string where, SetupReport& report);

  void read(const std::string& name, const NumberRange& range, double& value);
  void read(const std::string& name, bool& value);
  void read(const std::string& name, std::string& value);
  /// One of `words`; `position` is its index.
  void read(const std::string& name, const std::vector<std::string>& words, std::size_t& position);
  /// The raw value of a field, or nullptr.
  const XmlRpc::XmlRpcValue* find(const std::string& name);
  /// Accepts a name that other software uses in this namespace.
  void tolerate(const std::string& name);
  /// Adds a problem for each name that was not read.
  void refuseOthers();

  std::string pathOf(const std::string& name) const { return where_ + "/" + name; }

 private:
  void refuse(const std::string& name, const std::string& found, const std::string& accepted);

  const XmlRpc::XmlRpcValue& values_;
  std::string where_;
  SetupReport& report_;
  std::vector<std::string> asked_for_;
};

/// The value for a message; of lists and structs only their size.
std::string toText(const XmlRpc::XmlRpcValue& value);

/// The whole value as YAML. Items of an outer list stand one a line.
std::string toYaml(const XmlRpc::XmlRpcValue& value);

}  // namespace collision_monitor
