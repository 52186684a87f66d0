// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Sine and cosine in lanes.
#if defined(COLLISION_MONITOR_SINE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_SINE_LANES_INL_H_
#undef COLLISION_MONITOR_SINE_LANES_INL_H_
#else
#define COLLISION_MONITOR_SINE_LANES_INL_H_
#endif

#include <cmath>

#include "geometry/lanes/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

struct SineCosine {
  Number sine, cosine;
};

/// Beyond this, the products of quarter turns and the parts of pi / 2 below are no longer exact.
constexpr double kMostQuarterTurns = 1048576.0;

/// Works lane by lane, for angles so large that hardly any digit of the fraction is left.
HWY_NOINLINE inline SineCosine sineCosineOfLarge(Number angle) {
  HWY_ALIGN double angles[hn::MaxLanes(Lanes())];
  HWY_ALIGN double sines[hn::MaxLanes(Lanes())];
  HWY_ALIGN double cosines[hn::MaxLanes(Lanes())];
  hn::Store(angle, Lanes(), angles);
  for (std::size_t lane = 0; lane < hn::Lanes(Lanes()); ++lane) {
    sines[lane] = std::sin(angles[lane]);
    cosines[lane] = std::cos(angles[lane]);
  }
  return {hn::Load(Lanes(), sines), hn::Load(Lanes(), cosines)};
}

/// c0 + x (c1 + x (c2 + ...))
HWY_INLINE Number polynomial(Number x, const double (&coefficients)[6]) {
  Number sum = number(coefficients[5]);
  for (int i = 4; i >= 0; --i) {
    sum = hn::Add(number(coefficients[i]), hn::Mul(x, sum));
  }
  return sum;
}

/// @param quarters the quarter turns nearest to the angle, at most kMostQuarterTurns
HWY_INLINE SineCosine sineCosineOfUsual(Number angle, Number quarters) {
  constexpr double kSine[6] = {-1.66666666666666324348e-01, 8.33333333332248946124e-03,
                               -1.98412698298579493134e-04, 2.75573137070700676789e-06,
                               -2.50507602534068634195e-08, 1.58969099521155010221e-10};
  constexpr double kCosine[6] = {4.16666666666666019037e-02, -1.38888888888741095749e-03,
                                 2.48015872894767294178e-05, -2.75573143513906633035e-07,
                                 2.08757232129817482790e-09, -1.13596475577881948265e-11};
  Number rest = hn::Sub(angle, hn::Mul(quarters, number(1.57079632673412561417e+00)));
  rest = hn::Sub(rest, hn::Mul(quarters, number(6.07710050630396597660e-11)));
  rest = hn::Sub(rest, hn::Mul(quarters, number(2.02226624879595063154e-21)));
  const Number square = hn::Mul(rest, rest);
  const Number sine = hn::Add(rest, hn::Mul(rest, hn::Mul(square, polynomial(square, kSine))));
  const Number cosine = hn::Add(hn::Sub(number(1.0), hn::Mul(number(0.5), square)),
                                hn::Mul(hn::Mul(square, square), polynomial(square, kCosine)));
  // 0, 1, 2 or 3 quarter turns.
  const Number turn =
      hn::Sub(quarters, hn::Mul(number(4.0), hn::Floor(hn::Mul(quarters, number(0.25)))));
  const Truth is_one = hn::Eq(turn, number(1.0));
  const Truth is_three = hn::Eq(turn, number(3.0));
  const Truth is_odd = hn::Or(is_one, is_three);
  const Number across = hn::IfThenElse(is_odd, cosine, sine);
  const Number ahead = hn::IfThenElse(is_odd, sine, cosine);
  const Truth is_back = hn::Ge(turn, number(2.0));
  const Truth is_left = hn::Or(is_one, hn::Eq(turn, number(2.0)));
  return {hn::IfThenElse(is_back, hn::Neg(across), across),
          hn::IfThenElse(is_left, hn::Neg(ahead), ahead)};
}

/// No lane depends on another one. Error: 2e-16 up to a million turns. Limits: NaN for angles that
/// are not finite.
/// Source: reduction by multiples of pi / 2 in three parts of 33 bits: Cody, Waite (1980); minimax
/// polynomials: Sun's fdlibm (1993), k_sin.c and k_cos.c.
HWY_INLINE SineCosine sineCosine(Number angle) {
  const Number quarters = hn::Round(hn::Mul(angle, number(6.36619772367581382433e-01)));
  const Truth is_large = hn::Gt(hn::Abs(quarters), number(kMostQuarterTurns));
  const SineCosine usual = sineCosineOfUsual(angle, quarters);
  if (HWY_LIKELY(hn::AllFalse(Lanes(), is_large))) {
    return usual;
  }
  const SineCosine large = sineCosineOfLarge(angle);
  return {hn::IfThenElse(is_large, large.sine, usual.sine),
          hn::IfThenElse(is_large, large.cosine, usual.cosine)};
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
