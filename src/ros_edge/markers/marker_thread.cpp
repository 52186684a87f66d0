// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/markers/marker_thread.h"

namespace collision_monitor {

MarkerThread::MarkerThread() : thread_([this] { drawSnapshot(); }) {}

bool MarkerThread::draw(const Watch& watch) {
  if (step_ != Step::idle) {
    return false;
  }
  takeSnapshot(watch, snapshot_);
  step_ = Step::drawing;
  thread_.wake();
  return true;
}

const PreparedMessage* MarkerThread::fetch() noexcept {
  if (step_ != Step::drawn) {
    return nullptr;
  }
  step_ = Step::idle;
  return &drawn_;
}

void MarkerThread::drawSnapshot() {
  if (step_ != Step::drawing) {
    return;
  }
  if (setup_.lock() != snapshot_.fixed) {
    markers_ = std::make_unique<Markers>(*snapshot_.fixed);
    setup_ = snapshot_.fixed;
  }
  drawn_ = prepare(markers_->draw(snapshot_));
  snapshot_.fixed.reset();  // here, so that the cycle's thread never frees a set-up
  step_ = Step::drawn;
}

}  // namespace collision_monitor
