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

/// Hash of everything that fits depend on: the version of the method, the geometries to the last
/// bit, the limits. Where a geometry sits on its link does not matter.
std::string fitKey(const std::vector<Geometry>& geometries, const FitLimits& limits);

/// Fits of earlier set-ups, one file a link in a directory.
///
/// Files are never trusted: what is no regular file, damaged, of another version, or does not
/// provably enclose the geometry is none, counted, and overwritten by what is fitted instead. They
/// are written under another name and renamed, so that programs that start at once never see half a
/// file. Any file may be deleted at any time. Several threads, and other programs, may use it at
/// the same time.
class FitCache {
 public:
  /// An empty directory keeps nothing.
  explicit FitCache(std::filesystem::path directory);

  /// Fits from the directory, proven to enclose the geometries.
  std::optional<std::vector<Fit>> load(const std::string& key,
                                       const std::vector<Geometry>& geometries);

  /// Keeps fits in the directory if they are not from there.
  void keep(const std::string& key, const std::vector<Fit>& fits, bool is_from_file);

  /// Files that were there and of no use. Both are to be asked when all threads are done.
  std::size_t rejectedCount() const { return rejected_count_; }
  /// Why the directory could not be written, once; empty if it could.
  const std::string& writeFault() const { return write_fault_; }

 private:
  std::filesystem::path fileOf(const std::string& key) const;
  void write(const std::string& key, const std::vector<Fit>& fits);
  void noteFault(const std::string& fault);

  std::filesystem::path directory_;
  mutable std::mutex mutex_;  ///< of all below
  std::size_t rejected_count_{0};
  std::string write_fault_;
};

}  // namespace collision_monitor
