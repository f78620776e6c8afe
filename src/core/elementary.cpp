// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/elementary.h"

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

#include "core/arc_tangent_factors.h"

namespace meniscus::elementary {
namespace {

// The sum of two numbers of which the second is what rounding took from the first: twice the precision of one.
struct DoubleDouble {
    double high;
    double low;
};

// a + b without a rounding error, for any a and b.
DoubleDouble sum(double a, double b) {
    const double s = a + b;
    const double of_b = s - a;
    return {s, (a - (s - of_b)) + (b - of_b)};
}

// a b without a rounding error (Dekker 1971).
DoubleDouble product(double a, double b) {
    constexpr double kSplit = 0x1p27 + 1.0;
    const auto upper_half = [](double x) {
        const double scaled = kSplit * x;
        return scaled - (scaled - x);
    };
    const double p = a * b;
    const double ah = upper_half(a);
    const double bh = upper_half(b);
    const double al = a - ah;
    const double bl = b - bh;
    return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble s = sum(a.high, b.high);
    return {s.high, s.low + (a.low + b.low)};
}
DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }

// Σ factors[i] x^i
template <std::size_t n>
double polynomial(const double (&factors)[n], double x) {
    double value = factors[n - 1];
    for (std::size_t i = n - 1; i-- > 0;) value = value * x + factors[i];
    return value;
}

constexpr DoubleDouble kPi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr DoubleDouble kHalfPi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr DoubleDouble kQuarterPi{0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55};
// The first has so few bits that its products with exponents are exact.
constexpr DoubleDouble kLn2{0x1.62e42feep-1, 0x1.a39ef35793c76p-33};

// What is left of an angle without its whole quarter turns, of which only the last two bits count.
struct Reduced {
    DoubleDouble rest;  // at most π/4 in magnitude
    int quarters;
};

Reduced without_quarter_turns(double x) {
    // π/2 as three numbers, the first two of 33 bits: their products with as many quarter turns as x may have are
    // exact.
    constexpr double kFirst = 0x1.921fb544p+0;
    constexpr double kSecond = 0x1.0b4611a6p-34;
    constexpr double kThird = 0x1.3198a2e037073p-69;
    constexpr double kPerTurn = 0x1.45f306dc9c883p-1;
    const double turns = std::floor(x * kPerTurn + 0.5);
    const DoubleDouble rest = sum(x - turns * kFirst, -turns * kSecond);
    const DoubleDouble whole = sum(rest.high, rest.low - turns * kThird);
    return {whole, static_cast<int>(static_cast<long long>(turns) & 3)};
}

// Taylor's series; x is at most π/4 in magnitude.
double sine_of_rest(const DoubleDouble& x) {
    constexpr double kFactors[] = {-1.0 / 6,        1.0 / 120,         -1.0 / 5040,          1.0 / 362880,
                                   -1.0 / 39916800, 1.0 / 6227020800., -1.0 / 1307674368000, 1.0 / 355687428096000};
    const double x2 = x.high * x.high;
    return x.high + (x.high * x2 * polynomial(kFactors, x2) + x.low * (1.0 - 0.5 * x2));
}

double cosine_of_rest(const DoubleDouble& x) {
    constexpr double kFactors[] = {1.0 / 24,        -1.0 / 720,          1.0 / 40320,          -1.0 / 3628800,
                                   1.0 / 479001600, -1.0 / 87178291200., 1.0 / 20922789888000, -1.0 / 6402373705728000};
    const double x2 = x.high * x.high;
    const double half = 0.5 * x2;
    const double first = 1.0 - half;
    return first + (((1.0 - first) - half) + (x2 * x2 * polynomial(kFactors, x2) - x.high * x.low));
}

// The angle of a point in the upper half of the first quarter turn's first eighth: 0 <= y <= x, x > 0.
//
// The arc tangent of the quotient t up to tan(π/8), beyond it π/4 more than that of (t - 1) / (t + 1).
DoubleDouble angle_below_diagonal(const DoubleDouble& y, const DoubleDouble& x) {
    const bool is_turned = y.high > kTangentOfEighth * x.high;
    const DoubleDouble above = is_turned ? y + -x : y;
    const DoubleDouble below = is_turned ? y + x : x;
    const double t = above.high / below.high;
    const DoubleDouble back = product(t, below.high);
    const double lacking = (((above.high - back.high) - back.low) + (above.low - t * below.low)) / below.high;
    const double t2 = t * t;
    const double rest = t * t2 * polynomial(kArcTangentFactors, t2) + lacking / (1.0 + t2);
    return (is_turned ? kQuarterPi : DoubleDouble{0.0, 0.0}) + DoubleDouble{t, rest};
}

// The angle of a point of the upper half plane that is not the origin.
double angle_of(const DoubleDouble& y, const DoubleDouble& x) {
    const DoubleDouble across = x.high < 0.0 ? -x : x;
    DoubleDouble angle =
        y.high > across.high ? kHalfPi + -angle_below_diagonal(across, y) : angle_below_diagonal(y, across);
    if (x.high < 0.0) angle = kPi + -angle;
    return angle.high + angle.low;
}

}  // namespace

