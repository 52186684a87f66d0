// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <resource_retriever/retriever.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <string>

#include "model/mesh_loading/helper_main.h"

namespace {

/// @param most [bytes], in digits
std::string limitText(const std::string& most) {
  return "the limit of " + most + " bytes (parameter files/max_size)";
}

/// resource_retriever hides the HTTP status and returns the page of a 404 as the file. No file of a
/// robot is HTML.
bool isWebPage(const std::string& bytes) {
  std::string start = bytes.substr(0, 1000);
  start.erase(0, start.find_first_not_of(" \t\r\n"));
  std::transform(start.begin(), start.end(), start.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return start.rfind("<!doctype html", 0) == 0 || start.rfind("<html", 0) == 0;
}

/// @param most largest size [bytes], in digits
std::string fetch(const std::string& uri, const std::string& most) {
  static resource_retriever::Retriever retriever;  // reuses its connection
  const resource_retriever::MemoryResource resource = retriever.get(uri);
  if (resource.size > std::stoull(most)) {
    throw std::runtime_error(uri + ": larger than " + limitText(most));
  }
  std::string bytes(resource.data.get(), resource.data.get() + resource.size);
  if (isWebPage(bytes)) {
    throw std::runtime_error(
        uri +
        ": the server answers with a web page (HTML), as it does where there is no such file");
  }
  return bytes;
}

}  // namespace

/// Fetches files for Downloads.
int main() {
  const auto tell = [](const std::string& most, std::uint64_t /*memory*/) {
    return "larger than " + limitText(most) + ", or without an end";
  };
  return collision_monitor::answerQuestions(fetch, tell);
}
