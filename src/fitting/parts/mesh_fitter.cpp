// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/parts/mesh_fitter.h"

#include <algorithm>

#include "fitting/parts/cut_and_join.h"
#include "fitting/proofs/proof.h"
#include "fitting/proofs/union_overshoot.h"
#include "fitting/search/point_cloud.h"
#include "fitting/shapes/candidate.h"
#include "geometry/interruption.h"

namespace collision_monitor {
namespace {

constexpr int kRepresentatives = 120;  // of a part's corners, during a search
constexpr double kHopeful = 1.5;       // a search rarely saves more than a third
constexpr OvershootSampling kSampling{600, 0.01};

Points representing(const Points& corners) {
  return corners.size() <= kRepresentatives
             ? corners
             : extremePoints(corners, spreadDirections(kRepresentatives));
}

}  // namespace

MeshFitter::MeshFitter(const TriangleMesh& mesh, const ShapeKinds& kinds)
    : kinds_(kinds), bvh_(mesh), surface_(mesh), grid_(mesh) {
  start(chooseTightest(encloseMesh(mesh, bvh_, grid_, kinds), kinds));
}

MeshFitter::MeshFitter(const TriangleMesh& mesh, const Enclosure& whole, const ShapeKinds& kinds)
    : kinds_(kinds), bvh_(mesh), surface_(mesh), grid_(mesh) {
  start(whole);
}

MeshFitter::Part MeshFitter::wholePart() const {
  Part part;
  part.surface = surface_.whole();
  part.samples = grid_.surface();
  return part;
}

void MeshFitter::start(const Enclosure& whole) {
  parts_.push_back(wholePart());
  parts_.back().enclosure = whole;
  size_ = 2.0 * boxAround(Eigen::Matrix3d::Identity(), parts_.back().samples).half_extents.norm();
  best_.shapes.push_back(whole);
  best_.overshoot = whole.overshoot;
}

std::size_t MeshFitter::worstPart() const noexcept {
  const auto rank = [](const Part& part) {
    return part.can_be_cut ? part.enclosure.overshoot.max : -1.0;
  };
  const auto worst =
      std::max_element(parts_.begin(), parts_.end(),
                       [&](const Part& a, const Part& b) { return rank(a) < rank(b); });
  return static_cast<std::size_t>(worst - parts_.begin());
}

double MeshFitter::worstOvershoot() const noexcept {
  const Part& part = parts_[worstPart()];
  return part.can_be_cut ? part.enclosure.overshoot.max : 0.0;
}

RoughGoal MeshFitter::goalBeside(std::size_t part) const {
  RoughGoal goal{grid_, kinds_, {}, {}};
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (i != part) {
      goal.others.push_back(coreOf(posedShapeOf(parts_[i].enclosure)));
    }
  }
  return goal;
}

void MeshFitter::encloseAs(const RoughFit& rough, Part& part) const {
  PosedShape fit = placedShape(rough);
  fit.shape = grown(fit.shape, std::max(excessOver(fit, part.corners), 0.0));
  part.enclosure = Enclosure{};
  part.enclosure.widening = widenUntilProven(part.corners, fit, part.slack);
  part.enclosure.shape = fit.shape;
  part.enclosure.geometry_from_body = fit.geometry_from_body;
  part.measured.clear();
}

/// Fits a part again beside its neighbours' shapes: points inside these no longer count.
void MeshFitter::refit(std::size_t i) {
  throwIfInterrupted();
  Part& part = parts_[i];
  const Points points = representing(part.corners);
  const RoughGoal goal = goalBeside(i);
  RoughFit now{coreOf(posedShapeOf(part.enclosure)), part.enclosure.shape.index()};
  now = polished(now, points, goal);
  RoughFit other = fitRoughly(
      points, {now.core.rotation, principalAxes(points), Eigen::Matrix3d::Identity()}, goal);
  if (other.cost < kHopeful * now.cost) {
    other = polished(other, points, goal);
  }
  encloseAs(other.cost < now.cost ? other : now, part);
}

