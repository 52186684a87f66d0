// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision_monitor/ros_edge/resource_loader.h"

#include <resource_retriever/retriever.h>

#include <memory>
#include <string>

namespace collision_monitor {

ResourceLoader makeResourceLoader() {
  auto retriever = std::make_shared<resource_retriever::Retriever>();
  return [retriever](const std::string& uri) {
    // curl knows no plain paths.
    const std::string url = uri.rfind('/', 0) == 0 ? "file://" + uri : uri;
    const resource_retriever::MemoryResource resource = retriever->get(url);
    return std::string(resource.data.get(), resource.data.get() + resource.size);
  };
}

}  // namespace collision_monitor
