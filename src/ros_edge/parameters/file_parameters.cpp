// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/file_parameters.h"

#include <algorithm>

#include "ros_edge/parameters/parameter_struct.h"

namespace collision_monitor {
namespace {

using XmlRpc::XmlRpcValue;

/// Source: RFC 3986, 3.1; lower case only, as is customary.
bool isScheme(const std::string& text) {
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !text.empty() && is_letter(text.front()) &&
         std::all_of(text.begin(), text.end(), [&](char c) {
           return is_letter(c) || (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
         });
}

std::vector<std::string> readSchemes(const XmlRpcValue& values, const std::string& where,
                                     SetupReport& report) {
  std::vector<std::string> schemes;
  if (values.getType() != XmlRpcValue::TypeArray) {
    report.errors.push_back(
        {"parameter " + where, toText(values), "a list of schemes, as [http, https]"});
    return schemes;
  }
  for (int i = 0; i < values.size(); ++i) {
    if (values[i].getType() == XmlRpcValue::TypeString &&
        isScheme(static_cast<std::string>(values[i]))) {
      schemes.push_back(static_cast<std::string>(values[i]));
    } else {
      report.errors.push_back({"parameter " + where + "[" + std::to_string(i) + "]",
                               toText(values[i]),
                               "the scheme of a URI in small letters, without ://, as http"});
    }
  }
  return schemes;
}

}  // namespace

void readFileParameters(const XmlRpcValue& values, const std::string& where, LoadRules& loading,
                        MeshReading& meshes, SetupReport& report) {
  constexpr NumberRange kTime{0.0, 1e6, true};
  ParameterStruct fields(values, where, report);
  auto size = static_cast<double>(loading.max_size);
  fields.read("max_size", wholeNumbers(1.0, 1e12), size);
  loading.max_size = static_cast<std::uintmax_t>(size);
  if (const XmlRpcValue* schemes = fields.find("schemes")) {
    loading.schemes = readSchemes(*schemes, fields.pathOf("schemes"), report);
  }
  fields.read("download_time", kTime, loading.download_time);
  fields.read("mesh_time", kTime, meshes.seconds);
  fields.read("mesh_memory", {1e6, 1e15}, meshes.memory);
  fields.refuseOthers();
}

}  // namespace collision_monitor
