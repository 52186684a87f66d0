// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/hulls/run_qhull.h"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "geometry/interruption.h"

// Uses the C library, not libqhullcpp. That one replaces qh_fprintf in the whole process, and ends
// the process when another user of the C library (a nodelet, PCL) prints a message.
extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace collision_monitor {
namespace {

using Faces = std::vector<std::array<std::uint32_t, 3>>;

/// A stream for qhull's messages. It writes to memory and is dropped.
class SilentStream {
 public:
  SilentStream() : file_(open_memstream(&text_, &size_)) {}
  ~SilentStream() {
    if (file_ != nullptr) {
      std::fclose(file_);
    }
    std::free(text_);
  }
  SilentStream(const SilentStream&) = delete;
  SilentStream& operator=(const SilentStream&) = delete;
  FILE* file() const { return file_; }

 private:
  char* text_{nullptr};
  std::size_t size_{0};
  FILE* file_;
};

/// One run of the reentrant library. Frees the memory of qhull also after a failure.
class QhullRun {
 public:
  explicit QhullRun(FILE* messages) : qh_(std::make_unique<qhT>()), messages_(messages) {
    qh_zero(qh_.get(), messages_);
  }
  ~QhullRun() {
    qh_freeqhull(qh_.get(), !qh_ALL);
    int current = 0;
    int total = 0;
    qh_memfreeshort(qh_.get(), &current, &total);
  }
  QhullRun(const QhullRun&) = delete;
  QhullRun& operator=(const QhullRun&) = delete;

  bool succeeds(std::vector<coordT>& coordinates, std::string options) {
    const int count = static_cast<int>(coordinates.size() / 3);
    return qh_new_qhull(qh_.get(), 3, count, coordinates.data(), False, options.data(), nullptr,
                        messages_) == qh_ERRnone;
  }

  Faces faces() const {
    Faces result;
    for (const facetT* facet = qh_->facet_list; facet != nullptr && facet->next != nullptr;
         facet = facet->next) {
      std::array<std::uint32_t, 3> corners{};
      for (int i = 0; i < 3; ++i) {
        auto* vertex = static_cast<vertexT*>(facet->vertices->e[i].p);
        corners[static_cast<std::size_t>(i)] =
            static_cast<std::uint32_t>(qh_pointid(qh_.get(), vertex->point));
      }
      // qhull stores the vertices by age and keeps the orientation as a flag.
      if (facet->toporient != qh_ORIENTclock) {
        std::swap(corners[1], corners[2]);
      }
      result.push_back(corners);
    }
    return result;
  }

 private:
  std::unique_ptr<qhT> qh_;
  FILE* messages_;
};

}  // namespace

Faces runQhull(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& center,
               double extent) {
  throwIfInterrupted();  // qhull cannot be interrupted
  std::vector<coordT> coordinates;
  coordinates.reserve(3 * points.size());
  for (const auto& p : points) {
    const Eigen::Vector3d normalised = (p - center) / extent;
    coordinates.insert(coordinates.end(), normalised.data(), normalised.data() + 3);
  }
  // Qt: triangulate merged facets. QJ: joggle the input, if facets cannot be merged.
  for (const char* options : {"qhull Qt Pp", "qhull QJ Pp"}) {
    const SilentStream messages;
    if (messages.file() == nullptr) {
      return {};
    }
    QhullRun run(messages.file());
    if (run.succeeds(coordinates, options)) {
      return run.faces();
    }
  }
  return {};
}

}  // namespace collision_monitor
