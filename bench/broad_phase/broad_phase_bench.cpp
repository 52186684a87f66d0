// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>

#include "broad_phase/broad_phase.h"
#include "broad_phase_peers.h"

// Time to find all pairs of boxes that meet, from new boxes each frame to the pairs (ours: sorted),
// beside FCL and Bullet in the same run. Prints one line per scene, number and method: the mean
// over the frames of a run as the median of some runs [us], and the pairs of the last frame.
//   broad_phase_bench [SCENE [NUMBER [METHOD]]]
namespace collision_monitor::bench {
namespace {

constexpr std::size_t kLeastRuns = 3;
constexpr std::size_t kMostRuns = 15;
constexpr double kAllSeconds = 0.15;  ///< of all runs: at least this, or kMostRuns
constexpr double kRunSeconds = 0.05;  ///< of one run: at least this, or kMostFrames
constexpr double kTooSlow = 1.0;      ///< [s] slower frames are measured once
constexpr int kMostFrames = 2000;

const std::map<std::string, BroadPhaseKind> kKinds = {
    {"automatic", BroadPhaseKind::automatic},
    {"brute_force", BroadPhaseKind::brute_force},
    {"sweep_and_prune", BroadPhaseKind::sweep_and_prune},
    {"hashed_bins", BroadPhaseKind::hashed_bins},
    {"aabb_tree", BroadPhaseKind::aabb_tree},
    {"neighbour_list", BroadPhaseKind::neighbour_list}};

class OurContender : public Contender {
 public:
  OurContender(BroadPhaseKind kind, const BoxScene& scene)
      : broad_phase_(makeBroadPhase(kind, scene.bounds().boxes.size())) {
    meetings_.reserve(roomForPairs(scene.bounds().boxes.size()));
  }

  void prepare(const BodyBounds& bounds) override { bounds_ = &bounds; }

  std::size_t run() override {
    findMeetings(broad_phase_, *bounds_, meetings_);
    return meetings_.size();
  }

 private:
  BroadPhase broad_phase_;
  const BodyBounds* bounds_{nullptr};
  std::vector<BodyPair> meetings_;
};

struct Result {
  double seconds{0.0};  ///< per frame
  std::size_t pairs{0};
};

/// This thread's time, so that other programs do not count. Units: seconds.
double timeNow() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The cost of one call of timeNow. Units: seconds.
double timeOfTiming() {
  constexpr int kLooks = 1000;
  const double start = timeNow();
  for (int i = 1; i < kLooks; ++i) {
    timeNow();
  }
  return (timeNow() - start) / kLooks;
}

double runOnce(BoxScene& scene, Contender& contender, Result& result) {
  scene.advance();
  contender.prepare(scene.bounds());
  const double start = timeNow();
  result.pairs = contender.run();
  static const double of_timing = timeOfTiming();
  return timeNow() - start - of_timing;
}

Result measure(BoxScene& scene, Contender& contender) {
  Result result;
  runOnce(scene, contender, result);
  result.seconds = runOnce(scene, contender, result);  // caches are warm now
  if (result.seconds > kTooSlow) {
    return result;
  }
  std::vector<double> means;
  double all_seconds = 0.0;
  while (means.size() < kLeastRuns || (all_seconds < kAllSeconds && means.size() < kMostRuns)) {
    double seconds = 0.0;
    int frames = 0;
    while (frames < 3 || (seconds < kRunSeconds && frames < kMostFrames)) {
      seconds += runOnce(scene, contender, result);
      ++frames;
    }
    means.push_back(seconds / frames);
    all_seconds += seconds;
  }
  const auto middle = means.begin() + static_cast<std::ptrdiff_t>(means.size() / 2);
  std::nth_element(means.begin(), middle, means.end());
  result.seconds = *middle;
  return result;
}

/// @return false if it is too slow for ten times as many boxes.
bool print(SceneKind kind, std::size_t count, const std::string& name) {
  BoxScene scene(kind, count);
  const auto ours = kKinds.find(name);
  const std::unique_ptr<Contender> contender =
      ours != kKinds.end() ? std::make_unique<OurContender>(ours->second, scene)
                           : makePeer(name, scene);
  const Result result = measure(scene, *contender);
  std::printf("%s %zu %s %.2f %zu\n", nameOf(kind), count, name.c_str(), 1e6 * result.seconds,
              result.pairs);
  std::fflush(stdout);
  const double most_a_box = count < 10000 ? 1e-5 : 6e-7;
  return result.seconds <= most_a_box * static_cast<double>(count);
}

void printAll(const std::string& scene, std::size_t only_count, const std::string& only_method) {
  std::vector<std::string> methods = peerNames();
  for (const auto& [name, kind] : kKinds) {
    methods.push_back(name);
  }
  for (const SceneKind kind :
       {SceneKind::coherent, SceneKind::random, SceneKind::clustered, SceneKind::beams}) {
    for (const std::string& method : methods) {
      bool goes_on = (scene.empty() || scene == nameOf(kind)) &&
                     (only_method.empty() || method == only_method);
      const std::size_t least = only_count != 0 ? only_count : 100;
      const std::size_t most = only_count != 0 ? only_count : 100000;
      for (std::size_t count = least; goes_on && count <= most; count *= 10) {
        goes_on = print(kind, count, method);
      }
    }
  }
}

}  // namespace
}  // namespace collision_monitor::bench

int main(int argc, char** argv) {
  const std::string scene = argc > 1 ? argv[1] : "";
  const std::size_t count = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 0;
  collision_monitor::bench::printAll(scene, count, argc > 3 ? argv[3] : "");
  return 0;
}
