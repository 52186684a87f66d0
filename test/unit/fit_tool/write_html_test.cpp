// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/write_html.h"

#include <gtest/gtest.h>

#include "progress.h"
#include "support/robots/file_loader.h"
#include "table.h"

namespace collision_monitor::fit_tool {
namespace {

TEST(Fixed, roundsInEveryLocale) {
  EXPECT_EQ(fixed(1234.5678, 2), "1234.57");
  EXPECT_EQ(fixed(-0.04, 1), "-0.0");
  EXPECT_EQ(fixed(1e20, 0), "100000000000000000000");
}

FittedPart boxPart() {
  FittedPart part;
  part.name = "collision_0";
  part.elements = {0};
  part.shapes = {{Box(), Pose()}, {Capsule(), Pose()}, {Box(), Pose()}};
  part.figures.triangles = 12;
  part.figures.hull_volume = 2.0;
  part.figures.shape_volume = 2.5;
  part.figures.overshoot = {0.0123, 0.004, 0.005};
  part.inner.sphere = PosedShape{Sphere{0.02}, Pose()};
  part.figures.is_proven = true;
  return part;
}

TEST(PartText, saysWhatTheFiguresSay) {
  const PartText text = textOf(boxPart());
  EXPECT_EQ(text.shapes, "1 capsule, 2 box");
  EXPECT_EQ(text.triangles, "12");
  EXPECT_EQ(text.volume_ratio, "1.25");
  EXPECT_EQ(text.overshoot_max, "12.3");
  EXPECT_EQ(text.overshoot_mean, "4.0");
  EXPECT_EQ(text.inner_radius, "20.0");
  EXPECT_EQ(text.proof, "proven");
}

TEST(PartText, unknownIsADash_andUnprovenIsLoud) {
  FittedPart part = boxPart();
  part.elements.clear();
  part.figures = Figures();
  part.inner = InnerShapes();
  PartText text = textOf(part);
  EXPECT_EQ(text.triangles + text.volume_ratio + text.overshoot_max + text.inner_radius, "----");
  EXPECT_EQ(text.proof, "NOT PROVEN");
  part.figures.is_proven = true;
  part.figures.widening = 2e-6;
  text = textOf(part);
  EXPECT_EQ(text.proof, "proven, +0.002000 mm");
}

FittedRobot oneLink(const std::string& name) {
  FittedRobot robot;
  robot.model.links.resize(1);
  robot.model.links[0].name = name;
  robot.model.links[0].collisions.push_back({"collision_0", Pose(), Box{{0.1, 0.1, 0.1}}});
  robot.links.push_back({LinkId{0}, FitSource::fitted, 0.0126, 0.005, {boxPart()}});
  return robot;
}

TEST(Table, columnsStandBelowEachOther) {
  const std::string table = tableOf(oneLink("a_very_long_name"));
  std::vector<std::string> lines;
  for (std::size_t start = 0; start < table.size(); start = table.find('\n', start) + 1) {
    lines.push_back(table.substr(start, table.find('\n', start) - start));
  }
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0].find("collision"), lines[2].find("collision_0"));
  EXPECT_EQ(lines[0].find("shapes"), lines[2].find("1 capsule"));
  const auto endOf = [](const std::string& line, const std::string& word) {
    return line.find(word) + word.size();
  };
  EXPECT_EQ(endOf(lines[0], "overshoot max"), endOf(lines[2], "12.3"));
  EXPECT_EQ(endOf(lines[0], "time"), endOf(lines[2], "12.6"));
  EXPECT_EQ(lines[3],
            "1 link, 12 triangles, 3 shapes, volume 1.25 of the hulls, largest overshoot 12.3 mm "
            "(a_very_long_name, collision_0), 13 ms; all proven to enclose");
}

TEST(Totals, whatIsNotProvenIsCounted) {
  FittedRobot robot = oneLink("a");
  robot.links[0].parts.push_back(boxPart());
  robot.links[0].parts[1].figures.is_proven = false;
  EXPECT_NE(sentenceOf(totalsOf(robot)).find("1 of 2 NOT PROVEN"), std::string::npos);
}

TEST(Html, namesAreEscaped_andEveryLinkHasAPicture) {
  std::vector<std::size_t> steps;
  const std::string page =
      writeHtml(oneLink("<hand>"), "a&b.urdf",
                [&](const std::string&, std::size_t done, std::size_t) { steps.push_back(done); });
  EXPECT_EQ(page.find("<hand>"), std::string::npos);
  EXPECT_NE(page.find("<h2>&lt;hand&gt;</h2>"), std::string::npos);
  EXPECT_NE(page.find("Shapes of a&amp;b.urdf"), std::string::npos);
  EXPECT_NE(page.find("src=\"data:image/png;base64,iVBORw0KGgo"), std::string::npos);
  EXPECT_NE(page.find("padding of 5.0 mm"), std::string::npos);
  EXPECT_NE(page.find("<td>inside collision_0: sphere</td><td>radius 20.0</td>"),
            std::string::npos);
  EXPECT_EQ(steps, (std::vector<std::size_t>{0, 1}));
}

TEST(Bar, growsToItsLength) {
  EXPECT_EQ(barOf("fitting hand", 1, 10), "[===---------------------------]  1/10 fitting hand");
  EXPECT_EQ(barOf("x", 0, 0), "[==============================] 0/0 x");
}

}  // namespace
}  // namespace collision_monitor::fit_tool
