// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <tf2/buffer_core.h>

#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "bench_loop.h"
#include "ros_edge/poses/pose_reader.h"
#include "support/robots/urdf_text.h"

// Poses of all links of an arm and of a humanoid at one stamp, from ten seconds of data at 100 Hz:
// PoseReader with and without a new message, beside the usual use of tf2's buffer: every link from
// the base.
namespace collision_monitor::test {
namespace {

constexpr int kSamples = 1000;
constexpr double kPeriod = 0.01;

/// Limbs of equal length on one base.
struct Tree {
  int limbs;
  int links_a_limb;

  int linkCount() const { return 1 + limbs * links_a_limb; }
};

std::string nameOf(const Tree& tree, int limb, int place) {
  return place == 0 ? "base" : "link_" + std::to_string(limb * tree.links_a_limb + place);
}

std::string urdfOf(const Tree& tree) {
  const char* const box = "<box size='0.1 0.1 0.1'/>";
  std::string xml = linkXml("base", box);
  for (int limb = 0; limb < tree.limbs; ++limb) {
    for (int place = 1; place <= tree.links_a_limb; ++place) {
      const std::string child = nameOf(tree, limb, place);
      xml += linkXml(child, box) +
             jointXml("to_" + child, "continuous", nameOf(tree, limb, place - 1), child);
    }
  }
  return robotXml(xml);
}

std::vector<geometry_msgs::TransformStamped> messageAt(const Tree& tree, int sample) {
  std::vector<geometry_msgs::TransformStamped> transforms;
  const double half_angle = 0.001 * sample;
  for (int limb = 0; limb < tree.limbs; ++limb) {
    for (int place = 1; place <= tree.links_a_limb; ++place) {
      geometry_msgs::TransformStamped transform;
      transform.header.stamp = ros::Time(1.0 + kPeriod * sample);
      transform.header.frame_id = nameOf(tree, limb, place - 1);
      transform.child_frame_id = nameOf(tree, limb, place);
      transform.transform.translation.z = 0.1;
      transform.transform.rotation.x = std::sin(half_angle);
      transform.transform.rotation.w = std::cos(half_angle);
      transforms.push_back(transform);
    }
  }
  return transforms;
}

/// A robot whose transforms go to our store and to tf2: ten seconds of them, and more in the run.
class Scene {
 public:
  explicit Scene(const Tree& tree) : tree_(tree) {
    while (sample_ < kSamples) {
      sendNext();
    }
  }

  void sendNext() {
    now_ = ros::Time(1.0 + kPeriod * ++sample_);
    const std::vector<geometry_msgs::TransformStamped> message = messageAt(tree_, sample_);
    store_.accept(message, false);
    for (const geometry_msgs::TransformStamped& transform : message) {
      buffer_.setTransform(transform, "bench");
    }
  }

  const TransformStore& store() const { return store_; }
  const tf2::BufferCore& buffer() const { return buffer_; }
  const ros::Time& now() const { return now_; }

 private:
  Tree tree_;
  int sample_{0};
  ros::Time now_{1.0};
  TransformStore store_{[this] { return now_; }};
  tf2::BufferCore buffer_;
};

/// Runs `query` after each message; only the query is timed.
template <class Query>
void forMessages(benchmark::State& state, Scene& scene, const Query& query) {
  using Clock = std::chrono::steady_clock;
  for ([[maybe_unused]] const auto unused : state) {
    scene.sendNext();
    const Clock::time_point start = Clock::now();
    query();
    state.SetIterationTime(std::chrono::duration<double>(Clock::now() - start).count());
  }
}

void readNews(benchmark::State& state, const Tree& tree) {
  Scene scene(tree);
  const RobotModel model = readText(urdfOf(tree)).model;
  PoseReader reader(model, scene.store(), {});
  LinkPoses poses = makeLinkPoses(model);
  forMessages(state, scene, [&] { benchmark::DoNotOptimize(reader.read(scene.now(), poses)); });
}

void readNothing(benchmark::State& state, const Tree& tree) {
  const Scene scene(tree);
  const RobotModel model = readText(urdfOf(tree)).model;
  PoseReader reader(model, scene.store(), {});
  LinkPoses poses = makeLinkPoses(model);
  reader.read(scene.now(), poses);
  for ([[maybe_unused]] const auto unused : state) {
    benchmark::DoNotOptimize(reader.read(scene.now(), poses));
  }
}

void askBuffer(benchmark::State& state, const Tree& tree) {
  Scene scene(tree);
  std::vector<std::string> names;
  for (int limb = 0; limb < tree.limbs; ++limb) {
    for (int place = 1; place <= tree.links_a_limb; ++place) {
      names.push_back(nameOf(tree, limb, place));
    }
  }
  forMessages(state, scene, [&] {
    for (const std::string& name : names) {
      benchmark::DoNotOptimize(scene.buffer().lookupTransform("base", name, scene.now()));
    }
  });
}

void registerTree(const std::string& name, const Tree& tree) {
  const auto add = [&](const char* what, void (*run)(benchmark::State&, const Tree&)) {
    return benchmark::RegisterBenchmark((name + what).c_str(), run, tree);
  };
  add("/read", readNews)->UseManualTime();
  add("/tf2", askBuffer)->UseManualTime();
  add("/read_without_news", readNothing);
}

void registerAll() {
  registerTree("arm_11_links", {1, 10});
  registerTree("humanoid_60_links", {5, 12});
}

}  // namespace
}  // namespace collision_monitor::test

int main(int argc, char** argv) {
  return collision_monitor::test::runBenchmarks(argc, argv, &collision_monitor::test::registerAll);
}
