// Little-endian numbers in byte strings, as on all supported machines.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>

#include "fastscene/base/error.h"

namespace fastscene {

template <class T>
void append(std::string& out, T value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    out.append(bytes, sizeof value);
}

template <class T>
T number_at(std::string_view bytes, std::size_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

// Sequential reader that reports its position if the bytes end too early.
class ByteReader {
  public:
    ByteReader(const std::filesystem::path& path, std::string_view bytes) : path_(path), bytes_(bytes) {}

    template <class T>
    T get() {
        need(sizeof(T));
        const T value = number_at<T>(bytes_, at_);
        at_ += sizeof value;
        return value;
    }
    // Reads up to a zero byte, which is skipped.
    std::string text() {
        const std::size_t end = bytes_.find('\0', at_);
        if (end == std::string_view::npos) refuse("expected a text with a zero byte at its end, found none");
        std::string out(bytes_.substr(at_, end - at_));
        at_ = end + 1;
        return out;
    }
    // A 64-bit count of items that take at least `least` bytes each.
    std::size_t count(std::size_t least) {
        const auto n = get<std::uint64_t>();
        if (n > (bytes_.size() - at_) / least)
            refuse(
                fmt::format("expected {} entries of {} bytes or more, found {} bytes", n, least, bytes_.size() - at_));
        return static_cast<std::size_t>(n);
    }
    void skip(std::size_t bytes) {
        need(bytes);
        at_ += bytes;
    }
    std::size_t at() const { return at_; }
    std::size_t left() const { return bytes_.size() - at_; }
    [[noreturn]] void refuse(const std::string& what) const {
        throw Error("{}: byte {}: {}", path_.string(), at_, what);
    }

  private:
    void need(std::size_t wanted) const {
        if (bytes_.size() - at_ < wanted)
            refuse(fmt::format("expected {} more bytes, found {}", wanted, bytes_.size() - at_));
    }
    std::filesystem::path path_;
    std::string_view bytes_;
    std::size_t at_ = 0;
};

}  // namespace fastscene
