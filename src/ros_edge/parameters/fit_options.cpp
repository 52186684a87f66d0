// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/fit_options.h"

#include <exception>

#include "pipeline/fits/fit_cache_folder.h"

namespace collision_monitor {

SetupOptions loadSetupOptions(const Parameters& parameters, const ResourceLoader& load_resource,
                              SetupReport& report) {
  SetupOptions options = parameters.setup;
  options.fit_cache = fitCacheFolder(parameters.fit_cache);
  if (parameters.shape_rules.empty()) {
    return options;
  }
  options.shape_rules.source = parameters.shape_rules;
  try {
    options.shape_rules.yaml = load_resource(parameters.shape_rules);
  } catch (const std::exception& fault) {
    report.errors.push_back({options.where + "shape_rules '" + parameters.shape_rules + "'",
                             fault.what(), "a readable file or package:// URI"});
  }
  return options;
}

}  // namespace collision_monitor
