// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <collision_monitor/ExplainPair.h>

#include <functional>
#include <optional>

#include "ros_edge/outputs/pair_view.h"
#include "ros_edge/poses/newest_state.h"

namespace collision_monitor {

/// Asks the cycle about two links; nothing if it does not answer.
using PairViewer =
    std::function<std::optional<PairView>(const std::string& link_a, const std::string& link_b)>;

/// Answers the service of that name for the newest poses.
void answerExplainPair(const MonitorSetup& current, const NewestState& newest,
                       const PairViewer& view, const ExplainPair::Request& request,
                       ExplainPair::Response& response);

}  // namespace collision_monitor
