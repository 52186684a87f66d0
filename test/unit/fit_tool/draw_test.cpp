// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/constants.h"
#include "pictures/picture.h"
#include "pictures/surface_mesh.h"
#include "support/random_poses.h"
#include "support/sample_meshes.h"

namespace collision_monitor::fit_tool {
namespace {

std::size_t seenOf(const DepthImage& image, int owner) {
  return static_cast<std::size_t>(std::count(image.owner.begin(), image.owner.end(), owner));
}

TEST(View, ofASphere_fillsNineTenthsOfTheHeight) {
  const PosedShape ball{Sphere{0.5}, {Eigen::Matrix3d::Identity(), {3.0, -2.0, 7.0}}};
  const View view = viewOf({ball}, {}, 400, 200);
  EXPECT_NEAR(view.pixels_per_metre, 0.9 * 200 / 1.0, 1e-9);
  const Eigen::Vector3d middle = view.pixelOf(ball.geometry_from_body.translation);
  EXPECT_NEAR(middle.x(), 200.0, 1e-9);
  EXPECT_NEAR(middle.y(), 100.0, 1e-9);
}

TEST(View, upInTheLink_isUpInThePicture) {
  const View view = viewOf({}, {{0, 0, 0}, {0.1, 0.1, 1}}, 100, 100);
  EXPECT_TRUE(view.view_from_link.isUnitary(1e-12));
  EXPECT_GT(view.view_from_link.determinant(), 0.0);
  EXPECT_LT(view.pixelOf({0, 0, 1}).y(), view.pixelOf({0, 0, 0}).y());  // rows run downwards
  EXPECT_DOUBLE_EQ(view.pixelOf({0, 0, 1}).x(), view.pixelOf({0, 0, 0}).x());
  EXPECT_GT(view.pixelOf({1, 0, 0}).z(), view.pixelOf({0, 0, 0}).z());  // the viewer is at +x
}

TEST(DrawShape, sphere_hasTheAreaAndDepthOfADisc) {
  const PosedShape ball{Sphere{0.25}, {Eigen::Matrix3d::Identity(), {1.0, 2.0, 3.0}}};
  const View view = viewOf({ball}, {}, 200, 200);
  DepthImage image(200, 200);
  drawShape(ball, view, 7, image);
  EXPECT_NEAR(static_cast<double>(seenOf(image, 7)), kPi * 90.0 * 90.0, 0.01 * kPi * 90.0 * 90.0);
  const double center = view.pixelOf(ball.geometry_from_body.translation).z();
  EXPECT_NEAR(image.depth[image.at(100, 100)], center + 0.25, 1e-3);
  EXPECT_GT(image.normal[image.at(100, 100)].z(), 0.999F);
  EXPECT_EQ(image.owner[image.at(0, 0)], DepthImage::kNobody);
}

/// Two ways to draw one thing agree: rays along the shape, and triangles of its surface.
TEST(DrawShape, andDrawMeshOfItsSurface_showTheSame) {
  const std::vector<Geometry> geometries{Box{{0.3, 0.1, 0.2}}, Capsule{0.3, 0.1}, Sphere{0.2}};
  test::Random random(5);
  for (const Geometry& geometry : geometries) {
    const Pose pose = test::randomPose(random, 1.0);
    CollisionElement element{"element", pose, geometry};
    Link link;
    link.collisions.push_back(element);
    PosedShape shape;
    shape.geometry_from_body = pose;
    if (const auto* box = std::get_if<Box>(&geometry)) {
      shape.shape = *box;
    } else if (const auto* capsule = std::get_if<Capsule>(&geometry)) {
      shape.shape = *capsule;
    } else {
      shape.shape = std::get<Sphere>(geometry);
    }
    const View view = viewOf({shape}, {}, 200, 150);
    DepthImage traced(200, 150);
    drawShape(shape, view, 0, traced);
    DepthImage meshed(200, 150);
    drawMesh(surfaceMeshOf(link, {0}), view, 0, meshed);
    int differing = 0;
    for (std::size_t i = 0; i < traced.owner.size(); ++i) {
      if (traced.owner[i] != meshed.owner[i]) {
        ++differing;
      } else if (traced.owner[i] == 0 && traced.normal[i].z() > 0.3F) {
        EXPECT_NEAR(traced.depth[i], meshed.depth[i], 2.0 / view.pixels_per_metre);
      }
    }
    EXPECT_LT(differing, static_cast<int>(seenOf(traced, 0) / 50)) << geometry.index();
  }
}

TEST(DrawMesh, nearerTriangleWins_whicheverWayItIsWound) {
  // Two triangles across the line of sight, drawn near first and far first.
  View view;
  view.width = view.height = 20;
  view.pixels_per_metre = 10.0;
  TriangleMesh far_one{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  TriangleMesh near_one{{{-1, -1, 0.5}, {1, -1, 0.5}, {0, 1, 0.5}}, {{0, 2, 1}}};
  for (const bool is_near_first : {true, false}) {
    DepthImage image(20, 20);
    drawMesh(is_near_first ? near_one : far_one, view, is_near_first ? 2 : 1, image);
    drawMesh(is_near_first ? far_one : near_one, view, is_near_first ? 1 : 2, image);
    EXPECT_EQ(image.owner[image.at(10, 10)], 2);
    EXPECT_DOUBLE_EQ(image.depth[image.at(10, 10)], 0.5);
    EXPECT_FLOAT_EQ(image.normal[image.at(10, 10)].z(), 1.0F);
    EXPECT_EQ(seenOf(image, 1), 0U);
  }
}

TEST(DrawMesh, beyondTheEdgeOfThePicture_isCut) {
  View view;
  view.width = view.height = 10;
  DepthImage image(10, 10);
  const TriangleMesh huge{{{-1e9, -1e9, 0}, {1e9, -1e9, 0}, {0, 1e9, 0}}, {{0, 1, 2}}};
  drawMesh(huge, view, 3, image);
  EXPECT_EQ(seenOf(image, 3), 100U);
}

TEST(Picture, ofACubeInALargerBall_isGreyInTintInWhite) {
  const Picture picture = pictureOf(test::boxMesh({0.1, 0.1, 0.1}), {{Sphere{0.5}, Pose()}});
  const auto pixelAt = [&](int column, int row) {
    const auto first = static_cast<std::ptrdiff_t>(3 * (row * picture.width + column));
    return std::vector<int>(picture.bytes.begin() + first, picture.bytes.begin() + first + 3);
  };
  const std::vector<int> cube = pixelAt(picture.width / 2, picture.height / 2);
  const std::vector<int> ball = pixelAt(picture.width / 2, picture.height / 4);
  const std::vector<int> outside = pixelAt(2, 2);
  EXPECT_EQ(outside, (std::vector<int>{255, 255, 255}));
  EXPECT_GT(ball[2], ball[0]);  // the first colour is blue
  EXPECT_GT(ball[2], cube[2]);
  EXPECT_EQ(picture.bytes.size(), static_cast<std::size_t>(3 * picture.width * picture.height));
}

TEST(EncodePng, startsAsAPngMust) {
  const std::string file = encodePng({2, 1, {255, 0, 0, 0, 0, 255}});
  EXPECT_EQ(file.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(file.substr(12, 4), "IHDR");
  EXPECT_EQ(file.substr(16, 8), std::string("\0\0\0\2\0\0\0\1", 8));  // width, height
}

}  // namespace
}  // namespace collision_monitor::fit_tool
