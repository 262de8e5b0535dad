// KSPLAT of GaussianSplats3D: a header of 4096 bytes, 1024 bytes for each section, then the sections: buckets and
// splats. Little endian. Level 0 holds floats; levels 1 and 2 hold half floats, and positions relative to the middle of
// a bucket; level 2 holds harmonics in bytes. Written in level 0, as one section.
#include <algorithm>
#include <cmath>

#include "fastscene/base/bytes.h"
#include "fastscene/io/packed.h"
#include "fastscene/io/splat_format.h"

namespace fastscene::splat_formats {
namespace {

constexpr std::size_t kHeader = 4096, kSection = 1024;
constexpr std::uint32_t kMostSections = 65536;  // sanity limit
constexpr int kHighestSh = 2;                   // the format's
constexpr std::size_t kHarmonicsOfDegree[] = {0, 3, 5};
constexpr float kShHalfRange = 1.5f;            // of harmonics in bytes, unless the header says another
constexpr std::uint32_t kHalfwayUp = 32767;     // positions of levels 1 and 2: this is the middle of a bucket
constexpr std::uint8_t kMajor = 0, kMinor = 1;  // version

float float_of_half(std::uint16_t h) {
    const int exponent = h >> 10 & 31, mantissa = h & 1023;
    const float size = exponent == 0    ? std::ldexp(static_cast<float>(mantissa), -24)
                       : exponent == 31 ? (mantissa ? NAN : INFINITY)
                                        : std::ldexp(static_cast<float>(mantissa + 1024), exponent - 25);
    return h & 0x8000 ? -size : size;
}

struct Section {
    std::size_t splats = 0, capacity = 0;
    std::size_t bucket_size = 0, buckets = 0, bucket_bytes = 0, full_buckets = 0, part_buckets = 0;
    float step_m = 0;  // of positions in buckets
    std::uint32_t middle = kHalfwayUp;
    int degree = 0;
};

class Ksplat {
  public:
    Ksplat(const std::filesystem::path& file, std::string_view bytes) : bytes_(bytes), in_(file, bytes) {
        const auto major = in_.get<std::uint8_t>(), minor = in_.get<std::uint8_t>();
        if (major != kMajor || minor != kMinor)
            in_.refuse(fmt::format("expected KSPLAT version {}.{}, found {}.{}", kMajor, kMinor, major, minor));
        in_.skip(2);
        most_sections_ = in_.get<std::uint32_t>();
        (void)in_.get<std::uint32_t>();
        if (most_sections_ > kMostSections)
            in_.refuse(fmt::format("expected at most {} sections, found {}", kMostSections, most_sections_));
        in_.skip(8);
        level_ = in_.get<std::uint16_t>();
        if (level_ > 2) in_.refuse(fmt::format("expected compression level 0, 1 or 2, found {}", level_));
        in_.skip(14);  // padding and the middle of the scene, which positions do not depend on
        low_ = in_.get<float>(), high_ = in_.get<float>();
        if (!(low_ < 0) || !(high_ > 0)) low_ = -kShHalfRange, high_ = kShHalfRange;
        in_.skip(kHeader - in_.at());
    }
    Splats splats() {
        std::vector<Section> sections;
        for (std::uint32_t i = 0; i < most_sections_; ++i) sections.push_back(section());
        Splats out;
        for (const Section& s : sections) out.sh_degree = std::max(out.sh_degree, s.degree);
        for (const Section& s : sections) add(s, out);
        return out;
    }

