// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/fits/fit_cache.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <fstream>
#include <thread>

#include "pipeline/fits/fit_text.h"
#include "pipeline/fits/sha256.h"
#include "support/robots/file_loader.h"
#include "support/sample_meshes.h"
#include "support/scratch_folder.h"

namespace collision_monitor {
namespace {

namespace fs = std::filesystem;
using test::boxMesh;
using test::ScratchFolder;

const FitLimits kLimits{3, 0.001, {}};

/// A prism, a box that is exact, a cylinder.
std::vector<Geometry> someGeometries() {
  return {test::prismMesh(0.1, 0.3, 12), Box{{0.1, 0.2, 0.3}}, Cylinder{0.2, 0.05}};
}

void writeFile(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

/// A directory that holds the fits of someGeometries().
struct FilledCache {
  FilledCache() {
    FitCache cache(folder.path());
    cache.keep(key, fits, false);
    EXPECT_EQ(cache.writeFault(), "");
    file = folder.path() / (key + ".fit");
  }
  bool isHit() const {
    FitCache cache(folder.path());
    return cache.load(key, geometries).has_value();
  }

  ScratchFolder folder;
  std::vector<Geometry> geometries{someGeometries()};
  std::string key{fitKey(geometries, kLimits)};
  std::vector<Fit> fits{fitGeometries(geometries, kLimits)};
  fs::path file;
};

TEST(Sha256, abc_isAsInTheStandard) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(FitKey, changesWithEveryBitThatFitsDependOn) {
  const std::vector<Geometry> geometries{boxMesh({0.1, 0.2, 0.3})};
  const std::string key = fitKey(geometries, kLimits);
  EXPECT_EQ(key, fitKey({boxMesh({0.1, 0.2, 0.3})}, kLimits));
  TriangleMesh moved = boxMesh({0.1, 0.2, 0.3});
  moved.vertices[3].z() = std::nextafter(moved.vertices[3].z(), 1.0);
  EXPECT_NE(key, fitKey({moved}, kLimits));
  TriangleMesh turned = boxMesh({0.1, 0.2, 0.3});
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_NE(key, fitKey({turned}, kLimits));
  EXPECT_NE(key, fitKey({geometries[0], geometries[0]}, kLimits));
  EXPECT_NE(key, fitKey(geometries, {4, 0.001, {}}));
  EXPECT_NE(key, fitKey(geometries, {3, 0.002, {}}));
  EXPECT_NE(key, fitKey(geometries, {3, 0.001, {true, true, false, true}}));
  EXPECT_NE(fitKey({Sphere{0.1}}, kLimits), fitKey({Capsule{0.0, 0.1}}, kLimits));
  EXPECT_NE(fitKey({Capsule{0.2, 0.1}}, kLimits), fitKey({Cylinder{0.2, 0.1}}, kLimits));
}

TEST(FitText, readsBackToTheSameBytes) {
  std::vector<Fit> fits = fitGeometries(someGeometries(), kLimits);
  fits[0].shape_of = {1, 0, 1};
  const std::string text = toText(fits);
  const auto back = fitsFromText(text);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(toText(*back), text);
  ASSERT_EQ(back->size(), 3U);
  EXPECT_EQ((*back)[0].shapes.size(), fits[0].shapes.size());
  EXPECT_EQ((*back)[0].cuts.size(), fits[0].cuts.size());
  EXPECT_EQ((*back)[0].shape_of, fits[0].shape_of);
  EXPECT_TRUE((*back)[1].shape_of.empty());
  EXPECT_TRUE((*back)[1].shapes[0].is_exact);
  EXPECT_FALSE((*back)[2].shapes[0].is_exact);
  EXPECT_EQ(fitsFromText(toText({}))->size(), 0U);
}

TEST(FitText, wellHashedNonsense_isRefused) {
  const std::string header = "collision_monitor fits 2\n";
  for (const std::string body :
       {"", "geometries 1\n", "geometries 99999999999999999999\n", "geometries x\n",
        "geometries 0\nmore\n",
        "geometries 1\ngeometry 1 0 0 0 0 0\n"
        "shape ball 0 0 0 1 1 0 0 0 1 0 0 0 1 0 0 0 0 0 0 0 exact\n",
        "geometries 1\ngeometry 1 0 0 0 0 0\n"
        "shape sphere 0 0 0 1 1 0 0 0 1 0 0 0 1 0 0 0 0 0 0 0 perhaps\n"}) {
    const std::string text = header + body;
    EXPECT_FALSE(fitsFromText(text + "sha256 " + sha256(text) + "\n").has_value()) << body;
  }
}

TEST(FitCache, nothingKept_isAMissAndNoFault) {
  const ScratchFolder folder;
  FitCache cache(folder.path());
  EXPECT_FALSE(cache.load(fitKey(someGeometries(), kLimits), someGeometries()).has_value());
  EXPECT_EQ(cache.rejectedCount(), 0U);
}

TEST(FitCache, kept_isFoundByTheNextStart) {
  const FilledCache filled;
  FitCache cache(filled.folder.path());
  const auto fits = cache.load(filled.key, filled.geometries);
  ASSERT_TRUE(fits.has_value());
  EXPECT_EQ(toText(*fits), toText(filled.fits));
  EXPECT_EQ(cache.rejectedCount(), 0U);
}

TEST(FitCache, directoryIsMade_andHoldsNothingElse) {
  const ScratchFolder folder;
  const fs::path deep = folder.path() / "a" / "b";
  FitCache cache(deep);
  cache.keep("key", {}, false);
  EXPECT_EQ(cache.writeFault(), "");
  EXPECT_TRUE(fs::exists(deep / "key.fit"));
  EXPECT_EQ(std::distance(fs::directory_iterator(deep), {}), 1) << "no temporary file is left";
}

TEST(FitCache, everyByteThatIsDamaged_isNoticed) {
  const FilledCache filled;
  const std::string whole = test::readFile(filled.file);
  for (std::size_t i = 0; i < whole.size(); i += 7) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    writeFile(filled.file, damaged);
    EXPECT_FALSE(filled.isHit()) << "byte " << i;
  }
  for (std::size_t length = 0; length < whole.size(); length += 101) {
    writeFile(filled.file, whole.substr(0, length));
    EXPECT_FALSE(filled.isHit()) << "cut to " << length;
  }
  writeFile(filled.file, whole + "\n");
  EXPECT_FALSE(filled.isHit());
  writeFile(filled.file, whole);
  EXPECT_TRUE(filled.isHit());
}

TEST(FitCache, damagedFile_isCountedAndReplaced) {
  const FilledCache filled;
  writeFile(filled.file, "half a fi");
  FitCache cache(filled.folder.path());
  EXPECT_FALSE(cache.load(filled.key, filled.geometries).has_value());
  EXPECT_EQ(cache.rejectedCount(), 1U);
  cache.keep(filled.key, filled.fits, false);
  EXPECT_TRUE(filled.isHit());
}

/// As a disk that fails: there is something to open, and reading it is an error.
TEST(FitCache, fileThatCannotBeRead_isRefused) {
  const FilledCache filled;
  fs::remove(filled.file);
  fs::create_directory(filled.file);
  FitCache cache(filled.folder.path());
  EXPECT_FALSE(cache.load(filled.key, filled.geometries).has_value());
  EXPECT_EQ(cache.rejectedCount(), 1U);
}

/// To open one would be to wait for somebody who writes to it.
TEST(FitCache, fileThatIsAPipe_isRefusedAndReplaced) {
  const FilledCache filled;
  fs::remove(filled.file);
  ASSERT_EQ(mkfifo(filled.file.c_str(), 0600), 0);
  FitCache cache(filled.folder.path());
  EXPECT_FALSE(cache.load(filled.key, filled.geometries).has_value());
  EXPECT_EQ(cache.rejectedCount(), 1U);
  cache.keep(filled.key, filled.fits, false);
  EXPECT_TRUE(filled.isHit());
}

TEST(FitCache, otherVersion_isRefused) {
  const FilledCache filled;
  const std::string whole = test::readFile(filled.file);
  const std::string fits =
      whole.substr(whole.find('\n'), whole.rfind("sha256 ") - whole.find('\n'));
  for (const std::string version : {"1", "2", "3", "4"}) {
    const std::string text = "collision_monitor fits " + version + fits;
    writeFile(filled.file, text + "sha256 " + sha256(text) + "\n");
    EXPECT_EQ(filled.isHit(), version == "3") << version;
  }
}

TEST(FitCache, shapesThatDoNotEnclose_areRefused_wellHashedAsTheyAre) {
  const FilledCache filled;
  for (std::size_t geometry = 0; geometry < 3; ++geometry) {
    std::vector<Fit> short_fits = filled.fits;
    Shape& shape = short_fits[geometry].shapes.front().shape;
    shape = grown(shape, -1e-6);
    writeFile(filled.file, toText(short_fits));
    EXPECT_FALSE(filled.isHit()) << "geometry " << geometry;
  }
  std::vector<Fit> missing = filled.fits;
  missing.pop_back();
  writeFile(filled.file, toText(missing));
  EXPECT_FALSE(filled.isHit());
}

TEST(FitCache, claimToBeExact_isChecked) {
  const FilledCache filled;
  std::vector<Fit> boasting = filled.fits;
  boasting[2].shapes.front().is_exact = true;
  writeFile(filled.file, toText(boasting));
  EXPECT_FALSE(filled.isHit()) << "no shape is a cylinder";
  boasting = filled.fits;
  boasting[1].shapes.front().shape = Box{{0.1, 0.2, 0.4}};
  writeFile(filled.file, toText(boasting));
  EXPECT_FALSE(filled.isHit()) << "a larger box is not the box";
}

TEST(FitCache, unwritableDirectory_isOneFaultAndNoFailure) {
  const ScratchFolder folder;
  writeFile(folder.path() / "file", "in the way");
  FitCache cache(folder.path() / "file" / "fits");
  cache.keep("a", {}, false);
  EXPECT_NE(cache.writeFault(), "");
  cache.keep("b", {}, false);
}

TEST(FitCache, withoutDirectory_keepsNothing) {
  FitCache cache("");
  const auto fits = fitGeometries({Sphere{0.1}}, kLimits);
  cache.keep("key", fits, false);
  EXPECT_FALSE(cache.load("key", {Sphere{0.1}}).has_value());
  EXPECT_EQ(cache.writeFault(), "");
}

TEST(FitCache, writersAndReadersAtOnce_neverSeeHalfAFile) {
  const FilledCache filled;
  std::vector<std::thread> writers;
  for (int i = 0; i < 3; ++i) {
    writers.emplace_back([&] {
      for (int turn = 0; turn < 100; ++turn) {
        FitCache(filled.folder.path()).keep(filled.key, filled.fits, false);
      }
    });
  }
  for (int turn = 0; turn < 100; ++turn) {
    EXPECT_TRUE(filled.isHit());
  }
  for (std::thread& writer : writers) {
    writer.join();
  }
  EXPECT_TRUE(filled.isHit());
  EXPECT_EQ(std::distance(fs::directory_iterator(filled.folder.path()), {}), 1);
}

}  // namespace
}  // namespace collision_monitor
