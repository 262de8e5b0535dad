// A content hash for caching and resuming (not for security): 128 bits, two mixed FNV-like lanes over 8-byte words.
// Depends on content and byte order only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "fastscene/base/random.h"

namespace fastscene {

class Hash {
  public:
    Hash& add_bytes(const void* data, std::size_t size) {
        const auto* p = static_cast<const unsigned char*>(data);
        for (std::size_t left = size; left > 0;) {
            const std::size_t take = left < 8 ? left : 8;
            std::uint64_t word = 0;
            std::memcpy(&word, p, take);
            step(word);
            p += take;
            left -= take;
        }
        step(size);  // so that "ab"+"c" differs from "a"+"bc"
        return *this;
    }
    Hash& add(std::string_view text) { return add_bytes(text.data(), text.size()); }
    template <class T>
    requires std::is_arithmetic_v<T> Hash& add(T value) { return add_bytes(&value, sizeof value); }
    template <class T>
    requires std::is_trivially_copyable_v<T> Hash& add(std::span<const T> values) {
        return add_bytes(values.data(), values.size_bytes());
    }
    // 32 hexadecimal digits.
    std::string hex() const {
        static constexpr char digits[] = "0123456789abcdef";
        std::string text;
        for (const std::uint64_t lane : {mix64(a_), mix64(b_)})
            for (int shift = 60; shift >= 0; shift -= 4) text += digits[(lane >> shift) & 15];
        return text;
    }

  private:
    void step(std::uint64_t word) {
        a_ = (a_ ^ mix64(word)) * 0x100000001b3ull;
        b_ = mix64(b_ + word);
    }
    std::uint64_t a_ = 0xcbf29ce484222325ull, b_ = 0x84222325cbf29ce4ull;
};

}  // namespace fastscene