  private:
    Section section() {
        const std::size_t end = in_.at() + kSection;
        Section s;
        s.splats = in_.get<std::uint32_t>(), s.capacity = in_.get<std::uint32_t>();
        s.bucket_size = in_.get<std::uint32_t>(), s.buckets = in_.get<std::uint32_t>();
        const float block_m = in_.get<float>();
        s.bucket_bytes = in_.get<std::uint16_t>();
        in_.skip(2);
        if (const auto middle = in_.get<std::uint32_t>(); middle > 0) s.middle = middle;
        in_.skip(4);
        s.full_buckets = in_.get<std::uint32_t>(), s.part_buckets = in_.get<std::uint32_t>();
        s.degree = in_.get<std::uint16_t>();
        if (s.degree > kHighestSh) in_.refuse(fmt::format("expected harmonics of degree 0 to 2, found {}", s.degree));
        if (s.splats > s.capacity)
            in_.refuse(fmt::format("expected at most {} splats in a section, found {}", s.capacity, s.splats));
        s.step_m = block_m / 2 / static_cast<float>(s.middle);
        in_.skip(end - in_.at());
        return s;
    }
    std::size_t number_bytes() const { return level_ == 0 ? 4 : 2; }
    std::size_t harmonic_bytes() const { return level_ == 0 ? 4 : level_ == 1 ? 2 : 1; }
    std::size_t splat_bytes(int degree) const {
        const auto d = static_cast<std::size_t>(degree);
        return 10 * number_bytes() + 4 + 3 * ((d + 1) * (d + 1) - 1) * harmonic_bytes();
    }
    float number() { return level_ == 0 ? in_.get<float>() : float_of_half(in_.get<std::uint16_t>()); }
    float harmonic() {
        if (level_ < 2) return number();
        return low_ + (high_ - low_) * static_cast<float>(in_.get<std::uint8_t>()) / 255.f;
    }
    // Where the splats of each partly filled bucket end.
    std::vector<std::size_t> ends_of_part_buckets(const Section& s) {
        if (s.part_buckets > in_.left() / 4)
            in_.refuse(fmt::format("expected {} lengths of buckets, found {} bytes", s.part_buckets, in_.left()));
        std::vector<std::size_t> ends;
        std::size_t at = s.full_buckets * s.bucket_size;
        for (std::size_t i = 0; i < s.part_buckets; ++i) ends.push_back(at += in_.get<std::uint32_t>());
        return ends;
    }
    std::size_t bucket_of(const Section& s, const std::vector<std::size_t>& ends, std::size_t splat) const {
        if (splat < s.full_buckets * s.bucket_size) return splat / s.bucket_size;
        return s.full_buckets +
               static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), splat) - ends.begin());
    }
    void add(const Section& s, Splats& out) {
        const std::vector<std::size_t> ends = ends_of_part_buckets(s);
        const std::size_t middles = in_.at(), row = splat_bytes(s.degree);
        if (s.bucket_bytes > 0 && s.buckets > in_.left() / s.bucket_bytes)
            in_.refuse(
                fmt::format("expected {} buckets of {} bytes, found {} bytes", s.buckets, s.bucket_bytes, in_.left()));
        in_.skip(s.buckets * s.bucket_bytes);
        if (s.splats > in_.left() / row)
            in_.refuse(fmt::format("expected {} splats of {} bytes, found {} bytes", s.splats, row, in_.left()));
        const std::size_t first = out.size(), end = in_.at() + s.capacity * row;
        out.resize(first + s.splats);
        for (std::size_t i = 0; i < s.splats; ++i) {
            Vec3f middle;
            if (level_ > 0) {
                const std::size_t bucket = bucket_of(s, ends, i);
                if (bucket >= s.buckets || s.bucket_bytes < 12)
                    in_.refuse(fmt::format("expected a bucket for splat {}, found {} buckets", i, s.buckets));
                for (std::size_t a = 0; a < 3; ++a)
                    middle[a] = number_at<float>(bytes_, middles + bucket * s.bucket_bytes + 4 * a);
            }
            read_splat(s, middle, first + i, out);
        }
        in_.skip(std::min(end - in_.at(), in_.left()));
    }
    void read_splat(const Section& s, Vec3f middle, std::size_t i, Splats& out) {
        for (std::size_t a = 0; a < 3; ++a)
            out.mean_m[i][a] = level_ == 0 ? in_.get<float>()
                                           : middle[a] + (static_cast<float>(in_.get<std::uint16_t>()) -
                                                          static_cast<float>(s.middle)) *
                                                             s.step_m;
        for (std::size_t a = 0; a < 3; ++a) out.log_scale[i][a] = std::log(number());
        const float w = number(), x = number(), y = number(), z = number();
        out.rotation[i] = {w, x, y, z};
        const auto share = [&] { return static_cast<float>(in_.get<std::uint8_t>()) / 255.f; };
        for (std::size_t c = 0; c < 3; ++c) out.sh0[i][c] = (share() - 0.5f) / kSh0;
        out.opacity_logit[i] = logit_of(share());
        const auto k = static_cast<std::size_t>(out.rest_coefficients());
        std::size_t before = 0;
        for (int d = 1; d <= s.degree; before += kHarmonicsOfDegree[d++])
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t n = 0; n < kHarmonicsOfDegree[d]; ++n)
                    out.sh_rest[(3 * i + c) * k + before + n] = harmonic();
    }

    std::string_view bytes_;
    ByteReader in_;
    std::uint32_t most_sections_ = 0;
    int level_ = 0;
    float low_ = 0, high_ = 0;
};

ReadSplats read_ksplat(const std::filesystem::path& file, std::string_view bytes) {
    return Ksplat(file, bytes).splats();
}

std::string headers_of(const Splats& s) {
    const auto count = static_cast<std::uint32_t>(s.size());
    std::string out;
    for (const std::uint8_t v : {kMajor, kMinor, std::uint8_t{0}, std::uint8_t{0}}) append(out, v);
    for (const std::uint32_t v : {1u, 1u, count, count}) append(out, v);
    out.append(kHeader - out.size(), '\0');
    append(out, count), append(out, count);
    out.append(32, '\0');  // no buckets
    append(out, static_cast<std::uint16_t>(s.sh_degree));
    out.append(kHeader + kSection - out.size(), '\0');
    return out;
}

std::string write_ksplat(const Splats& s, const SplatWriting&) {
    std::string out = headers_of(s);
    const auto k = static_cast<std::size_t>(s.rest_coefficients());
    for (std::size_t i = 0; i < s.size(); ++i) {
        for (std::size_t a = 0; a < 3; ++a) append(out, s.mean_m[i][a]);
        for (std::size_t a = 0; a < 3; ++a) append(out, std::exp(s.log_scale[i][a]));
        for (const float q : unit_quaternion(s.rotation[i])) append(out, q);
        for (std::size_t c = 0; c < 3; ++c) append(out, byte_near((s.sh0[i][c] * kSh0 + 0.5f) * 255.f));
        append(out, byte_near(sigmoid(s.opacity_logit[i]) * 255.f));
        std::size_t before = 0;
        for (int d = 1; d <= s.sh_degree; before += kHarmonicsOfDegree[d++])
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t n = 0; n < kHarmonicsOfDegree[d]; ++n)
                    append(out, s.sh_rest[(3 * i + c) * k + before + n]);
    }
    return out;
}

}  // namespace

SplatFormat ksplat() {
    return {.name = "ksplat",
            .ending = ".ksplat",
            .about = "GaussianSplats3D's format; read with any compression, written without",
            .readers = "GaussianSplats3D, Spark",
            .sh_degree = kHighestSh,
            .antialias = false,
            .low_pass = false,
            .precision = {.opacity_logit = 0.05f, .sh0 = 0.0071f},
            .read = read_ksplat,
            .write = write_ksplat};
}

}  // namespace fastscene::splat_formats
