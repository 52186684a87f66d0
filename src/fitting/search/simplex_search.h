// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

namespace collision_monitor {

/// Where a simplex search starts and when it ends.
struct SimplexLimits {
  double first_step{0.1};
  double last_step{1e-6};  ///< ends when the simplex is smaller
  int evaluations{200};
};

/// A point and its cost.
template <int N>
struct SimplexCorner {
  Eigen::Matrix<double, N, 1> at;
  double cost;

  bool operator<(const SimplexCorner& other) const { return cost < other.cost; }
};

template <int N>
using SimplexCorners = std::array<SimplexCorner<N>, N + 1>;

/// Moves the worst corner, or all but the best one. `evaluate` takes a point and a cutoff, and
/// returns a corner; a cost at or above the cutoff is of no use.
/// @pre the corners are sorted.
template <int N, class Evaluate>
void moveWorst(SimplexCorners<N>& simplex, const Evaluate& evaluate) {
  using Vector = Eigen::Matrix<double, N, 1>;
  const SimplexCorner<N>& best = simplex.front();
  SimplexCorner<N>& worst = simplex.back();
  Vector center = Vector::Zero();
  for (std::size_t i = 0; i < N; ++i) {
    center += simplex[i].at / N;
  }
  const SimplexCorner<N> reflected = evaluate(2.0 * center - worst.at, worst.cost);
  if (reflected < best) {
    worst = std::min(reflected, evaluate(3.0 * center - 2.0 * worst.at, reflected.cost));
    return;
  }
  if (reflected < simplex[N - 1]) {
    worst = reflected;
    return;
  }
  const SimplexCorner<N>& towards = std::min(worst, reflected);
  const SimplexCorner<N> contracted = evaluate(0.5 * (center + towards.at), towards.cost);
  if (contracted < towards) {
    worst = contracted;
    return;
  }
  for (std::size_t i = 1; i <= N; ++i) {
    simplex[i] = evaluate(0.5 * (simplex[i].at + best.at), std::numeric_limits<double>::infinity());
  }
}

/// A local minimum of `cost` near zero; `cost` may have kinks. It is called as cost(at) or cost(at,
/// bound). If the true cost is not below `bound`, it may return any value not below `bound`.
/// Source: Nelder, Mead, "A Simplex Method for Function Minimization" (1965), with the usual
/// coefficients 1, 2, 1/2, 1/2.
template <int N, class Cost>
Eigen::Matrix<double, N, 1> searchSimplex(const SimplexLimits& limits, const Cost& cost) {
  using Vector = Eigen::Matrix<double, N, 1>;
  int evaluations = 0;
  const auto evaluate = [&](const Vector& at, [[maybe_unused]] double bound) {
    ++evaluations;
    if constexpr (std::is_invocable_v<const Cost&, const Vector&, double>) {
      return SimplexCorner<N>{at, cost(at, bound)};
    } else {
      return SimplexCorner<N>{at, cost(at)};
    }
  };
  SimplexCorners<N> simplex;
  for (int i = 0; i <= N; ++i) {
    const Vector at =
        i == 0 ? Vector(Vector::Zero()) : Vector(limits.first_step * Vector::Unit(i - 1));
    simplex[static_cast<std::size_t>(i)] = evaluate(at, std::numeric_limits<double>::infinity());
  }
  while (evaluations < limits.evaluations) {
    std::sort(simplex.begin(), simplex.end());
    if ((simplex.back().at - simplex.front().at).cwiseAbs().maxCoeff() < limits.last_step) {
      break;
    }
    moveWorst<N>(simplex, evaluate);
  }
  return std::min_element(simplex.begin(), simplex.end())->at;
}

}  // namespace collision_monitor
