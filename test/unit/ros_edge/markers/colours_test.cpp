// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "ros_edge/markers/marker_shapes.h"

namespace collision_monitor::test {
namespace {

/// How colour-blind people see linear RGB. Source: Machado, Oliveira, Fernandes, "A physiologically
/// based model for simulation of color vision deficiency", IEEE TVCG 15 (2009), severity 1.
std::vector<Eigen::Matrix3d> eyes() {
  Eigen::Matrix3d protan, deutan, tritan;
  protan << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
      1.051998;
  deutan << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
      0.968881;
  tritan << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367,
      0.303900;
  return {Eigen::Matrix3d::Identity(), protan, deutan, tritan};
}

double linear(float part) {
  const auto value = static_cast<double>(part);
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// CIELAB (1976) of linear sRGB under daylight D65.
Eigen::Vector3d labOf(const Eigen::Vector3d& rgb) {
  Eigen::Matrix3d xyz_from_rgb;
  xyz_from_rgb << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
  const Eigen::Vector3d white(0.9505, 1.0, 1.089);
  Eigen::Vector3d f =
      (xyz_from_rgb * rgb.cwiseMax(0.0).cwiseMin(1.0)).cwiseQuotient(white).unaryExpr([](double t) {
        return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0;
      });
  return {116.0 * f.y() - 16.0, 500.0 * (f.x() - f.y()), 200.0 * (f.y() - f.z())};
}

/// 2.3 is just noticeable. Pure red and green are 10 apart for the commonest colour-blindness.
TEST(ColoursOfVerdicts, anyTwo_areFarApartForEverybody) {
  const std::vector<Verdict> verdicts{Verdict::clear, Verdict::warning, Verdict::unknown,
                                      Verdict::contact};
  for (const Eigen::Matrix3d& eye : eyes()) {
    std::vector<Eigen::Vector3d> seen;
    for (const Verdict verdict : verdicts) {
      const std_msgs::ColorRGBA colour = colourOf(verdict, 1.0F);
      seen.push_back(
          labOf(eye * Eigen::Vector3d(linear(colour.r), linear(colour.g), linear(colour.b))));
    }
    for (std::size_t i = 0; i < seen.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_GT((seen[i] - seen[k]).norm(), 30.0) << i << ' ' << k << '\n' << eye;
      }
    }
  }
}

}  // namespace
}  // namespace collision_monitor::test