double sin(double x) {
    const auto [rest, quarters] = without_quarter_turns(x);
    const double value = quarters % 2 == 0 ? sine_of_rest(rest) : cosine_of_rest(rest);
    return quarters < 2 ? value : -value;
}

double cos(double x) {
    const auto [rest, quarters] = without_quarter_turns(x);
    const double value = quarters % 2 == 0 ? cosine_of_rest(rest) : sine_of_rest(rest);
    return quarters == 0 || quarters == 3 ? value : -value;
}

double atan2(double y, double x) {
    if (y == 0.0 && x == 0.0) return 0.0;
    const double angle = angle_of({y < 0.0 ? -y : y, 0.0}, {x, 0.0});
    return y < 0.0 ? -angle : angle;
}

// The angle of the point (x, √(1 - x²)) of the unit circle.
double acos(double x) {
    if (x >= 1.0) return 0.0;
    if (x <= -1.0) return kPi.high;
    const DoubleDouble square = product(x, x);
    const DoubleDouble left = sum(1.0, -square.high);
    const double squared = left.high + (left.low - square.low);
    const double root = std::sqrt(squared);
    const DoubleDouble back = product(root, root);
    const double lacking = ((left.high - back.high) - back.low) + (left.low - square.low);
    return angle_of({root, lacking / (2.0 * root)}, {x, 0.0});
}

// e^x = 2^k e^r with r at most ln 2 / 2 in magnitude, and Taylor's series for e^r.
double exp(double x) {
    constexpr double kLowest = -745.1332191019412;
    constexpr double kHighest = 709.782712893384;
    constexpr double kPerLn2 = 0x1.71547652b82fep+0;
    constexpr double kFactors[] = {1.0 / 6,        1.0 / 24,        1.0 / 120,        1.0 / 720,
                                   1.0 / 5040,     1.0 / 40320,     1.0 / 362880,     1.0 / 3628800,
                                   1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800.};
    if (x < kLowest) return 0.0;
    if (x > kHighest) return std::numeric_limits<double>::infinity();
    const double k = std::floor(x * kPerLn2 + 0.5);
    const DoubleDouble r = sum(x - k * kLn2.high, -k * kLn2.low);
    const double r2 = r.high * r.high;
    const DoubleDouble first = sum(1.0, r.high);
    const double rest = 0.5 * r2 + r2 * r.high * polynomial(kFactors, r.high) + r.low * (1.0 + r.high);
    return std::ldexp(first.high + (first.low + rest), static_cast<int>(k));
}

// With x = m 2^k, m from √½ to √2, f = m - 1 and s = f / (2 + f), ln m = 2 artanh s = 2 s + s Σ 2 s^2i / (2i + 1).
// Written as f - (f²/2 - s (f²/2 + Σ)), since 2 s = f - s f, only what is small is rounded.
double log(double x) {
    constexpr double kRootHalf = 0x1.6a09e667f3bcdp-1;
    constexpr double kFactors[] = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11,
                                   2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21};
    if (x == 0.0) return -std::numeric_limits<double>::infinity();
    int exponent = 0;
    double m = std::frexp(x, &exponent);
    if (m < kRootHalf) {
        m *= 2.0;
        --exponent;
    }
    const double k = exponent;
    const double f = m - 1.0;
    const double s = f / (2.0 + f);
    const double s2 = s * s;
    const double half = 0.5 * f * f;
    const double series = s2 * polynomial(kFactors, s2);
    return k * kLn2.high - ((half - (s * (half + series) + k * kLn2.low)) - f);
}

double pow(double base, int exponent) {
    double value = 1.0;
    for (int i = 0; i < exponent; ++i) value *= base;
    return value;
}

}  // namespace meniscus::elementary
