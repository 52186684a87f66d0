// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause

// Numbers and 3-vectors in vector registers, one per lane. Compiled once for each instruction set,
// hence the guard that is undone and set again. No fused multiply-add is used, so every instruction
// set rounds alike.
#if defined(COLLISION_MONITOR_GEOMETRY_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COLLISION_MONITOR_GEOMETRY_LANES_INL_H_
#undef COLLISION_MONITOR_GEOMETRY_LANES_INL_H_
#else
#define COLLISION_MONITOR_GEOMETRY_LANES_INL_H_
#endif

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::ScalableTag<double>;
using Number = hn::Vec<Lanes>;
using Truth = hn::Mask<Lanes>;

HWY_INLINE Number number(double value) { return hn::Set(Lanes(), value); }
HWY_INLINE Number zero() { return hn::Zero(Lanes()); }
HWY_INLINE Truth everywhere() { return hn::Eq(zero(), zero()); }
/// Whether `truth` holds in all lanes of `counts`.
HWY_INLINE bool isTrueWhere(Truth counts, Truth truth) {
  return hn::AllTrue(Lanes(), hn::Or(truth, hn::Not(counts)));
}

struct Vector3 {
  Number x, y, z;
};

HWY_INLINE Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vector3 scaled(Number s, const Vector3& v) {
  return {hn::Mul(s, v.x), hn::Mul(s, v.y), hn::Mul(s, v.z)};
}
HWY_INLINE Vector3 negated(const Vector3& v) { return {hn::Neg(v.x), hn::Neg(v.y), hn::Neg(v.z)}; }
/// a + s b
HWY_INLINE Vector3 along(const Vector3& a, Number s, const Vector3& b) { return a + scaled(s, b); }
HWY_INLINE Number dot(const Vector3& a, const Vector3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Vector3 cross(const Vector3& a, const Vector3& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)),
          hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
HWY_INLINE Number norm(const Vector3& v) { return hn::Sqrt(dot(v, v)); }
HWY_INLINE Number sumOf(const Vector3& v) { return hn::Add(hn::Add(v.x, v.y), v.z); }
HWY_INLINE Vector3 absolute(const Vector3& v) { return {hn::Abs(v.x), hn::Abs(v.y), hn::Abs(v.z)}; }
HWY_INLINE Vector3 select(Truth which, const Vector3& yes, const Vector3& no) {
  return {hn::IfThenElse(which, yes.x, no.x), hn::IfThenElse(which, yes.y, no.y),
          hn::IfThenElse(which, yes.z, no.z)};
}
/// Clamps to [-half, half]. AVX-512 has one instruction that takes the smaller magnitude with the
/// sign of the first number. For half >= 0 it gives the same bytes, including signs of zero.
HWY_INLINE Number clamped(Number half, Number value) {
#if HWY_TARGET <= HWY_AVX3
  constexpr int kSmallerMagnitude = 2;
  return Number{_mm512_range_pd(value.raw, half.raw, kSmallerMagnitude)};
#else
  return hn::Max(hn::Neg(half), hn::Min(half, value));
#endif
}
HWY_INLINE Vector3 clamped(const Vector3& half, const Vector3& v) {
  return {clamped(half.x, v.x), clamped(half.y, v.y), clamped(half.z, v.z)};
}
/// -1 below zero, else 1.
HWY_INLINE Number signOf(Number value) {
  return hn::IfThenElse(hn::Lt(value, zero()), number(-1.0), number(1.0));
}

/// The three columns of a rotation.
struct Axes {
  Vector3 x, y, z;
};
/// From the frame of the axes.
HWY_INLINE Vector3 out(const Axes& axes, const Vector3& v) {
  return along(along(scaled(v.x, axes.x), v.y, axes.y), v.z, axes.z);
}
/// To the frame of the axes.
HWY_INLINE Vector3 into(const Axes& axes, const Vector3& v) {
  return {dot(axes.x, v), dot(axes.y, v), dot(axes.z, v)};
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#endif