void MeshFitter::measureParts() {
  Fit fit;
  fit.cuts = cuts_;
  fit.shape_of = shape_of_;
  std::vector<PosedShape> shapes;
  for (const auto& part : parts_) {
    shapes.push_back(posedShapeOf(part.enclosure));
  }
  OvershootSum sum;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (parts_[i].measured.empty()) {
      parts_[i].measured = measureSamples(shapes[i], bvh_, &grid_, kSampling);
    }
    const OvershootSum part = sumOutsideOthers(parts_[i].measured, i, shapes);
    parts_[i].enclosure.overshoot = part.total();
    fit.shapes.push_back(parts_[i].enclosure);
    sum.add(part);
  }
  fit.overshoot = sum.total();
  if (costOf(fit.overshoot) < costOf(best_.overshoot)) {
    best_ = std::move(fit);
  }
}

void MeshFitter::cutWorst() {
  const std::size_t worst = worstPart();
  const auto cut = chooseCut(parts_[worst].samples, coreOf(posedShapeOf(parts_[worst].enclosure)),
                             goalBeside(worst));
  if (!cut || !divide(worst, cut->plane)) {
    parts_[worst].can_be_cut = false;
    return;
  }
  has_idle_cut_ = has_idle_cut_ || cut->is_idle;
  const std::size_t next = parts_.size() - 1;
  encloseAs(cut->below, parts_[worst]);
  encloseAs(cut->above, parts_[next]);
  refit(worst);
  refit(next);
  measureParts();
}

bool MeshFitter::isCoarse() const noexcept {
  constexpr double kFar = 0.1;
  return has_idle_cut_ || best_.overshoot.max > kFar * size_;
}

void MeshFitter::cutAndJoin(std::size_t most_shapes, double target) {
  const CutPlan plan = planCuts(grid_, most_shapes, target);
  if (plan.cuts.empty()) {
    return;  // the whole has its shape
  }
  parts_.clear();
  parts_.push_back(wholePart());
  cuts_.clear();
  for (const PartCut& cut : plan.cuts) {
    if (!divide(cut.part, {cut.normal, cut.offset})) {
      return;
    }
  }
  std::vector<Part> joined(plan.shapes);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    Part& shape = joined[plan.shape_of[i]];
    shape.corners.insert(shape.corners.end(), parts_[i].corners.begin(), parts_[i].corners.end());
    shape.slack = std::max(shape.slack, parts_[i].slack);
  }
  parts_ = std::move(joined);
  shape_of_ = plan.shape_of;
  for (Part& part : parts_) {
    const Points points = representing(part.corners);
    encloseAs(fitRoughly(points, {principalAxes(points), Eigen::Matrix3d::Identity()},
                         RoughGoal{grid_, kinds_, {}, {}}),
              part);
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    refit(i);
  }
  measureParts();
}

/// Cuts the surface of a part. Both pieces still lack shapes. Returns false and changes nothing if
/// rounding leaves one side empty.
bool MeshFitter::divide(std::size_t i, const CutPlane& plane) {
  Part below;
  Part above;
  surface_.split(parts_[i].surface, plane, below.surface, above.surface);
  for (const auto& sample : parts_[i].samples) {
    (plane.heightOf(sample) <= 0.0 ? below : above).samples.push_back(sample);
  }
  below.corners = surface_.cornersOf(below.surface);
  above.corners = surface_.cornersOf(above.surface);
  if (below.corners.empty() || above.corners.empty()) {
    return false;
  }
  below.slack = parts_[i].slack + surface_.cutError();
  above.slack = below.slack;
  parts_[i] = std::move(below);
  parts_.push_back(std::move(above));
  cuts_.push_back({static_cast<std::uint32_t>(i), plane.normal, plane.offset});
  return true;
}

}  // namespace collision_monitor
