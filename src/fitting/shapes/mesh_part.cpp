// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fitting/shapes/mesh_part.h"

#include <algorithm>
#include <numeric>

#include "geometry/constants.h"

namespace collision_monitor {
namespace {

using Eigen::Vector3d;

/// The point of the edge on the plane. Always computed from the lower end, so both polygons of an
/// edge get the same point.
Vector3d crossing(const Vector3d& below, const Vector3d& above, const CutPlane& plane) {
  const double low = plane.heightOf(below);
  const double t = std::clamp(low / (low - plane.heightOf(above)), 0.0, 1.0);
  return below + t * (above - below);
}

void addPolygon(const Points& corners, MeshPart& part) {
  part.corners.insert(part.corners.end(), corners.begin(), corners.end());
  part.end.push_back(static_cast<std::uint32_t>(part.corners.size()));
}

/// Cuts one convex polygon: Sutherland, Hodgman, "Reentrant Polygon Clipping" (1974), for both
/// sides at once.
class PolygonCutter {
 public:
  PolygonCutter(const CutPlane& plane, MeshPart& below, MeshPart& above)
      : plane_(plane), below_(below), above_(above) {}

  void cut(const Vector3d* corners, std::size_t count) {
    low_.clear();
    high_.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const Vector3d& corner = corners[i];
      const Vector3d& next = corners[(i + 1) % count];
      const double height = plane_.heightOf(corner);
      const double next_height = plane_.heightOf(next);
      if (height <= 0.0) {
        low_.push_back(corner);
      }
      if (height >= 0.0) {
        high_.push_back(corner);
      }
      if ((height < 0.0 && next_height > 0.0) || (height > 0.0 && next_height < 0.0)) {
        low_.push_back(height < 0.0 ? crossing(corner, next, plane_)
                                    : crossing(next, corner, plane_));
        high_.push_back(low_.back());
      }
    }
    addPolygon(low_, below_);
    addPolygon(high_, above_);
  }

 private:
  CutPlane plane_;
  MeshPart& below_;
  MeshPart& above_;
  Points low_;
  Points high_;
};

}  // namespace

PartedSurface::PartedSurface(const TriangleMesh& mesh)
    : vertices_(mesh.vertices), triangles_(mesh.triangles), seen_(mesh.vertices.size(), 0) {
  double extent = 0.0;
  for (const auto& triangle : triangles_) {
    for (const auto corner : triangle) {
      seen_[corner] = 1;
    }
  }
  for (std::uint32_t i = 0; i < vertices_.size(); ++i) {
    extent = std::max(extent, vertices_[i].cwiseAbs().maxCoeff());
    if (seen_[i] == 0) {
      triangles_.push_back({i, i, i});
    }
  }
  calls_ = 1;
  // For any computed t between 0 and 1, the crossing errs in each coordinate by less than 5 u of
  // the larger end.
  cut_error_ = 32.0 * kUnitRoundOff * extent;
}

MeshPart PartedSurface::whole() const {
  MeshPart part;
  part.triangles.resize(triangles_.size());
  std::iota(part.triangles.begin(), part.triangles.end(), 0u);
  return part;
}

Points PartedSurface::cornersOf(const MeshPart& part) {
  ++calls_;
  Points points = part.corners;
  for (const auto triangle : part.triangles) {
    for (const auto corner : triangles_[triangle]) {
      if (seen_[corner] != calls_) {
        seen_[corner] = calls_;
        points.push_back(vertices_[corner]);
      }
    }
  }
  return points;
}

void PartedSurface::split(const MeshPart& part, const CutPlane& plane, MeshPart& below,
                          MeshPart& above) const {
  PolygonCutter cutter(plane, below, above);
  const auto sort = [&](const Vector3d* corners, std::size_t count) {
    double low = plane.heightOf(corners[0]);
    double high = low;
    for (std::size_t i = 1; i < count; ++i) {
      const double height = plane.heightOf(corners[i]);
      low = std::min(low, height);
      high = std::max(high, height);
    }
    return high <= 0.0 ? -1 : (low >= 0.0 ? 1 : 0);
  };
  for (const auto triangle : part.triangles) {
    const auto& t = triangles_[triangle];
    const Vector3d corners[3] = {vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]};
    const int side = sort(corners, 3);
    if (side == 0) {
      cutter.cut(corners, 3);
    } else {
      (side < 0 ? below : above).triangles.push_back(triangle);
    }
  }
  std::size_t first = 0;
  for (const auto end : part.end) {
    const Vector3d* corners = part.corners.data() + first;
    const int side = sort(corners, end - first);
    if (side == 0) {
      cutter.cut(corners, end - first);
    } else {
      addPolygon(Points(corners, corners + (end - first)), side < 0 ? below : above);
    }
    first = end;
  }
}

}  // namespace collision_monitor
