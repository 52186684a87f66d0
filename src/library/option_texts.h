// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "collision_monitor/robot_monitor.h"

/// The files and texts that options name.
namespace collision_monitor {

/// The caller's loader of resources, or one for files below the package roots.
ResourceLoader loaderOf(const MonitorOptions& options);

/// Empty if the directory is.
std::string absoluteOf(const std::string& directory);

/// Reads the file of a document that has no text.
/// @param option its name in messages
void readText(const char* option, DocumentText& document, SetupReport& report);

/// Reads the files of all documents that have no text.
void readTexts(MonitorOptions& options, SetupReport& report);

/// Adds faults of texts that could not be looked at beside other faults. Their names may be right.
void addTextFaults(const MonitorOptions& options, SetupReport& report);

}  // namespace collision_monitor
