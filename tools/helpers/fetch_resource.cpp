// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <resource_retriever/retriever.h>

#include <stdexcept>
#include <string>

#include "model/helper_main.h"

namespace {

/// @param most largest size [bytes], in digits
std::string fetch(const std::string& uri, const std::string& most) {
  static resource_retriever::Retriever retriever;  // keeps its connection from file to file
  const resource_retriever::MemoryResource resource = retriever.get(uri);
  if (resource.size > std::stoull(most)) {
    throw std::runtime_error(uri + ": larger than the limit of " + most + " bytes");
  }
  return std::string(resource.data.get(), resource.data.get() + resource.size);
}

}  // namespace

/// Fetches files for Downloads.
int main() {
  return collision_monitor::answerQuestions(fetch, "larger than the limit, or without an end");
}
