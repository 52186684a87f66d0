// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/fit_options.h"

#include <exception>

#include "pipeline/fits/fit_cache_folder.h"

namespace collision_monitor {
namespace {

/// The text of a file; empty if there is no name, or after an error.
std::string load(const std::string& name, const std::string& parameter,
                 const ResourceLoader& load_resource, SetupReport& report) {
  try {
    return name.empty() ? "" : load_resource(name);
  } catch (const std::exception& fault) {
    report.errors.push_back(
        {parameter + " '" + name + "'", fault.what(), "a readable file or package:// URI"});
  }
  return "";
}

}  // namespace

SetupOptions loadSetupOptions(const Parameters& parameters, const ResourceLoader& load_resource,
                              SetupReport& report) {
  SetupOptions options = parameters.setup;
  options.fit_cache = fitCacheFolder(parameters.fit_cache);
  options.shape_rules = {
      parameters.shape_rules,
      load(parameters.shape_rules, options.where + "shape_rules", load_resource, report)};
  if (!parameters.pair_rules.empty()) {
    options.pair_rules = {
        parameters.pair_rules,
        load(parameters.pair_rules, options.where + "pair_rules", load_resource, report)};
  }
  return options;
}

}  // namespace collision_monitor
