// SPDX-FileCopyrightText: 2026 The collision_monitor authors
// SPDX-License-Identifier: BSD-3-Clause
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow_phase/mesh_front/front_lanes.cpp"
#include "hwy/foreach_target.h"
// The order matters: Highway first includes this file once for each target.
#include "hwy/highway.h"
#include "narrow_phase/mesh_front/front_entries.h"
#include "narrow_phase/mesh_front/front_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace collision_monitor {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// No fused multiply-add, so that every instruction set rounds alike.
using Many = hn::ScalableTag<float>;
using Codes = hn::Rebind<std::int32_t, Many>;
using Number = hn::Vec<Many>;
using Code = hn::Vec<Codes>;

// Of this file alone: other files have a Vector of other members.
namespace {

struct Vector {
  Number x, y, z;
};

constexpr float kInfinite = __builtin_huge_valf();

HWY_INLINE Number number(float value) { return hn::Set(Many(), value); }

HWY_INLINE Number dot(const Vector& a, const Vector& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE Vector vector(float x, float y, float z) { return {number(x), number(y), number(z)}; }

template <int kShift>
HWY_INLINE Number unpacked(Code code) {
  const Code bits = hn::And(hn::ShiftRight<kShift>(code), hn::Set(Codes(), (1 << kPackedBits) - 1));
  return hn::ConvertTo(Many(), hn::Sub(bits, hn::Set(Codes(), kPackedMiddle)));
}

HWY_INLINE Vector vectorOf(Code code) {
  return {unpacked<2 * kPackedBits>(code), unpacked<kPackedBits>(code), unpacked<0>(code)};
}

HWY_INLINE Code load(const std::uint32_t* from) {
  return hn::BitCast(Codes(), hn::Load(hn::RebindToUnsigned<Codes>(), from));
}

// A step, the same in all lanes.
struct Step {
  Vector rows[3], columns[3];
  Vector shift;
};

HWY_INLINE Step everywhere(const FrontStep& step) {
  const auto& t = step.turn;
  return {{vector(t[0][0], t[0][1], t[0][2]), vector(t[1][0], t[1][1], t[1][2]),
           vector(t[2][0], t[2][1], t[2][2])},
          {vector(t[0][0], t[1][0], t[2][0]), vector(t[0][1], t[1][1], t[2][1]),
           vector(t[0][2], t[1][2], t[2][2])},
          vector(step.shift[0], step.shift[1], step.shift[2])};
}

// What the step adds to the bounds, without the slack.
HWY_INLINE Number gain(const FrontStep& step, const Step& all, Code direction, Code center,
                       Code extent) {
  const Vector n = vectorOf(direction);
  const Vector in_units = vectorOf(center);
  const Number unit = number(step.center_unit);
  const Vector c{hn::Mul(unit, in_units.x), hn::Mul(unit, in_units.y), hn::Mul(unit, in_units.z)};
  const Number r =
      hn::Mul(number(step.radius_unit), hn::ConvertTo(Many(), hn::ShiftRight<8>(extent)));
  const Vector delta{hn::Add(dot(all.rows[0], c), all.shift.x),
                     hn::Add(dot(all.rows[1], c), all.shift.y),
                     hn::Add(dot(all.rows[2], c), all.shift.z)};
  const Vector turned{dot(all.columns[0], n), dot(all.columns[1], n), dot(all.columns[2], n)};
  const Number lost = hn::Mul(r, hn::Sqrt(dot(turned, turned)));
  const Number in_bits = hn::Sub(dot(n, delta), lost);
  // Each coordinate of a packed direction is off by at most half a bit.
  constexpr float kLength = kPackedMiddle - 1;
  constexpr float kOff = 0.87F;
  const Number along = hn::Min(hn::Mul(in_bits, number(1.0F / (kLength - kOff))),
                               hn::Mul(in_bits, number(1.0F / (kLength + kOff))));
  const Number anywhere =
      hn::Neg(hn::Add(hn::Sqrt(dot(delta, delta)), hn::Mul(r, number(step.size))));
  const auto has_none = hn::RebindMask(Many(), hn::Eq(direction, hn::Zero(Codes())));
  return hn::IfThenElse(has_none, anywhere, along);
}

}  // namespace

void loosenAll(const FrontStep& step, MeshFront& front) {
  constexpr float kUlp = 1.2e-7F;
  const Step all = everywhere(step);
  const auto lanes = static_cast<std::uint32_t>(hn::Lanes(Many()));
  for (std::uint32_t i = 0; i < front.size; i += lanes) {
    MeshFront::Block& block = blockOf(i, front);
    const std::size_t at = placeOf(i);
    const Number grown = gain(step, all, load(&block.direction[at]), load(&block.center[at]),
                              load(&block.extent[at]));
    const Number bound =
        hn::Add(hn::Load(Many(), &block.bound[at]), hn::Sub(grown, number(step.slack)));
    hn::Store(hn::Sub(bound, hn::Mul(number(kUlp), hn::Abs(bound))), Many(), &block.bound[at]);
  }
}

// The bounds of some pairs. Lanes after the last pair are infinitely far.
HWY_INLINE Number boundsFrom(std::uint32_t at, const MeshFront& front) {
  const auto left = static_cast<std::size_t>(front.size - at);
  const Number bounds = hn::Load(Many(), &blockOf(at, front).bound[placeOf(at)]);
  return left >= hn::Lanes(Many())
             ? bounds
             : hn::IfThenElse(hn::FirstN(Many(), left), bounds, number(kInfinite));
}

std::uint32_t findBelow(float goal, std::uint32_t from, const MeshFront& front) {
  const auto lanes = static_cast<std::uint32_t>(hn::Lanes(Many()));
  for (std::uint32_t i = from - from % lanes; i < front.size; i += lanes) {
    const auto is_below = hn::AndNot(hn::FirstN(Many(), from > i ? from - i : 0),
                                     hn::Lt(boundsFrom(i, front), number(goal)));
    const auto first = hn::FindFirstTrue(Many(), is_below);
    if (first >= 0) {
      return i + static_cast<std::uint32_t>(first);
    }
  }
  return front.size;
}

std::uint32_t countAllBelow(float goal, const MeshFront& front) {
  const auto lanes = static_cast<std::uint32_t>(hn::Lanes(Many()));
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < front.size; i += lanes) {
    count += hn::CountTrue(Many(), hn::Lt(boundsFrom(i, front), number(goal)));
  }
  return static_cast<std::uint32_t>(count);
}

