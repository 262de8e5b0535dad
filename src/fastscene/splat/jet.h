// Jet: a number with its derivative in one direction (forward-mode automatic differentiation). The tests' reference for
// the hand-written backward passes.
#pragma once

#include <cmath>

namespace fastscene::splat {

struct Jet {
    double value = 0, slope = 0;
    constexpr Jet() = default;
    constexpr Jet(double v, double s = 0) : value(v), slope(s) {}

    friend Jet operator+(Jet a, Jet b) { return {a.value + b.value, a.slope + b.slope}; }
    friend Jet operator-(Jet a, Jet b) { return {a.value - b.value, a.slope - b.slope}; }
    friend Jet operator-(Jet a) { return {-a.value, -a.slope}; }
    friend Jet operator*(Jet a, Jet b) { return {a.value * b.value, a.slope * b.value + a.value * b.slope}; }
    friend Jet operator/(Jet a, Jet b) {
        return {a.value / b.value, (a.slope * b.value - a.value * b.slope) / (b.value * b.value)};
    }
    Jet& operator+=(Jet b) { return *this = *this + b; }
    Jet& operator-=(Jet b) { return *this = *this - b; }
    friend bool operator<(Jet a, Jet b) { return a.value < b.value; }
    friend bool operator>(Jet a, Jet b) { return a.value > b.value; }
    friend bool operator<=(Jet a, Jet b) { return a.value <= b.value; }
    friend bool operator>=(Jet a, Jet b) { return a.value >= b.value; }
};
inline Jet sqrt(Jet a) {
    const double r = std::sqrt(a.value);
    return {r, a.slope / (2 * r)};
}
inline Jet atan2(Jet y, Jet x) {
    return {std::atan2(y.value, x.value),
            (y.slope * x.value - x.slope * y.value) / (x.value * x.value + y.value * y.value)};
}
inline Jet exp(Jet a) {
    const double e = std::exp(a.value);
    return {e, e * a.slope};
}
inline Jet exp2(Jet a) {
    const double e = std::exp2(a.value);
    return {e, e * a.slope * 0.6931471805599453};
}
inline Jet exp2_fast(Jet a) { return exp2(a); }
inline Jet log2(Jet a) { return {std::log2(a.value), a.slope / (a.value * 0.6931471805599453)}; }
inline Jet reciprocal(Jet a) { return Jet(1) / a; }
inline Jet cut(Jet x, Jet low, Jet high) { return x >= low ? x < high ? x : high : Jet(0); }
inline Jet select(bool condition, Jet yes, Jet no) { return condition ? yes : no; }

}  // namespace fastscene::splat
