// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "write_html.h"

#include <array>

#include "geometry/bvh/visit_held.h"
#include "outputs/markup_text.h"
#include "picture.h"
#include "surface_mesh.h"
#include "table.h"

namespace collision_monitor::fit_tool {
namespace {

const char* const kStyle =
    "body { font-family: sans-serif; margin: 2em; color: #222; }\n"
    "section { display: flex; flex-wrap: wrap; gap: 1.5em; border-top: 1px solid #ccc; "
    "padding: 1em 0; }\n"
    "h2 { width: 100%; margin: 0; font-size: 1.1em; }\n"
    "table { border-collapse: collapse; margin-bottom: 1em; font-size: 0.9em; }\n"
    "th, td { text-align: left; padding: 0.15em 0.7em; border-bottom: 1px solid #eee; }\n"
    "figure { margin: 0; } figcaption { font-size: 0.8em; color: #666; }\n"
    ".swatch { display: inline-block; width: 0.9em; height: 0.9em; }\n"
    ".bad { color: #b00; font-weight: bold; }\n";

const char* const kHowDrawn =
    "How the pictures are drawn: without perspective, seen from +x, -y and above in the frame of "
    "the link (z up), each to its own scale. Grey is the collision geometry. The tint and the "
    "lines are the outer surface of the shapes; lines run along rims, where shapes meet, and "
    "along edges. What is tinted but not grey is overshoot. Padding is not drawn.";

const char* const kHowMeasured =
    "Overshoot: how far the surface of the shapes is from the geometry; a distance between "
    "shapes is too short by no more than the overshoot of both. Volume: of the shapes, over the "
    "convex hull's. Inner radius: of the largest sphere found inside the geometry; a dash means "
    "that there is none, because a mesh is open or flat. Whatever overlaps what is called inside "
    "overlaps the link. Proven: that the shapes enclose the geometry, rounding included.";

std::string cell(const std::string& text) { return "<td>" + escaped(text) + "</td>"; }

std::string inMillimetres(const Eigen::Vector3d& values, const char* between) {
  return fixed(1e3 * values.x(), 1) + between + fixed(1e3 * values.y(), 1) + between +
         fixed(1e3 * values.z(), 1);
}

struct Dimensions {
  std::string operator()(const Sphere& s) const { return "radius " + fixed(1e3 * s.radius, 1); }
  std::string operator()(const Capsule& s) const {
    return "radius " + fixed(1e3 * s.radius, 1) + ", between centers of caps " +
           fixed(2e3 * s.half_length, 1);
  }
  std::string operator()(const Box& s) const { return inMillimetres(2.0 * s.half_extents, " x "); }
  std::string operator()(const RoundedBox& s) const {
    return inMillimetres(2.0 * s.half_extents, " x ") + ", rounded by " + fixed(1e3 * s.radius, 1);
  }
};

std::string swatchOf(int shape) {
  const Eigen::Array3f colour = 255.0F * colourOf(shape);
  std::string text = "<span class=\"swatch\" style=\"background: rgb(";
  for (Eigen::Index i = 0; i < 3; ++i) {
    text += std::to_string(static_cast<int>(colour[i])) + (i < 2 ? ", " : "");
  }
  return text + ")\"></span> ";
}

std::string figuresOf(const FittedLink& link) {
  std::string text =
      "<table><tr><th>collision</th><th>triangles</th><th>shapes</th><th>volume / "
      "hull</th><th>overshoot max [mm]</th><th>mean [mm]</th><th>inner radius [mm]</th>"
      "<th>proof</th></tr>\n";
  for (const FittedPart& part : link.parts) {
    const PartText own = textOf(part);
    text += "<tr>" + cell(part.name) + cell(own.triangles) + cell(own.shapes) +
            cell(own.volume_ratio) + cell(own.overshoot_max) + cell(own.overshoot_mean) +
            cell(own.inner_radius) +
            (part.figures.is_proven ? cell(own.proof)
                                    : "<td class=\"bad\">" + escaped(own.proof) + "</td>") +
            "</tr>\n";
  }
  return text + "</table>\n";
}

std::string shapeRow(const std::string& name, const PosedShape& shape) {
  return "<tr><td>" + name + "</td>" + cell(visitHeld(Dimensions(), shape.shape)) +
         cell(inMillimetres(shape.geometry_from_body.translation, ", ")) + "</tr>\n";
}

std::string shapesOf(const FittedLink& link) {
  std::string text =
      "<table><tr><th>shape</th><th>size [mm]</th><th>center in the link [mm]</th></tr>\n";
  int number = 0;
  for (const FittedPart& part : link.parts) {
    for (const PosedShape& shape : part.shapes) {
      text += shapeRow(swatchOf(number++) + kindName(shape.shape), shape);
    }
    for (const std::optional<PosedShape>* inner : {&part.inner.sphere, &part.inner.capsule}) {
      if (*inner) {
        text +=
            shapeRow("inside " + escaped(part.name) + ": " + kindName((*inner)->shape), **inner);
      }
    }
  }
  return text + "</table>\n";
}

std::string sectionOf(const Link& link, const FittedLink& fitted) {
  std::vector<std::size_t> elements;
  std::vector<PosedShape> shapes;
  for (const FittedPart& part : fitted.parts) {
    elements.insert(elements.end(), part.elements.begin(), part.elements.end());
    shapes.insert(shapes.end(), part.shapes.begin(), part.shapes.end());
  }
  const Picture picture = pictureOf(surfaceMeshOf(link, elements), shapes);
  std::string text = "<section><h2>" + escaped(link.name) + "</h2>\n<figure><img width=\"" +
                     std::to_string(picture.width) + "\" height=\"" +
                     std::to_string(picture.height) + "\" alt=\"" +
                     escaped("the geometry of " + link.name + " and its shapes") +
                     "\" src=\"data:image/png;base64," + base64Of(encodePng(picture)) + "\"/>\n";
  text += "<figcaption>" + std::string(nameOf(fitted.source)) + " in " +
          fixed(1e3 * fitted.seconds, 1) + " ms";
  if (fitted.padding > 0.0) {
    text += "; the monitor adds a padding of " + fixed(1e3 * fitted.padding, 1) + " mm";
  }
  return text + "</figcaption></figure>\n<div>" + figuresOf(fitted) + shapesOf(fitted) +
         "</div></section>\n";
}

}  // namespace

std::string writeHtml(const FittedRobot& robot, const std::string& source,
                      const FitProgress& progress) {
  const std::string title = escaped("Shapes of " + source);
  std::string page = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><title>" +
                     title + "</title>\n<style>\n" + kStyle + "</style></head>\n<body><h1>" +
                     title + "</h1>\n<p>" + escaped(sentenceOf(totalsOf(robot))) + ".</p>\n<p>" +
                     kHowDrawn + "</p>\n<p>" + kHowMeasured + "</p>\n";
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const Link& link = robot.model.link(robot.links[i].link);
    if (progress) {
      progress(link.name, i, robot.links.size());
    }
    page += sectionOf(link, robot.links[i]);
  }
  if (progress) {
    progress("", robot.links.size(), robot.links.size());
  }
  return page + "</body></html>\n";
}

}  // namespace collision_monitor::fit_tool
