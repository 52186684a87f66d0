// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_edge/markers/marker_thread.h"

#include <utility>

#include "ros_edge/prepared_message.h"

namespace collision_monitor {

MarkerThread::MarkerThread(ros::Publisher publisher)
    : publisher_(std::move(publisher)), thread_([this] { run(); }) {}

MarkerThread::~MarkerThread() {
  is_ending_ = true;
  woken_.post();
  thread_.join();
}

bool MarkerThread::draw(const Watch& watch) {
  if (is_taken_) {
    return false;
  }
  takeSnapshot(watch, snapshot_);
  is_taken_ = true;
  woken_.post();
  return true;
}

void MarkerThread::run() {
  for (woken_.wait(); !is_ending_; woken_.wait()) {
    drawSnapshot();
    is_taken_ = false;
  }
}

void MarkerThread::drawSnapshot() {
  if (drawn_.lock() != snapshot_.fixed) {
    markers_ = std::make_unique<Markers>(*snapshot_.fixed);
    drawn_ = snapshot_.fixed;
  }
  publishPrepared(publisher_, markers_->draw(snapshot_));
  snapshot_.fixed.reset();  // here, so that the cycle's thread never frees a set-up
}

}  // namespace collision_monitor
