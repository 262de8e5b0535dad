#include "fastscene/dataset/card.h"

#include <algorithm>

#include "fastscene/base/file.h"

namespace fastscene::dataset {
namespace {

constexpr int kLongestBar = 40;  // characters

std::string bar(std::int64_t part, std::int64_t most) {
    if (most <= 0) return "";
    return std::string(static_cast<std::size_t>((kLongestBar * part + most / 2) / most), '#');
}

std::string channels_table(const DataSet& set, const Statistics& statistics) {
    std::string text = "| map | bytes | content |\n|---|---:|---|\n";
    for (const Channel& channel : set.channels()) {
        const auto bytes = statistics.bytes.find(std::string(channel.name));
        text += fmt::format("| {} | {} | {} |\n", channel.name,
                            bytes_in_words(bytes == statistics.bytes.end() ? 0 : bytes->second), channel.about);
    }
    return text;
}

std::string counts_table(const char* what, const std::map<std::string, std::int64_t>& counts) {
    std::string text = fmt::format("| {} | rooms |\n|---|---:|\n", what);
    for (const auto& [name, count] : counts) text += fmt::format("| {} | {} |\n", name, count);
    return text;
}

std::string classes_table(const Statistics& s) {
    std::string text = "| number | class | share of pixels | pictures | things seen |\n|---:|---|---:|---:|---:|\n";
    for (std::size_t i = 0; i < s.classes.size(); ++i)
        if (const Statistics::Class& c = s.classes[i]; c.pixels > 0)
            text += fmt::format("| {} | {} | {:.3f} % | {} | {} |\n", i, c.name,
                                100 * static_cast<double>(c.pixels) / static_cast<double>(s.pixels()), c.pictures,
                                c.things);
    return text;
}

std::string range_chart(const Statistics& s) {
    const std::int64_t most = *std::max_element(s.range_bins.begin(), s.range_bins.end());
    std::size_t used = s.range_bins.size();
    while (used > 0 && s.range_bins[used - 1] == 0) --used;
    std::string text = "```\n";
    for (std::size_t i = 0; i < used; ++i)
        text += fmt::format("{:>4.1f} m{} {}\n", kRangeBin_m * static_cast<float>(i),
                            i + 1 == s.range_bins.size() ? "+" : " ", bar(s.range_bins[i], most));
    return text + "```\n";
}

}  // namespace

std::string card_of(const DataSet& set, const Statistics& s) {
    std::string text = fmt::format("# {} {} of {} furnished rooms\n\n", s.pictures,
                                   set.is_panorama() ? "panoramas" : "perspective pictures", s.rooms);
    text += fmt::format(
        "Rendered pictures of {} x {} pixels with exact maps and cameras, {} in all. Pictures of one room share its "
        "world and its light.\n\n```\n{} -o DIR\n```\n\nmakes the same bytes (fastscene {}), with any number of "
        "processes. `fastscene dataset verify` finds damaged files, `fastscene dataset export` writes other "
        "formats.\n\n",
        set.width(), set.height(), bytes_in_words(s.all_bytes()), command_of(set.made()),
        set.settings().value("program", ""));
    text += "## Maps\n\n" + channels_table(set, s);
    text += fmt::format(
        "\nEach picture's JSON has its camera, pose, prompt, room, things and film; `{}` is the first room as "
        "planned.\n\n",
        room_document_name(0));
    text += "## Rooms\n\n" + counts_table("type", s.room_types) + "\n" + counts_table("style", s.styles);
    text += "\n## Classes\n\nNYU40.\n\n" + classes_table(s);
    text += fmt::format("\n## Ranges\n\nPixels by metres along the ray, in steps of {:.1f} m.\n\n", kRangeBin_m) +
            range_chart(s);
    text += fmt::format(
        "\n## Licence\n\n{}\n\nThe rooms, their things, patterns and views are computed by fastscene (Apache License "
        "2.0). "
        "The pictures contain no photographs, scans, models or textures by others.\n",
        set.license().empty() ? "None chosen yet: whoever publishes the set chooses one (`fastscene dataset card DIR "
                                "--license NAME`)."
                              : set.license());
    return text;
}

std::filesystem::path write_card(const std::filesystem::path& folder) {
    const DataSet set(folder, true);
    const std::filesystem::path path = folder / "README.md";
    write_file(path, card_of(set, statistics_of(set)));
    return path;
}

void choose_license(const std::filesystem::path& folder, const std::string& license) {
    Json settings = read_set_settings(folder);
    settings["license"] = license;
    write_json(folder / "dataset.json", settings);
}

}  // namespace fastscene::dataset
