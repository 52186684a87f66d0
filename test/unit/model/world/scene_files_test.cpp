// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>

#include "model/world/world_text.h"
#include "support/robots/file_loader.h"
#include "support/robots/world_objects.h"

/// The planning scenes of other projects.
namespace collision_monitor::test {
namespace {

namespace fs = std::filesystem;

bool isScene(const fs::path& file, const std::string& text) {
  const std::string extension = file.extension().string();
  return (extension == ".yaml" || extension == ".yml") &&
         text.find(" collision_objects:") != std::string::npos &&
         text.find("package://") == std::string::npos;  // these packages are not at hand
}

TEST(SceneFiles, allPlanningScenes_areReadAndHaveNoFault) {
  const auto shared = sharedDataDir();
  if (!shared || !fs::exists(*shared / "scenes")) {
    GTEST_SKIP() << kNoSharedData;
  }
  std::size_t scenes = 0;
  std::size_t objects = 0;
  for (const auto& entry : fs::recursive_directory_iterator(*shared / "scenes")) {
    if (!entry.is_regular_file() || entry.file_size() > 10'000'000) {
      continue;
    }
    const std::string text = readFile(entry.path());
    if (!isScene(entry.path(), text)) {
      continue;
    }
    SCOPED_TRACE(entry.path().string());
    SetupReport report;
    KnownPlaces places;
    places.world_frame = "world";
    const std::vector<WorldObject> read =
        readWorld({entry.path().string(), text, entry.path().parent_path().string()},
                  fileLoader(*shared), {}, report);
    EXPECT_EQ(textsOf(report.errors), std::vector<std::string>());
    const World world =
        applyChanges(World(), {{ChangeKind::replace_all, read, true}}, places, report);
    EXPECT_EQ(textsOf(report.errors), std::vector<std::string>());
    EXPECT_EQ(world.objects.size(), read.size());
    ++scenes;
    objects += read.size();
  }
  EXPECT_GE(scenes, 20U);
  EXPECT_GE(objects, 100U);
}

}  // namespace
}  // namespace collision_monitor::test
