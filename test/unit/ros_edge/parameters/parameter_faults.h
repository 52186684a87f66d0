// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>

#include "ros_edge/parameters/parameters.h"

namespace collision_monitor::test {

inline XmlRpc::XmlRpcValue emptyStruct() {
  XmlRpc::XmlRpcValue values;
  values["rate"] = 1;
  return values;
}

/// Where the problems are, without the namespace.
inline std::set<std::string> faults(const XmlRpc::XmlRpcValue& values) {
  SetupReport report;
  readParameters(values, "/m", report);
  std::set<std::string> places;
  for (const Problem& problem : report.errors) {
    places.insert(problem.where);
  }
  return places;
}

}  // namespace collision_monitor::test
