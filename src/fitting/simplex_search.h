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

/// A local minimum of `cost`, which may have kinks, near zero. It is asked as cost(at), or as
/// cost(at, bound), and may then say anything not below the bound where it is not below it.
/// Source: Nelder, Mead, "A Simplex Method for Function Minimization" (1965), with the usual
/// coefficients 1, 2, 1/2, 1/2.
template <int N, class Cost>
Eigen::Matrix<double, N, 1> searchSimplex(const SimplexLimits& limits, const Cost& cost) {
  using Vector = Eigen::Matrix<double, N, 1>;
  struct Corner {
    Vector at;
    double cost;
  };
  std::array<Corner, N + 1> simplex;
  int evaluations = 0;
  constexpr double kNoBound = std::numeric_limits<double>::infinity();
  const auto evaluate = [&](const Vector& at, [[maybe_unused]] double bound) {
    ++evaluations;
    if constexpr (std::is_invocable_v<const Cost&, const Vector&, double>) {
      return Corner{at, cost(at, bound)};
    } else {
      return Corner{at, cost(at)};
    }
  };
  for (int i = 0; i <= N; ++i) {
    const Vector at =
        i == 0 ? Vector(Vector::Zero()) : Vector(limits.first_step * Vector::Unit(i - 1));
    simplex[static_cast<std::size_t>(i)] = evaluate(at, kNoBound);
  }
  const auto less = [](const Corner& a, const Corner& b) { return a.cost < b.cost; };
  while (evaluations < limits.evaluations) {
    std::sort(simplex.begin(), simplex.end(), less);
    const Corner& best = simplex.front();
    Corner& worst = simplex.back();
    if ((worst.at - best.at).cwiseAbs().maxCoeff() < limits.last_step) {
      break;
    }
    Vector centre = Vector::Zero();
    for (int i = 0; i < N; ++i) {
      centre += simplex[static_cast<std::size_t>(i)].at / N;
    }
    const Corner reflected = evaluate(2.0 * centre - worst.at, worst.cost);
    if (reflected.cost < best.cost) {
      worst = std::min(reflected, evaluate(3.0 * centre - 2.0 * worst.at, reflected.cost), less);
    } else if (reflected.cost < simplex[N - 1].cost) {
      worst = reflected;
    } else {
      const Corner& towards = std::min(worst, reflected, less);
      const Corner contracted = evaluate(0.5 * (centre + towards.at), towards.cost);
      if (contracted.cost < towards.cost) {
        worst = contracted;
      } else {
        for (std::size_t i = 1; i <= N; ++i) {
          simplex[i] = evaluate(0.5 * (simplex[i].at + best.at), kNoBound);
        }
      }
    }
  }
  return std::min_element(simplex.begin(), simplex.end(), less)->at;
}

}  // namespace collision_monitor
