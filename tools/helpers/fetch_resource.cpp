// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <resource_retriever/retriever.h>

#include <stdexcept>
#include <string>

#include "model/helper_main.h"

/// Fetches files for Downloads: the question's bytes are the largest size [bytes] in digits.
int main() {
  resource_retriever::Retriever retriever;
  const auto fetch = [&](const std::string& uri, const std::string& most) {
    const resource_retriever::MemoryResource resource = retriever.get(uri);
    if (resource.size > std::stoull(most)) {
      throw std::runtime_error(uri + ": larger than the limit of " + most + " bytes");
    }
    return std::string(resource.data.get(), resource.data.get() + resource.size);
  };
  return collision_monitor::answerQuestions(fetch, "larger than the limit, or without an end");
}
