// The functions that the splat mathematics needs from a number type, besides + - * /, for plain floats. Jet (jet.h) and
// Lanes (lanes.h) provide their own, found by argument-dependent lookup.
#pragma once

#include <cmath>
#include <concepts>

namespace fastscene::splat {

template <std::floating_point F>
F select(bool condition, F yes, F no) {
    return condition ? yes : no;
}
template <std::floating_point F>
F exp2_fast(F x) {
    return std::exp2(x);
}

// Clamps to [low, high]; NaN becomes 0.
template <std::floating_point F>
F cut(F x, F low, F high) {
    return x >= low ? x < high ? x : high : F(0);
}
// 0 below `low`, else x.
template <std::floating_point F>
F above(F x, F low) {
    return x >= low ? x : F(0);
}
template <std::floating_point F>
F quotient(F a, F b) {
    return a / b;
}

}  // namespace fastscene::splat
