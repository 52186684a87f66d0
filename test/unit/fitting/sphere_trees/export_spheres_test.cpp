// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/sphere_trees/export_spheres.h"

#include <gtest/gtest.h>

#include <clocale>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace collision_monitor {
namespace {

SphereTree twoLevels() {
  SphereTree tree;
  tree.nodes.push_back({{0, 0, 1e-5}, 2.0, 0.0, 1, 2, 0});
  tree.nodes.push_back({{-1, 0, 0}, 1.25, 0.0, 0, 0, 1});
  tree.nodes.push_back({{1, 0.5, 0}, 1.5, 0.0, 0, 0, 1});
  return tree;
}

SphereTree oneSphere(const Eigen::Vector3d& center, double radius) {
  return {{SphereNode{center, radius, 0.0, 0, 0, 0}}};
}

TEST(ExportSpheres, srdf_isWhatSrdfdomReads) {
  EXPECT_EQ(toSrdf({{"arm", {twoLevels()}}}, 1),
            "<link_sphere_approximation link=\"arm\">\n"
            "  <sphere center=\"-1.0 0.0 0.0\" radius=\"1.25000001\"/>\n"
            "  <sphere center=\"1.0 0.5 0.0\" radius=\"1.50000001\"/>\n"
            "</link_sphere_approximation>\n");
}

TEST(ExportSpheres, yaml_hasEveryLevel_andNumbersThatYamlTakesForNumbers) {
  EXPECT_EQ(toYaml({{"arm", {twoLevels()}}}),
            "links:\n"
            "  - link: \"arm\"\n"
            "    levels:\n"
            "      - level: 0\n"
            "        spheres:\n"
            "          - {center: [0.0, 0.0, 1.0e-05], radius: 2.00000001}\n"
            "      - level: 1\n"
            "        spheres:\n"
            "          - {center: [-1.0, 0.0, 0.0], radius: 1.25000001}\n"
            "          - {center: [1.0, 0.5, 0.0], radius: 1.50000001}\n");
}

TEST(ExportSpheres, severalGeometries_standTogether_theShallowOneAtEveryLevel) {
  const std::string srdf = toSrdf({{"arm", {twoLevels(), oneSphere({5, 5, 5}, 0.5)}}}, 1);
  EXPECT_NE(srdf.find("-1.0 0.0 0.0"), std::string::npos);
  EXPECT_NE(srdf.find("5.0 5.0 5.0"), std::string::npos);
}

TEST(ExportSpheres, roundedSphere_holdsTheOneItWas) {
  const Eigen::Vector3d center(1.0 / 3.0, -2.0 / 7.0, 1e3 / 9.0);
  const double radius = 0.1234567890123;
  std::string srdf = toSrdf({{"arm", {oneSphere(center, radius)}}}, 0);
  for (char& c : srdf) {
    c = c == '"' ? ' ' : c;
  }
  std::istringstream text(srdf.substr(srdf.find("center=") + 7));
  Eigen::Vector3d read;
  std::string word;
  double read_radius = 0.0;
  text >> read.x() >> read.y() >> read.z() >> word >> read_radius;
  ASSERT_TRUE(text) << srdf;
  EXPECT_GT((read - center).norm(), 0.0);
  EXPECT_GE(read_radius, radius + (read - center).norm());
  EXPECT_LT(read_radius, radius + 1e-6);
}

TEST(ExportSpheres, sphereWithoutRadius_isNotTakenForNone) {
  const std::string srdf = toSrdf({{"tip", {oneSphere({1, 2, 3}, 0.0)}}}, 0);
  EXPECT_NE(srdf.find("radius=\"1.0e-12\""), std::string::npos) << srdf;
}

TEST(ExportSpheres, names_areQuoted) {
  const std::vector<LinkSpheres> links{{"a\"b\\c<d>&e", {oneSphere({0, 0, 0}, 1.0)}}};
  EXPECT_NE(toYaml(links).find("link: \"a\\\"b\\\\c<d>&e\"\n"), std::string::npos);
  EXPECT_NE(toSrdf(links, 0).find("link=\"a&quot;b\\c&lt;d>&amp;e\">"), std::string::npos);
}

TEST(ExportSpheres, linksWithoutSpheres_areLeftOut) {
  EXPECT_EQ(toSrdf({{"arm", {}}, {"hand", {SphereTree{}}}}, 0), "");
  EXPECT_EQ(toYaml({{"arm", {}}}), "links: []\n");
  EXPECT_EQ(toYaml({}), "links: []\n");
}

TEST(ExportSpheres, theLocale_doesNotMatter) {
  const std::string before = toYaml({{"arm", {twoLevels()}}});
  const char* set = std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
  const std::string after = toYaml({{"arm", {twoLevels()}}});
  std::setlocale(LC_NUMERIC, "C");
  if (set == nullptr) {
    GTEST_SKIP() << "no locale with a decimal comma on this machine";
  }
  EXPECT_EQ(before, after);
}

TEST(ExportSpheres, whatCannotBeWritten_isRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(toYaml({{"arm", {oneSphere({0, nan, 0}, 1.0)}}}), std::invalid_argument);
  EXPECT_THROW(toSrdf({{"arm", {oneSphere({0, 0, 0}, nan)}}}, 0), std::invalid_argument);
  EXPECT_THROW(toSrdf({{"", {oneSphere({0, 0, 0}, 1.0)}}}, 0), std::invalid_argument);
  EXPECT_THROW(toYaml({{"a\nb", {oneSphere({0, 0, 0}, 1.0)}}}), std::invalid_argument);
}

}  // namespace
}  // namespace collision_monitor
