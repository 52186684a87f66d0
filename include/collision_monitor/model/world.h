// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "collision_monitor/geometry/pose.h"
#include "collision_monitor/geometry/shapes.h"
#include "collision_monitor/geometry/triangle_mesh.h"
#include "collision_monitor/model/problems.h"
#include "collision_monitor/model/robot_model.h"

/// Objects beside the robots, such as a table, a floor or a grasped part, and how they change.
/// Units: metres.
namespace collision_monitor {

/// Axis along z: the base is a disc at -half_length, the tip is at +half_length.
struct Cone {
  double half_length{0.0};  ///< [m]
  double radius{0.0};       ///< [m] of the base
};

/// The half space of all points with normal . point <= offset. The normal need not be unit; then
/// the offset is a multiple of its length.
struct Plane {
  /// Out of the half space, in the object's frame.
  Eigen::Vector3d normal{Eigen::Vector3d::UnitZ()};
  double offset{0.0};  ///< [m] times the normal's length
};

/// Copies of an object share its triangles.
using SharedMesh = std::shared_ptr<const TriangleMesh>;

/// What an object may be made of.
using ObjectGeometry = std::variant<Sphere, Capsule, Box, Cylinder, Cone, SharedMesh, Plane>;

/// One geometry of an object, placed in its frame.
struct ObjectShape {
  Pose object_from_shape;   ///< where the shape stands in the object
  ObjectGeometry geometry;  ///< in the shape's own frame
};

using ObjectShapes = std::vector<ObjectShape>;  ///< all shapes of one object

/// Red, green, blue and opacity, from 0 to 1.
using ObjectColour = std::array<float, 4>;

/// A rigid thing that links may touch. Copies share their shapes, which never change.
struct WorldObject {
  std::string name;   ///< unique among objects and links
  std::string frame;  ///< tf frame that carries it; of an attached object, its link in messages
  Pose frame_from_object;                       ///< where the object stands in `frame`
  std::shared_ptr<const ObjectShapes> shapes;   ///< at least one
  double padding{0.0};                          ///< [m] added to every shape
  std::string group;                            ///< for rules about pairs; may be empty
  ObjectColour colour{0.6F, 0.6F, 0.6F, 1.0F};  ///< for rviz
  bool is_attached{false};                      ///< moves with the link `frame`
  /// Links that may touch it, beside those that an attached object is rigidly joined to.
  std::vector<std::string> touch_links;
  std::string where;  ///< where the user wrote it, for messages: "cell.yaml line 12"; may be empty
  bool lacks_shapes{false};  ///< some could not be read, which is reported already
};

/// All objects, in order of name, so that the same objects make the same set-up, however they came.
struct World {
  std::map<std::string, std::shared_ptr<const WorldObject>> objects;  ///< by name; never null
};

/// What is accepted.
constexpr std::size_t kMostObjects = 20000;           ///< how many objects a world may hold
constexpr std::size_t kMostWorldBytes = 48U << 20U;   ///< of a text with objects
constexpr std::size_t kMostObjectTriangles = 500000;  ///< of one mesh
constexpr double kFarthestObject = 1e6;               ///< [m] coordinates and lengths
constexpr double kMostObjectPadding = 1e3;            ///< [m] as of links

/// What a change does with the objects that it names.
enum class ChangeKind : unsigned char {
  add,          ///< new objects, whole
  move,         ///< new poses, in new frames where these are named
  remove,       ///< by name
  clear,        ///< all objects, attached ones too; names none
  replace_all,  ///< these objects, whole, in place of all
  attach,       ///< to the links `frame`, at their poses or where they stand
  detach,       ///< to the frames `frame`, where they stand
};

/// "add", "move", ... as in messages.
const char* nameOf(ChangeKind kind) noexcept;

/// One change of the objects that it holds. `add` and `replace_all` read every field of them;
/// others only those that ChangeKind names, and the name. An empty frame means the world frame; for
/// `move` it means that the object keeps its frame.
struct ObjectChange {
  ChangeKind kind{ChangeKind::add};  ///< what is done
  std::vector<WorldObject> objects;  ///< new ones, or the names of those meant
  bool has_poses{true};              ///< for `attach`: false keeps the objects where they stand
};

/// What changes may refer to.
struct KnownPlaces {
  std::vector<std::string> links;        ///< names in messages
  std::vector<std::string> link_frames;  ///< their tf frames: no object may have such a name
  std::string world_frame;               ///< tf frame in which distances are measured
  /// Whether a frame that is neither a link's nor the world's exists; empty: any may come to exist.
  std::function<bool(const std::string& frame)> has_frame;
  bool awaits_links{false};       ///< robots are still to come
  std::set<std::string> waiting;  ///< objects of the world before that wait for links of these
  std::string other_frames;  ///< in messages, beside links' frames; "": those of tf and the world's
  /// The newest pose of `child` (a frame, or a link by its name) in `parent`; nothing if it is not
  /// known. Empty: no pose is known.
  std::function<std::optional<Pose>(const std::string& parent, const std::string& child)> find_pose;

  /// Whether a link that is unknown may be one of a robot to come: what stands before its last
  /// slash is the prefix of no link that is known.
  bool mayCome(const std::string& link) const;
};

/// The links of the robots and the world frame. Any other frame may come to exist.
KnownPlaces placesOf(const RobotModel& robots, const std::string& world_frame);

/// Makes all changes in their order, or none if one has a fault. All faults are added to `report`,
/// up to a hundred, each with the number of its change, the name of its object, the value and what
/// is accepted. An object with a fault counts as present for the changes after it.
/// @return the changed world; `world` itself after a fault.
World applyChanges(const World& world, const std::vector<ObjectChange>& changes,
                   const KnownPlaces& places, SetupReport& report);

}  // namespace collision_monitor
