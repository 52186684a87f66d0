// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "collision_monitor/fitting/fit_parts.h"

namespace collision_monitor {

/// A hash of everything that fits depend on: the version of the method, the geometries to the last
/// bit, and the limits. The pose of a geometry on its link does not matter.
std::string fitKey(const std::vector<Geometry>& geometries, const FitLimits& limits);

/// Fits of earlier set-ups: a directory with one file for each link.
///
/// Files are never trusted. A file that is not regular, is damaged, has another version or does not
/// provably enclose the geometry is counted, and the new fit replaces it. Files are written under a
/// temporary name and renamed, so that programs that start at the same time never see half a file.
/// Any file may be deleted at any time. Several threads and programs may use the directory at once.
class FitCache {
 public:
  /// An empty path: nothing is kept.
  explicit FitCache(std::filesystem::path directory);

  /// Loads fits and proves that they enclose the geometries.
  std::optional<std::vector<Fit>> load(const std::string& key,
                                       const std::vector<Geometry>& geometries);

  /// Stores fits in the directory, unless they come from it.
  void keep(const std::string& key, const std::vector<Fit>& fits, bool is_from_file);

  /// Number of files that could not be used. Call this and writeFault after all threads have ended.
  std::size_t rejectedCount() const { return rejected_count_; }
  /// Why the directory could not be written; empty if it could.
  const std::string& writeFault() const { return write_fault_; }

 private:
  std::filesystem::path fileOf(const std::string& key) const;
  void write(const std::string& key, const std::vector<Fit>& fits);
  void noteFault(const std::string& fault);

  std::filesystem::path directory_;
  mutable std::mutex mutex_;  ///< guards everything below
  std::size_t rejected_count_{0};
  std::string write_fault_;
};

}  // namespace collision_monitor
