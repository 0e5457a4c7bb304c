#pragma once
// Several numbers side by side, which a vector unit adds or multiplies with one instruction. The
// same few functions exist for a plain `double`, so that a formula is written once for both.
//
// This file is compiled for several processors within one program. So all of it is local to the
// file that includes it: a function shared between them could need more than the processor has.

#include <cmath>
#include <cstdint>

#include "many_balls/ball_record.hpp"

// BOUNCE_NO_SIMD: the build has found that this compiler cannot read the library's vectors.
#if __has_include(<experimental/simd>) && defined(__GLIBCXX__) && !defined(BOUNCE_NO_SIMD)
#include <experimental/simd>
#define BOUNCE_HAS_SIMD 1
#else
#define BOUNCE_HAS_SIMD 0
#endif
#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace bounce::many {
namespace {

/// Asks for a ball that is needed soon: the processor goes on while it comes from memory.
#if defined(__GNUC__)
[[gnu::always_inline]] inline void ask_for(const BallRecord* ball) { __builtin_prefetch(ball); }
#else
inline void ask_for(const BallRecord*) {}
#endif

// ---- One lane: plain numbers

template <class V>
inline constexpr Slot width = 1;

inline double square_root(double a) { return std::sqrt(a); }
inline double magnitude(double a) { return std::fabs(a); }
inline double smaller(double a, double b) { return a < b ? a : b; }
inline double quotient(double a, double b, double /*one_over_b*/) { return a / b; }
inline double select(bool condition, double a, double b) { return condition ? a : b; }
inline bool any(bool condition) { return condition; }
inline double largest(double a) { return a; }
inline double lane(double a, Slot) { return a; }
template <class V>
V from_array(const double* numbers) {
  return numbers[0];
}

/// Two members side by side in the record (x and y, z and vx, ...) of each of these slots.
inline void load_pair(const double* member, const Slot* slots, double& first, double& second) {
  first = member[std::size_t{8} * slots[0]];
  second = member[std::size_t{8} * slots[0] + 1];
}
inline void store_pair(double* member, double first, double second) {
  member[0] = first;
  member[1] = second;
}

#if BOUNCE_HAS_SIMD
// ---- As many as this file is compiled for

using Lanes = std::experimental::native_simd<double>;
using LanesMask = Lanes::mask_type;

template <>
inline constexpr Slot width<Lanes> = static_cast<Slot>(Lanes::size());

/// a b + c, rounded once.
#if defined(__AVX512F__)
inline Lanes fused(const Lanes& a, const Lanes& b, const Lanes& c) {
  return Lanes(
      _mm512_fmadd_pd(static_cast<__m512d>(a), static_cast<__m512d>(b), static_cast<__m512d>(c)));
}
#elif defined(__FMA__)
inline Lanes fused(const Lanes& a, const Lanes& b, const Lanes& c) {
  return Lanes(
      _mm256_fmadd_pd(static_cast<__m256d>(a), static_cast<__m256d>(b), static_cast<__m256d>(c)));
}
#endif
inline Lanes square_root(const Lanes& a) { return std::experimental::sqrt(a); }
inline Lanes magnitude(const Lanes& a) { return std::experimental::abs(a); }
inline Lanes smaller(const Lanes& a, const Lanes& b) { return std::experimental::min(a, b); }

/// a / b to the last bit, where 1 / b is there already: the quotient's remainder, known exactly,
/// mends its last bit. Three quick instructions for a slow one. a must be 0 or larger than 1e-100,
/// so that no remainder underflows, and the same for b. (Brisebarre, Muller and Raina,
/// "Accelerating correctly rounded floating-point division when the divisor is known in advance",
/// 2004.)
// [quotient]
inline Lanes quotient(const Lanes& a, const Lanes& b, [[maybe_unused]] const Lanes& one_over_b) {
#if defined(__FMA__)
  const Lanes q = a * one_over_b;
  const Lanes remainder = fused(-q, b, a);
  return fused(remainder, one_over_b, q);
#else
  return a / b;
#endif
}
// [quotient]

#if defined(__AVX512F__)
// (Not by `where`: clang++ assigns nothing through it to a vector as wide as this.)
inline Lanes select(const LanesMask& condition, const Lanes& a, const Lanes& b) {
  const auto chosen = static_cast<__mmask8>(condition.__to_bitset().to_ulong());
  return Lanes(_mm512_mask_blend_pd(chosen, static_cast<__m512d>(b), static_cast<__m512d>(a)));
}
#else
inline Lanes select(const LanesMask& condition, const Lanes& a, Lanes b) {
  std::experimental::where(condition, b) = a;
  return b;
}
#endif
inline bool any(const LanesMask& condition) { return std::experimental::any_of(condition); }
inline double largest(const Lanes& a) { return std::experimental::hmax(a); }
inline double lane(const Lanes& a, Slot n) { return a[n]; }
template <>
inline Lanes from_array<Lanes>(const double* numbers) {
  return Lanes(numbers, std::experimental::element_aligned);
}

// A record's numbers are loaded in pairs, (x0 y0), (x1 y1), ..., and then put in order: all x into
// one vector and all y into another.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
inline void load_pair(const double* member, const Slot* slots, Lanes& first, Lanes& second) {
  const auto pair = [&](int n) { return _mm_load_pd(member + std::size_t{8} * slots[n]); };
  __m512d even = _mm512_castpd128_pd512(pair(0)), odd = _mm512_castpd128_pd512(pair(1));
  even = _mm512_insertf64x2(even, pair(2), 1), odd = _mm512_insertf64x2(odd, pair(3), 1);
  even = _mm512_insertf64x2(even, pair(4), 2), odd = _mm512_insertf64x2(odd, pair(5), 2);
  even = _mm512_insertf64x2(even, pair(6), 3), odd = _mm512_insertf64x2(odd, pair(7), 3);
  first = Lanes(_mm512_unpacklo_pd(even, odd));
  second = Lanes(_mm512_unpackhi_pd(even, odd));
}
inline void store_pair(double* member, const Lanes& first, const Lanes& second) {
  const __m512d a = static_cast<__m512d>(first), b = static_cast<__m512d>(second);
  const __m512d even = _mm512_unpacklo_pd(a, b), odd = _mm512_unpackhi_pd(a, b);
  _mm_store_pd(member, _mm512_castpd512_pd128(even));
  _mm_store_pd(member + 8, _mm512_castpd512_pd128(odd));
  _mm_store_pd(member + 16, _mm512_extractf64x2_pd(even, 1));
  _mm_store_pd(member + 24, _mm512_extractf64x2_pd(odd, 1));
  _mm_store_pd(member + 32, _mm512_extractf64x2_pd(even, 2));
  _mm_store_pd(member + 40, _mm512_extractf64x2_pd(odd, 2));
  _mm_store_pd(member + 48, _mm512_extractf64x2_pd(even, 3));
  _mm_store_pd(member + 56, _mm512_extractf64x2_pd(odd, 3));
}
#elif defined(__AVX__)
inline void load_pair(const double* member, const Slot* slots, Lanes& first, Lanes& second) {
  const auto pair = [&](int n) { return _mm_load_pd(member + std::size_t{8} * slots[n]); };
  const __m256d even = _mm256_insertf128_pd(_mm256_castpd128_pd256(pair(0)), pair(2), 1);
  const __m256d odd = _mm256_insertf128_pd(_mm256_castpd128_pd256(pair(1)), pair(3), 1);
  first = Lanes(_mm256_unpacklo_pd(even, odd));
  second = Lanes(_mm256_unpackhi_pd(even, odd));
}
inline void store_pair(double* member, const Lanes& first, const Lanes& second) {
  const __m256d a = static_cast<__m256d>(first), b = static_cast<__m256d>(second);
  const __m256d even = _mm256_unpacklo_pd(a, b), odd = _mm256_unpackhi_pd(a, b);
  _mm_store_pd(member, _mm256_castpd256_pd128(even));
  _mm_store_pd(member + 8, _mm256_castpd256_pd128(odd));
  _mm_store_pd(member + 16, _mm256_extractf128_pd(even, 1));
  _mm_store_pd(member + 24, _mm256_extractf128_pd(odd, 1));
}
#elif defined(__SSE2__)
inline void load_pair(const double* member, const Slot* slots, Lanes& first, Lanes& second) {
  const __m128d a = _mm_load_pd(member + std::size_t{8} * slots[0]);
  const __m128d b = _mm_load_pd(member + std::size_t{8} * slots[1]);
  first = Lanes(_mm_unpacklo_pd(a, b));
  second = Lanes(_mm_unpackhi_pd(a, b));
}
inline void store_pair(double* member, const Lanes& first, const Lanes& second) {
  const __m128d a = static_cast<__m128d>(first), b = static_cast<__m128d>(second);
  _mm_store_pd(member, _mm_unpacklo_pd(a, b));
  _mm_store_pd(member + 8, _mm_unpackhi_pd(a, b));
}
#else
inline void load_pair(const double* member, const Slot* slots, Lanes& first, Lanes& second) {
  first = Lanes([&](auto n) { return member[std::size_t{8} * slots[n]]; });
  second = Lanes([&](auto n) { return member[std::size_t{8} * slots[n] + 1]; });
}
inline void store_pair(double* member, const Lanes& first, const Lanes& second) {
  for (Slot n = 0; n < width<Lanes>; ++n) {
    member[8 * n] = first[n];
    member[8 * n + 1] = second[n];
  }
}
#endif
#else
using Lanes = double;  // no vectors in this library: one lane
#endif

}  // namespace
}  // namespace bounce::many
