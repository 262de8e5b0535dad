// Counter-based random numbers that depend only on (seed, stream name, index): any thread may draw them in any order
// with the same result.
#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>

namespace fastscene {

// One round of SplitMix64, a good 64-bit mixer (Steele, Lea, Flood 2014).
constexpr std::uint64_t mix64(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

// FNV-1a hash of a stream's name.
constexpr std::uint64_t hash_name(std::string_view name) {
    std::uint64_t h = 0xcbf29ce484222325ull;
    for (const char c : name) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    return h;
}

class Random {
  public:
    Random(std::uint64_t seed, std::string_view stream, std::uint64_t index = 0)
        : state_(mix64(seed ^ mix64(hash_name(stream) ^ mix64(index)))) {}
    // For inner loops: the caller has mixed its own key.
    explicit Random(std::uint64_t key) : state_(mix64(key)) {}

    std::uint64_t next_u64() { return mix64(state_ += 0x9e3779b97f4a7c15ull); }
    std::uint32_t next_u32() { return static_cast<std::uint32_t>(next_u64() >> 32); }
    // Uniform in [0, 1).
    float uniform() { return static_cast<float>(next_u64() >> 40) * 0x1p-24f; }
    float uniform(float low, float high) { return low + (high - low) * uniform(); }
    // Uniform in {0, …, count-1}; count > 0.
    int index(int count) {
        return static_cast<int>((static_cast<std::uint64_t>(next_u32()) * static_cast<std::uint64_t>(count)) >> 32);
    }
    bool chance(float probability) { return uniform() < probability; }
    // Standard normal (Box-Muller, one of the pair).
    float normal() {
        const float u = 1.f - uniform(), v = uniform();
        return std::sqrt(-2.f * std::log(u)) * std::cos(6.2831853f * v);
    }

  private:
    std::uint64_t state_;
};

}  // namespace fastscene
