// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "library/option_texts.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

#include "model/mesh_files/regular_file.h"
#include "model/resources/file_loader.h"
#include "model/world/world_text.h"

namespace collision_monitor {

ResourceLoader loaderOf(const MonitorOptions& options) {
  FileSources sources;
  sources.package_roots = options.package_roots;
  return options.load_resource ? options.load_resource : makeFileLoader(sources);
}

std::string absoluteOf(const std::string& directory) {
  std::error_code ignored;
  return directory.empty() ? "" : std::filesystem::absolute(directory, ignored).string();
}

void readText(const char* option, DocumentText& document, SetupReport& report) {
  if (document.source.empty() || !document.text.empty()) {
    return;
  }
  const std::filesystem::path file = document.source;
  try {
    document.text = readRegularFile(file);
  } catch (const std::runtime_error& fault) {
    report.errors.push_back(
        {std::string("option ") + option, fault.what(), "a file that can be read, or its text"});
  }
  if (document.directory.empty()) {
    document.directory = file.has_parent_path() ? file.parent_path().string() : ".";
  }
}

void readTexts(MonitorOptions& options, SetupReport& report) {
  readText("shape_rules", options.shape_rules, report);
  readText("pair_rules", options.pair_rules, report);
  readText("world", options.world, report);
}

void addTextFaults(const MonitorOptions& options, SetupReport& report) {
  SetupReport of_texts;
  of_texts.awaits_names = true;
  readShapeRules(options.shape_rules, RobotModel(), {}, of_texts);
  readPairRules(options.pair_rules, RobotModel(), {}, IdleRule::is_accepted, of_texts);
  readWorld({options.world.source, options.world.text, absoluteOf(options.world.directory)},
            loaderOf(options), options.meshes, of_texts);
  for (Problem& fault : of_texts.errors) {
    const bool is_told =
        std::any_of(report.errors.begin(), report.errors.end(), [&](const Problem& told) {
          return told.where == fault.where && told.found == fault.found;
        });
    if (!is_told) {
      report.errors.push_back(std::move(fault));
    }
  }
}

}  // namespace collision_monitor
