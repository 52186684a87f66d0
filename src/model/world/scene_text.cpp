// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "model/number_text.h"
#include "model/world/world_readers.h"

/// Scenes of MoveIt as text. After a line with the name of the scene, each object is a line "*
/// NAME", in the newer format its pose, the number of its shapes, and for each shape its kind,
/// dimensions, pose and colour; in the newer format then the number of subframes with name and
/// pose. "." ends the scene. A pose is a line of a position and a line of a quaternion x, y, z, w.
namespace collision_monitor {
namespace {

/// A fault that leaves the rest of the text without meaning.
struct SceneFault {
  int line;
  std::string found;
  std::string accepted;
};

class SceneText {
 public:
  SceneText(const WorldSource& source, const Place& place, std::vector<WorldObject>& objects)
      : source_(source), place_(place), objects_(objects), rest_(source.text.text) {}

  void read() try {
    next("the name of the scene");
    while (true) {
      const std::string_view line = next("an object, '* NAME', or '.' at the end");
      if (line == ".") {
        return;
      }
      if (line.substr(0, 1) != "*") {
        throw SceneFault{line_, quoted(std::string(line)), "an object, '* NAME', or '.'"};
      }
      readObject(trimmed(line.substr(1)));
    }
  } catch (const SceneFault& fault) {
    place_.addError(fault.line, fault.found, fault.accepted);
    place_.awaitNames();
  }

 private:
  static std::string_view trimmed(std::string_view text) {
    const auto words = wordsOf(text);
    return words.empty() ? std::string_view()
                         : std::string_view(
                               words.front().data(),
                               static_cast<std::size_t>(words.back().data() + words.back().size() -
                                                        words.front().data()));
  }

  /// The next line that is not empty. @throws SceneFault at the end
  std::string_view next(const std::string& accepted) {
    while (!rest_.empty()) {
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      const std::string_view line = trimmed(rest_.substr(0, end));
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++line_;
      if (!line.empty()) {
        return line;
      }
    }
    throw SceneFault{line_, "the end of the text", accepted};
  }

  Eigen::VectorXd numbersIn(std::string_view line, Eigen::Index count, const char* what) const {
    Eigen::VectorXd numbers(count);
    if (const auto fault = parseNumbers(line, numbers)) {
      throw SceneFault{line_, what + (": " + *fault), std::to_string(count) + " finite numbers"};
    }
    return numbers;
  }

  Eigen::VectorXd numbers(Eigen::Index count, const char* what) {
    return numbersIn(next(what), count, what);
  }

  std::size_t countIn(std::string_view line, const char* what) const {
    constexpr double kMaxCount = 1e7;
    const double number = numbersIn(line, 1, what)[0];
    if (!(number >= 0.0 && number <= kMaxCount && number == std::floor(number))) {
      throw SceneFault{line_, what + (" " + shortText(number)), "a whole number from 0 to 1e7"};
    }
    return static_cast<std::size_t>(number);
  }

  Pose poseAfter(const Eigen::Vector3d& position) {
    const Eigen::VectorXd quaternion = numbers(4, "an orientation");
    const std::optional<Pose> pose = poseOf(position, quaternion);
    if (!pose) {
      throw SceneFault{line_, "an orientation that is not of unit length", "a quaternion x y z w"};
    }
    return *pose;
  }

  Pose readPose() {
    const Eigen::Vector3d position = numbers(3, "a position");
    return poseAfter(position);
  }

  void readObject(std::string_view name) {
    WorldObject object;
    object.name = std::string(name);
    object.where = source_.at(line_);
    std::string_view line = next("a position, or the number of shapes");
    const bool is_newer = wordsOf(line).size() > 1;
    if (is_newer) {
      object.frame_from_object = poseAfter(numbersIn(line, 3, "a position"));
      line = next("the number of shapes");
    }
    ObjectShapes shapes;
    for (std::size_t left = countIn(line, "the number of shapes"); left > 0; --left) {
      shapes.push_back(readShape(object));
    }
    object.shapes = std::make_shared<const ObjectShapes>(std::move(shapes));
    if (is_newer) {
      skipSubframes();
    }
    objects_.push_back(std::move(object));
  }

  ObjectShape readShape(WorldObject& object) {
    ObjectShape shape;
    shape.geometry = readGeometry(std::string(next("a kind of shape")));
    shape.object_from_shape = readPose();
    const Eigen::VectorXd colour = numbers(4, "a colour");
    // MoveIt writes zeros for objects without colour.
    if ((colour.array() != 0.0).any()) {
      for (std::size_t i = 0; i < object.colour.size(); ++i) {
        object.colour[i] = static_cast<float>(colour[static_cast<Eigen::Index>(i)]);
      }
    }
    return shape;
  }

  ObjectGeometry readGeometry(const std::string& kind) {
    if (kind == "sphere") {
      return Sphere{numbers(1, "a radius")[0]};
    }
    if (kind == "box") {
      return Box{0.5 * numbers(3, "the size of a box")};
    }
    if (kind == "cylinder" || kind == "cone") {
      const Eigen::VectorXd sizes = numbers(2, "a radius and a length");
      return kind == "cone" ? ObjectGeometry(Cone{0.5 * sizes[1], sizes[0]})
                            : ObjectGeometry(Cylinder{0.5 * sizes[1], sizes[0]});
    }
    if (kind == "plane") {
      const Eigen::VectorXd plane = numbers(4, "a plane a x + b y + c z + d = 0");
      return Plane{plane.head<3>(), -plane[3]};
    }
    if (kind == "mesh") {
      return readMesh();
    }
    throw SceneFault{line_, "shape " + quoted(kind), "sphere, box, cylinder, cone, plane or mesh"};
  }

  ObjectGeometry readMesh() {
    const std::string_view line = next("the numbers of vertices and triangles");
    const auto words = wordsOf(line);
    if (words.size() != 2) {
      throw SceneFault{line_, quoted(std::string(line)), "the numbers of vertices and triangles"};
    }
    const std::size_t vertices = countIn(words[0], "the number of vertices");
    const std::size_t triangles = countIn(words[1], "the number of triangles");
    auto mesh = std::make_shared<TriangleMesh>();
    for (std::size_t i = 0; i < vertices; ++i) {
      mesh->vertices.emplace_back(numbers(3, "a vertex"));
    }
    for (std::size_t i = 0; i < triangles; ++i) {
      const auto corners = wordsOf(next("the vertices of a triangle"));
      if (corners.size() != 3) {
        throw SceneFault{line_, "a triangle of " + std::to_string(corners.size()) + " vertices",
                         "three numbers of vertices"};
      }
      std::array<std::uint32_t, 3> triangle{};
      for (std::size_t k = 0; k < triangle.size(); ++k) {
        triangle[k] = static_cast<std::uint32_t>(countIn(corners[k], "a vertex of a triangle"));
      }
      mesh->triangles.push_back(triangle);
    }
    return SharedMesh(std::move(mesh));
  }

  void skipSubframes() {
    const std::size_t count = countIn(next("the number of subframes"), "the number of subframes");
    for (std::size_t i = 0; i < count; ++i) {
      next("the name of a subframe");
      readPose();
    }
  }

  const WorldSource& source_;
  const Place& place_;
  std::vector<WorldObject>& objects_;
  std::string_view rest_;
  int line_{0};
};

}  // namespace

void readSceneText(const WorldSource& source, const Place& place,
                   std::vector<WorldObject>& objects) {
  SceneText(source, place, objects).read();
}

}  // namespace collision_monitor
