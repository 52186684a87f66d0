// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/parameters/downloads.h"

#include <algorithm>
#include <stdexcept>

namespace collision_monitor {
namespace {

/// The server part of a URI: "http://server:80".
std::string serverOf(const std::string& uri) {
  const std::size_t slashes = uri.find("://");
  const std::size_t start = slashes == std::string::npos ? 0 : slashes + 3;
  return uri.substr(0, std::min(uri.find('/', start), uri.size()));
}

/// [bytes] resource_retriever's buffer grows by doubling and is then copied; the answer is another
/// copy. The constant is address space for the threads that resolve host names.
double memoryFor(std::uintmax_t size) { return 5.0 * static_cast<double>(size) + 3e8; }

}  // namespace

std::string Downloads::load(const std::string& uri) {
  // Otherwise many files of one slow server, one after the other, could block without end.
  const auto known = fault_of_.find(serverOf(uri));
  if (known != fault_of_.end()) {
    throw std::runtime_error(uri + ": not asked for after " + known->second);
  }
  if (!helper_) {
    helper_ = std::make_unique<HelperProcess>(findHelper("fetch_resource"));
  }
  try {
    return helper_->ask(uri, std::to_string(rules_.max_size),
                        {rules_.download_time, memoryFor(rules_.max_size), "files/download_time"});
  } catch (const HelperTimeout& fault) {
    fault_of_[serverOf(uri)] = fault.what();
    throw;
  }
}

}  // namespace collision_monitor