float leastOfAll(const MeshFront& front) {
  const auto lanes = static_cast<std::uint32_t>(hn::Lanes(Many()));
  Number least = number(kInfinite);
  for (std::uint32_t i = 0; i < front.size; i += lanes) {
    least = hn::Min(least, boundsFrom(i, front));
  }
  return hn::GetLane(hn::MinOfLanes(Many(), least));
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace collision_monitor
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace collision_monitor {
namespace {

HWY_EXPORT(loosenAll);
HWY_EXPORT(findBelow);
HWY_EXPORT(countAllBelow);
HWY_EXPORT(leastOfAll);

}  // namespace

void loosen(const FrontStep& step, MeshFront& front) noexcept {
  HWY_DYNAMIC_DISPATCH(loosenAll)(step, front);
}

std::uint32_t nextBelow(float goal, std::uint32_t from, const MeshFront& front) noexcept {
  return HWY_DYNAMIC_DISPATCH(findBelow)(goal, from, front);
}

std::uint32_t countBelow(float goal, const MeshFront& front) noexcept {
  return HWY_DYNAMIC_DISPATCH(countAllBelow)(goal, front);
}

float leastBound(const MeshFront& front) noexcept {
  return HWY_DYNAMIC_DISPATCH(leastOfAll)(front);
}

}  // namespace collision_monitor
#endif
