// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Products of complex numbers in vector registers, one per lane, with the whole turns of their
// arguments. Compiled once for each instruction set, hence the guard that is undone and set again.
#if defined(COLLISION_MONITOR_GEOMETRY_PRODUCTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_GEOMETRY_PRODUCTS_INL_H_
#undef COLLISION_MONITOR_GEOMETRY_PRODUCTS_INL_H_
#else
#define COLLISION_MONITOR_GEOMETRY_PRODUCTS_INL_H_
#endif

#include <algorithm>
#include <cstddef>

#include "collision_monitor/geometry/winding.h"
#include "geometry/lanes/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {

/// Products of numbers from this size to its inverse keep all digits. Sizes of angles are cubes of
/// lengths.
constexpr double kSmall = 1e-100;

/// A product so far; its argument is from -pi to pi, without -pi.
struct ProductLanes {
  Number real, imaginary, turns;
};

/// Multiplies by numbers of any size. Those that are too small count for nothing.
HWY_INLINE void multiply(Number x, Number y, ProductLanes& product) {
  const auto sizeOf = [](Number re, Number im)
                          HWY_ATTR { return hn::Add(hn::Abs(re), hn::Abs(im)); };
  const Truth counts = hn::Gt(sizeOf(x, y), number(kSmall));
  const Number re = hn::Sub(hn::Mul(product.real, x), hn::Mul(product.imaginary, y));
  const Number im =
      hn::Add(hn::Add(hn::Mul(product.real, y), hn::Mul(product.imaginary, x)), zero());  // no -0
  // The sum of two arguments from 0 to pi, or of two below 0, may have passed half a turn.
  const Truth are_up = hn::And(hn::Ge(product.imaginary, zero()), hn::Ge(y, zero()));
  const Truth are_down = hn::And(hn::Lt(product.imaginary, zero()), hn::Lt(y, zero()));
  const Truth is_flat = hn::Eq(im, zero());
  const Truth was_behind = hn::Lt(product.real, zero());
  const Truth is_whole_turn = hn::And(is_flat, hn::And(hn::Gt(re, zero()), was_behind));
  const Truth is_half_turn = hn::And(is_flat, hn::Or(hn::Lt(re, zero()), was_behind));
  const Truth up = hn::And(are_up, hn::Or(hn::Lt(im, zero()), is_whole_turn));
  const Truth down = hn::And(are_down, hn::Or(hn::Gt(im, zero()), is_half_turn));
  const Number turned =
      hn::Sub(hn::IfThenElseZero(up, number(1.0)), hn::IfThenElseZero(down, number(1.0)));
  product.turns = hn::Add(product.turns, hn::IfThenElseZero(counts, turned));
  product.real = hn::IfThenElse(counts, re, product.real);
  product.imaginary = hn::IfThenElse(counts, im, product.imaginary);
  const Number size = sizeOf(product.real, product.imaginary);
  const Truth keeps_digits =
      hn::And(hn::Gt(size, number(kSmall)), hn::Lt(size, number(1.0 / kSmall)));
  if (!hn::AllTrue(Lanes(), keeps_digits)) {
    const Number factor = hn::IfThenElse(keeps_digits, number(1.0), size);
    product.real = hn::Div(product.real, factor);
    product.imaginary = hn::Div(product.imaginary, factor);
  }
}

HWY_INLINE ProductLanes productAt(std::size_t lane, const SolidAngles::Products& products) {
  return {hn::Load(Lanes(), &products.real[lane]), hn::Load(Lanes(), &products.imaginary[lane]),
          hn::Load(Lanes(), &products.turns[lane])};
}

HWY_INLINE void store(const ProductLanes& product, std::size_t lane,
                      SolidAngles::Products& products) {
  hn::Store(product.real, Lanes(), &products.real[lane]);
  hn::Store(product.imaginary, Lanes(), &products.imaginary[lane]);
  hn::Store(product.turns, Lanes(), &products.turns[lane]);
}

/// Multiplies the products of all lanes into the first, half of them at a time. Turns stay.
HWY_INLINE void joinProducts(SolidAngles::Products& products) {
  for (std::size_t half = SolidAngles::kLanes / 2; half > 0; half /= 2) {
    SolidAngles::Products others = products;
    others.real.fill(1.0);
    others.imaginary.fill(0.0);
    std::copy_n(products.real.begin() + half, half, others.real.begin());
    std::copy_n(products.imaginary.begin() + half, half, others.imaginary.begin());
    for (std::size_t lane = 0; lane < SolidAngles::kLanes; lane += hn::Lanes(Lanes())) {
      ProductLanes product = productAt(lane, products);
      const ProductLanes other = productAt(lane, others);
      multiply(other.real, other.imaginary, product);
      store(product, lane, products);
    }
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
