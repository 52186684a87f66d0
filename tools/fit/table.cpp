// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace collision_monitor::fit_tool {
namespace {

constexpr std::size_t kColumns = 12;
using Row = std::array<std::string, kColumns>;

const Row kHeader{"link",    "collision",     "triangles",      "shapes",
                  "volume",  "overshoot max", "overshoot mean", "inner radius",
                  "padding", "time",          "from",           "proof"};
const Row kUnits{"", "", "", "", "/ hull", "mm", "mm", "mm", "mm", "ms", "", ""};
constexpr std::array<bool, kColumns> kIsNumber{false, false, true, false, true,  true,
                                               true,  true,  true, true,  false, false};

std::string inMillimetres(double value) { return std::isnan(value) ? "-" : fixed(1e3 * value, 1); }

/// In the order of Shape's alternatives.
std::string kindsOf(const std::vector<PosedShape>& shapes) {
  std::string text;
  for (std::size_t kind = 0; kind < std::variant_size_v<Shape>; ++kind) {
    const auto is_kind = [&](const PosedShape& shape) { return shape.shape.index() == kind; };
    const auto first = std::find_if(shapes.begin(), shapes.end(), is_kind);
    if (first != shapes.end()) {
      text += (text.empty() ? "" : ", ") +
              std::to_string(std::count_if(shapes.begin(), shapes.end(), is_kind)) + " " +
              kindName(first->shape);
    }
  }
  return text;
}

std::string proofOf(const Figures& figures) {
  constexpr double kWorthSaying = 1e-9;  // [m] less is rounding
  if (!figures.is_proven) {
    return "NOT PROVEN";
  }
  return figures.widening < kWorthSaying ? "proven"
                                         : "proven, +" + fixed(1e3 * figures.widening, 6) + " mm";
}

Row rowOf(const FittedRobot& robot, const FittedLink& link, const FittedPart& part) {
  const PartText text = textOf(part);
  const bool is_first = &part == &link.parts.front();
  return {robot.model.link(link.link).name,
          part.name,
          text.triangles,
          text.shapes,
          text.volume_ratio,
          text.overshoot_max,
          text.overshoot_mean,
          text.inner_radius,
          fixed(1e3 * link.padding, 1),
          is_first ? fixed(1e3 * link.seconds, 1) : "",
          is_first ? nameOf(link.source) : "",
          text.proof};
}

std::string counted(std::size_t count, const char* thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

/// Number of characters, not bytes, in UTF-8.
std::size_t lengthOf(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
  }));
}

std::string lineOf(const Row& row, const std::array<std::size_t, kColumns>& widths) {
  std::string line;
  for (std::size_t i = 0; i < kColumns; ++i) {
    const std::string gap(widths[i] - lengthOf(row[i]), ' ');
    line += kIsNumber[i] ? gap + row[i] : row[i] + gap;
    line += "  ";
  }
  return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

}  // namespace

std::string fixed(double value, int decimals) {
  std::array<char, 400> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value,
                                     std::chars_format::fixed, decimals)
                           .ptr};
}

PartText textOf(const FittedPart& part) {
  const Figures& figures = part.figures;
  PartText text;
  text.shapes = kindsOf(part.shapes);
  text.triangles = figures.triangles == 0 ? "-" : std::to_string(figures.triangles);
  text.volume_ratio =
      figures.hull_volume > 0.0 ? fixed(figures.shape_volume / figures.hull_volume, 2) : "-";
  const bool is_measured = !part.elements.empty();
  text.overshoot_max = is_measured ? inMillimetres(figures.overshoot.max) : "-";
  text.overshoot_mean = is_measured ? inMillimetres(figures.overshoot.mean) : "-";
  text.inner_radius = part.inner.sphere ? inMillimetres(radiusOf(part.inner.sphere->shape)) : "-";
  text.proof = proofOf(figures);
  return text;
}

Totals totalsOf(const FittedRobot& robot) {
  Totals totals;
  totals.links = robot.links.size();
  for (const FittedLink& link : robot.links) {
    totals.seconds += link.seconds;
    for (const FittedPart& part : link.parts) {
      totals.parts += 1;
      totals.triangles += part.figures.triangles;
      totals.shapes += part.shapes.size();
      totals.unproven += part.figures.is_proven ? 0 : 1;
      totals.hull_volume += part.figures.hull_volume;
      totals.shape_volume += part.figures.shape_volume;
      if (part.figures.overshoot.max > totals.worst_overshoot) {
        totals.worst_overshoot = part.figures.overshoot.max;
        totals.worst = robot.model.link(link.link).name + ", " + part.name;
      }
    }
  }
  return totals;
}

std::string sentenceOf(const Totals& totals) {
  std::string text = counted(totals.links, "link") + ", " + counted(totals.triangles, "triangle") +
                     ", " + counted(totals.shapes, "shape");
  if (totals.hull_volume > 0.0) {
    text += ", volume " + fixed(totals.shape_volume / totals.hull_volume, 2) + " of the hulls";
  }
  if (!totals.worst.empty()) {
    text += ", largest overshoot " + inMillimetres(totals.worst_overshoot) + " mm (" +
            totals.worst + ")";
  }
  text += ", " + fixed(1e3 * totals.seconds, 0) + " ms; ";
  return text + (totals.unproven == 0
                     ? "all proven to enclose"
                     : std::to_string(totals.unproven) + " of " + std::to_string(totals.parts) +
                           " NOT PROVEN to enclose");
}

std::string tableOf(const FittedRobot& robot) {
  std::vector<Row> rows{kHeader, kUnits};
  for (const FittedLink& link : robot.links) {
    for (const FittedPart& part : link.parts) {
      rows.push_back(rowOf(robot, link, part));
    }
  }
  std::array<std::size_t, kColumns> widths{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < kColumns; ++i) {
      widths[i] = std::max(widths[i], lengthOf(row[i]));
    }
  }
  std::string text;
  for (const Row& row : rows) {
    text += lineOf(row, widths);
  }
  return text + sentenceOf(totalsOf(robot)) + "\n";
}

}  // namespace collision_monitor::fit_tool
