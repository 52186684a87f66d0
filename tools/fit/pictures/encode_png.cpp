// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <png.h>

#include <stdexcept>

#include "picture.h"

namespace collision_monitor::fit_tool {

std::string encodePng(const Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  std::string file(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = file.size();
  if (png_image_write_to_memory(&image, file.data(), &size, 0, picture.bytes.data(), 0, nullptr) ==
      0) {
    throw std::runtime_error(std::string("no PNG can be made: ") + image.message);
  }
  file.resize(size);
  return file;
}

}  // namespace collision_monitor::fit_tool
