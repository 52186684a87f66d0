// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "narrow_phase/epa/polytope.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>

namespace collision_monitor {
namespace {

using Face = ConvexWorkspace::Face;
using Index = std::uint16_t;

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr Index kNoFace = std::numeric_limits<Index>::max();

std::size_t next(std::size_t k) noexcept { return k == 2 ? 0 : k + 1; }

const Eigen::Vector3d& pointOf(const ConvexWorkspace& polytope, Index vertex) noexcept {
  return polytope.vertices[vertex].difference;
}

// Sets the plane of a face from its corners. A face without area takes its neighbor's normal,
// `fallback`, and is never refined.
void setPlane(Index index, const Eigen::Vector3d& fallback, ConvexWorkspace& polytope) noexcept {
  Face& face = polytope.faces[index];
  const Eigen::Vector3d& a = pointOf(polytope, face.corners[0]);
  const Eigen::Vector3d& b = pointOf(polytope, face.corners[1]);
  const Eigen::Vector3d& c = pointOf(polytope, face.corners[2]);
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double length = normal.norm();
  const bool has_area = length > 0.0;
  face.normal = has_area ? Eigen::Vector3d(1.0 / length * normal) : fallback;
  face.offset = face.normal.dot(a + b + c) / 3.0;
  face.is_visible = false;
  face.is_gone = false;
  polytope.keys[index] = has_area ? face.offset : kNever;
}

Index takeFace(ConvexWorkspace& polytope) noexcept {
  return polytope.free_count > 0 ? polytope.free_faces[--polytope.free_count]
                                 : static_cast<Index>(polytope.face_count++);
}

// Marks the faces that see the point, starting from `first`. Returns their number.
std::size_t floodVisible(const Eigen::Vector3d& point, Index first, double rounding,
                         ConvexWorkspace& polytope) noexcept {
  std::size_t count = 1;
  polytope.visible[0] = first;
  polytope.faces[first].is_visible = true;
  for (std::size_t at = 0; at < count; ++at) {
    for (const Index neighbour : polytope.faces[polytope.visible[at]].neighbours) {
      Face& face = polytope.faces[neighbour];
      if (!face.is_visible && face.normal.dot(point) - face.offset > rounding) {
        face.is_visible = true;
        polytope.visible[count++] = neighbour;
      }
    }
  }
  return count;
}

template <class Use>
void forEachOutlineEdge(const ConvexWorkspace& polytope, std::size_t visible_count,
                        const Use& use) noexcept {
  for (std::size_t at = 0; at < visible_count; ++at) {
    const Face& face = polytope.faces[polytope.visible[at]];
    for (std::size_t k = 0; k < 3; ++k) {
      if (!polytope.faces[face.neighbours[k]].is_visible) {
        use(face.corners[k], face.corners[next(k)], face.neighbours[k]);
      }
    }
  }
}

// Checks that the outline is one closed walk that passes each vertex once. Leaves in `face_from`
// the end of the edge that starts at a vertex. Returns the number of edges, 0 if the check fails.
std::size_t walkOutline(std::size_t visible_count, ConvexWorkspace& polytope) noexcept {
  auto& end_of = polytope.face_from;
  forEachOutlineEdge(polytope, visible_count,
                     [&](Index from, Index, Index) { end_of[from] = kNoFace; });
  std::size_t count = 0;
  bool is_simple = true;
  Index start = 0;
  forEachOutlineEdge(polytope, visible_count, [&](Index from, Index to, Index) {
    is_simple = is_simple && end_of[from] == kNoFace;
    end_of[from] = to;
    start = from;
    ++count;
  });
  if (!is_simple) {
    return 0;
  }
  std::size_t walked = 1;
  for (Index at = end_of[start]; at != start && walked <= count; at = end_of[at]) {
    ++walked;
  }
  return walked == count ? count : 0;
}

void forget(std::size_t visible_count, ConvexWorkspace& polytope) noexcept {
  for (std::size_t at = 0; at < visible_count; ++at) {
    polytope.faces[polytope.visible[at]].is_visible = false;
  }
}

void replaceNeighbour(Index face, Index from, Index to, Index neighbour,
                      ConvexWorkspace& polytope) noexcept {
  Face& outer = polytope.faces[face];
  for (std::size_t k = 0; k < 3; ++k) {
    if (outer.corners[k] == to && outer.corners[next(k)] == from) {
      outer.neighbours[k] = neighbour;
    }
  }
}

// Makes a fan from the outline to `apex`. `face_from` then has, for each vertex of the outline, the
// new face that starts there in place of the end of its edge.
void joinOutline(Index apex, std::size_t visible_count, ConvexWorkspace& polytope) noexcept {
  forEachOutlineEdge(polytope, visible_count, [&](Index from, Index to, Index outer) {
    const Index made = takeFace(polytope);
    polytope.faces[made].corners = {from, to, apex};
    polytope.faces[made].neighbours = {outer, kNoFace, kNoFace};
    setPlane(made, polytope.faces[outer].normal, polytope);
    replaceNeighbour(outer, from, to, made, polytope);
    polytope.face_from[from] = made;
  });
}

void closeFan(std::size_t visible_count, ConvexWorkspace& polytope) noexcept {
  forEachOutlineEdge(polytope, visible_count, [&](Index from, Index to, Index) {
    const Index made = polytope.face_from[from];
    const Index following = polytope.face_from[to];
    polytope.faces[made].neighbours[1] = following;
    polytope.faces[following].neighbours[2] = made;
  });
}

void dropVisible(std::size_t visible_count, ConvexWorkspace& polytope) noexcept {
  for (std::size_t at = 0; at < visible_count; ++at) {
    polytope.keys[polytope.visible[at]] = kNever;
    polytope.faces[polytope.visible[at]].is_gone = true;
    polytope.free_faces[polytope.free_count++] = polytope.visible[at];
  }
}

}  // namespace

void startPolytope(const std::array<SupportVertex, 4>& corners,
                   ConvexWorkspace& polytope) noexcept {
  std::copy(corners.begin(), corners.end(), polytope.vertices.begin());
  polytope.vertex_count = 4;
  polytope.face_count = 4;
  polytope.free_count = 0;
  const Eigen::Vector3d& apex = corners[0].difference;
  const double volume = (corners[1].difference - apex)
                            .cross(corners[2].difference - apex)
                            .dot(corners[3].difference - apex);
  if (volume < 0.0) {
    std::swap(polytope.vertices[0], polytope.vertices[1]);
  }
  // Face k lacks vertex k. The neighbor across an edge lacks the third corner.
  constexpr std::array<std::array<Index, 3>, 4> kCorners{
      {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  for (Index k = 0; k < 4; ++k) {
    const auto& c = kCorners[k];
    polytope.faces[k].corners = c;
    polytope.faces[k].neighbours = {c[2], c[0], c[1]};
    setPlane(k, Eigen::Vector3d::UnitX(), polytope);
  }
}

Growth grow(const SupportVertex& vertex, std::size_t face, double rounding,
            ConvexWorkspace& polytope) noexcept {
  if (polytope.vertex_count == ConvexWorkspace::kMaxVertices) {
    return Growth::full;
  }
  const std::size_t visible_count =
      floodVisible(vertex.difference, static_cast<Index>(face), rounding, polytope);
  const std::size_t outline = walkOutline(visible_count, polytope);
  const bool has_room =
      outline <= polytope.free_count + ConvexWorkspace::kMaxFaces - polytope.face_count;
  if (outline < 3 || !has_room) {
    forget(visible_count, polytope);
    return outline < 3 ? Growth::refused : Growth::full;
  }
  const auto apex = static_cast<Index>(polytope.vertex_count++);
  polytope.vertices[apex] = vertex;
  joinOutline(apex, visible_count, polytope);
  closeFan(visible_count, polytope);
  dropVisible(visible_count, polytope);
  return Growth::grown;
}

}  // namespace collision_monitor
