#include "fastscene/dataset/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "fastscene/base/error.h"

namespace fastscene::dataset {
namespace {

void count_picture(const SetPicture& picture, Statistics& out) {
    for (const auto& [number, pixels] : picture.about.at("class_pixels").items()) {
        Statistics::Class& c = out.classes.at(std::stoul(number));
        c.pixels += pixels.get<std::int64_t>();
        ++c.pictures;
    }
    const Json& bins = picture.about.at("range_pixels");
    for (std::size_t i = 0; i < bins.size(); ++i) out.range_bins.at(i) += bins[i].get<std::int64_t>();
    for (const Json& thing : picture.about.at("instances"))
        ++out.classes.at(thing.at("class").get<std::size_t>()).things;
    for (const auto& [name, sum] : picture.about.at("files").items())
        if (name != "room_document") out.bytes[name] += sum.at("bytes").get<std::uint64_t>();
}

std::string counts_in_words(const std::map<std::string, std::int64_t>& counts) {
    std::vector<std::pair<std::string, std::int64_t>> sorted(counts.begin(), counts.end());
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    std::string text;
    for (const auto& [name, count] : sorted) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name);
    return text;
}

double percent(std::int64_t part, std::int64_t all) {
    return all > 0 ? 100 * static_cast<double>(part) / static_cast<double>(all) : 0;
}

}  // namespace

Json class_pixels_json(const ImageMask& classes) {
    std::array<std::int64_t, 256> counts{};
    for (const std::uint8_t c : classes.pixels) ++counts[c];
    Json out = Json::object();
    for (std::size_t c = 0; c < counts.size(); ++c)
        if (counts[c] > 0) out[std::to_string(c)] = counts[c];
    return out;
}

Json range_pixels_json(const ImageF& range) {
    std::array<std::int64_t, kRangeBins> bins{};
    for (const float r : range.pixels)
        if (std::isfinite(r))
            ++bins[static_cast<std::size_t>(std::clamp(static_cast<int>(r / kRangeBin_m), 0, kRangeBins - 1))];
    std::size_t used = bins.size();
    while (used > 0 && bins[used - 1] == 0) --used;
    return std::vector<std::int64_t>(bins.begin(), bins.begin() + static_cast<std::ptrdiff_t>(used));
}

std::uint64_t Statistics::all_bytes() const {
    std::uint64_t sum = 0;
    for (const auto& [name, count] : bytes) sum += count;
    return sum;
}

std::int64_t Statistics::pixels() const {
    std::int64_t sum = 0;
    for (const Class& c : classes) sum += c.pixels;
    return sum;
}

Statistics statistics_of(const DataSet& set) {
    Statistics out;
    for (const std::string& name : set.classes()) out.classes.push_back({name});
    out.range_bins.resize(kRangeBins);
    std::set<int> rooms;
    for (const SetPicture& picture : set.pictures()) {
        try {
            count_picture(picture, out);
            if (!rooms.insert(picture.room).second) continue;
            ++out.room_types[picture.about.at("room_type").get<std::string>()];
            ++out.styles[picture.about.at("style").get<std::string>()];
        } catch (const std::exception& e) {
            throw Error("{}/{}/{}.json: expected the counts of a picture: {}", set.folder().string(), picture.shard,
                        picture.name, e.what());
        }
    }
    out.pictures = static_cast<std::int64_t>(set.pictures().size());
    out.rooms = static_cast<std::int64_t>(rooms.size());
    return out;
}

Json to_json(const Statistics& s) {
    Json classes = Json::array();
    for (std::size_t i = 0; i < s.classes.size(); ++i)
        if (s.classes[i].pixels > 0)
            classes.push_back({{"class", i},
                               {"name", s.classes[i].name},
                               {"pixels", s.classes[i].pixels},
                               {"pictures", s.classes[i].pictures},
                               {"things", s.classes[i].things}});
    return {{"pictures", s.pictures},     {"rooms", s.rooms},   {"room_types", s.room_types},
            {"styles", s.styles},         {"classes", classes}, {"range_bin_m", kRangeBin_m},
            {"range_bins", s.range_bins}, {"bytes", s.bytes},   {"all_bytes", s.all_bytes()}};
}

std::string bytes_in_words(std::uint64_t bytes) {
    constexpr std::array kUnits{"kB", "MB", "GB", "TB"};
    if (bytes < 1000) return fmt::format("{} B", bytes);
    double value = static_cast<double>(bytes) / 1000;
    std::size_t unit = 0;
    while (value >= 999.95 && unit + 1 < kUnits.size()) value /= 1000, ++unit;
    return fmt::format("{:.1f} {}", value, kUnits[unit]);
}

std::string to_text(const Statistics& s) {
    std::string text = fmt::format("{} pictures of {} rooms, {}\n", s.pictures, s.rooms, bytes_in_words(s.all_bytes()));
    for (const auto& [name, bytes] : s.bytes) text += fmt::format("  {:<10}{:>10}\n", name, bytes_in_words(bytes));
    text += fmt::format("rooms: {}\nstyles: {}\n", counts_in_words(s.room_types), counts_in_words(s.styles));
    text += "class                pixels  pictures    things\n";
    for (const Statistics::Class& c : s.classes)
        if (c.pixels > 0)
            text += fmt::format("{:<18}{:>7.2f} %{:>10}{:>10}\n", c.name, percent(c.pixels, s.pixels()), c.pictures,
                                c.things);
    const std::int64_t inside = std::accumulate(s.range_bins.begin(), s.range_bins.end(), std::int64_t{0});
    text += "range in metres      pixels\n";
    for (std::size_t i = 0; i < s.range_bins.size(); ++i) {
        if (s.range_bins[i] == 0) continue;
        const float from = kRangeBin_m * static_cast<float>(i);
        const std::string to = i + 1 < s.range_bins.size() ? fmt::format("{:.1f}", from + kRangeBin_m) : "farther";
        text += fmt::format("{:>4.1f} to {:<10}{:>7.2f} %\n", from, to, percent(s.range_bins[i], inside));
    }
    text.pop_back();
    return text;
}

}  // namespace fastscene::dataset
