#include "fastscene/weights/zip_directory.h"

#include <cstdint>
#include <cstring>
#include <optional>

#include "fastscene/base/error.h"

namespace fastscene {
namespace {

// Fixed parts of the structures (APPNOTE.TXT 4.3).
constexpr std::size_t kEndSize = 22, kLocatorSize = 20, kEnd64Size = 56, kEntrySize = 46, kLocalSize = 30,
                      kLongestComment = 65535;

class Reader {
  public:
    explicit Reader(const MappedFile& file) : text_(file.text()), path_(file.path().string()) {}
    template <class T>
    T at(std::uint64_t offset) const {
        if (offset > text_.size() || text_.size() - offset < sizeof(T))
            throw Error("{}: expected a zip's directory, found the end of the file at byte {} (cut off?)", path_,
                        text_.size());
        T value;
        std::memcpy(&value, text_.data() + offset, sizeof(T));
        return value;
    }
    std::string_view part(std::uint64_t offset, std::uint64_t size) const {
        if (offset > text_.size() || text_.size() - offset < size)
            throw Error("{}: expected {} bytes at byte {} of a zip, found the end of the file (cut off?)", path_, size,
                        offset);
        return text_.substr(offset, size);
    }
    bool has(std::uint64_t offset, std::string_view signature) const {
        return offset < text_.size() && text_.substr(offset).starts_with(signature);
    }
    const std::string& path() const { return path_; }
    std::size_t size() const { return text_.size(); }

  private:
    std::string_view text_;
    std::string path_;
};

struct Directory {
    std::uint64_t begin = 0, count = 0;
};

Directory directory_of(const Reader& r) {
    std::optional<std::uint64_t> end;
    for (std::size_t back = kEndSize; back <= std::min(r.size(), kEndSize + kLongestComment); ++back)
        if (r.has(r.size() - back, "PK\x05\x06")) {
            end = r.size() - back;
            break;
        }
    if (!end) throw Error("{}: expected a whole zip, found no directory at its end (cut off?)", r.path());
    Directory directory{r.at<std::uint32_t>(*end + 16), r.at<std::uint16_t>(*end + 10)};
    if (*end >= kLocatorSize && r.has(*end - kLocatorSize, "PK\x06\x07")) {
        const auto end64 = r.at<std::uint64_t>(*end - kLocatorSize + 8);
        if (!r.has(end64, "PK\x06\x06"))
            throw Error("{}: expected a zip64 directory at byte {}, found none", r.path(), end64);
        (void)r.part(end64, kEnd64Size);
        directory = {r.at<std::uint64_t>(end64 + 48), r.at<std::uint64_t>(end64 + 32)};
    }
    return directory;
}

}  // namespace

std::map<std::string, ZipRecord> zip_records(const MappedFile& file) {
    const Reader r(file);
    const Directory directory = directory_of(r);
    std::map<std::string, ZipRecord> out;
    std::uint64_t at = directory.begin;
    for (std::uint64_t i = 0; i < directory.count; ++i) {
        if (!r.has(at, "PK\x01\x02"))
            throw Error("{}: byte {}: expected entry {} of a zip's directory, found other bytes", r.path(), at, i);
        const auto method = r.at<std::uint16_t>(at + 10);
        std::uint64_t size = r.at<std::uint32_t>(at + 24), local = r.at<std::uint32_t>(at + 42);
        std::uint64_t packed = r.at<std::uint32_t>(at + 20);
        const auto name_size = r.at<std::uint16_t>(at + 28), extra_size = r.at<std::uint16_t>(at + 30),
                   comment_size = r.at<std::uint16_t>(at + 32);
        const std::string name(r.part(at + kEntrySize, name_size));
        // zip64: the values that did not fit, in this order.
        for (std::uint64_t e = at + kEntrySize + name_size, stop = e + extra_size; e + 4 <= stop;) {
            const auto kind = r.at<std::uint16_t>(e), length = r.at<std::uint16_t>(e + 2);
            std::uint64_t field = e + 4;
            if (kind == 1) {
                if (size == 0xffffffffu) size = r.at<std::uint64_t>(field), field += 8;
                if (packed == 0xffffffffu) packed = r.at<std::uint64_t>(field), field += 8;
                if (local == 0xffffffffu) local = r.at<std::uint64_t>(field);
            }
            e += 4u + length;
        }
        at += kEntrySize + name_size + extra_size + comment_size;
        if (name.ends_with('/')) continue;
        if (!r.has(local, "PK\x03\x04"))
            throw Error("{}: {}: expected an entry at byte {}, found other bytes", r.path(), name, local);
        const std::uint64_t begin = local + kLocalSize + r.at<std::uint16_t>(local + 26) +
                                    r.at<std::uint16_t>(local + 28);
        (void)r.part(begin, method == 0 ? size : packed);
        out[name] = {begin, method == 0 ? size : 0, method != 0};
    }
    return out;
}

}  // namespace fastscene
