// An image folder for Hugging Face's datasets: a folder of pictures for each split, metadata.jsonl with a line for each
// picture, and a card whose header says where they are.
#include <set>

#include "fastscene/dataset/card.h"
#include "fastscene/dataset/format.h"
#include "fastscene/dataset/statistics.h"

namespace fastscene::dataset_formats {
namespace {

using namespace dataset;
namespace fs = std::filesystem;

// Maps that Pillow opens without loss. The others are columns of names.
bool is_image_column(std::string_view channel) { return channel != "shading" && channel != "flow"; }

std::string size_category(std::size_t count) {
    constexpr std::array kBounds{std::pair{1000u, "n<1K"}, std::pair{10000u, "1K<n<10K"},
                                 std::pair{100000u, "10K<n<100K"}, std::pair{1000000u, "100K<n<1M"}};
    for (const auto& [bound, name] : kBounds)
        if (count < bound) return name;
    return "1M<n<10M";
}

std::string card_header(const ExportJob& job) {
    std::string text = "---\n";
    if (!job.set.license().empty()) text += fmt::format("license: {}\n", job.set.license());
    text += fmt::format(
        "pretty_name: Furnished rooms\ntask_categories:\n- depth-estimation\n- image-segmentation\ntags:\n- synthetic\n"
        "- indoor\n- {}\nsize_categories:\n- {}\nconfigs:\n- config_name: default\n  data_files:\n",
        job.set.is_panorama() ? "panorama" : "perspective", size_category(job.set.pictures().size()));
    for (std::size_t s = 0; s < kSplits.size(); ++s)
        if (!job.splits[s].empty())
            text += fmt::format("  - split: {}\n    path: data/{}/**\n",
                                kSplits[s] == "val" ? "validation" : kSplits[s], kSplits[s]);
    return text + "---\n\n";
}

// Writes the picture's files, and returns its line.
std::string write_row(const ExportJob& job, const SetPicture& picture, const std::string& folder) {
    Json row = Json::object();
    for (const Channel& channel : job.set.channels()) {
        const std::string name(channel.name);
        const std::string file = fmt::format("{}/{}{}", name, picture.name,
                                             job.set.file(picture, name).extension().string());
        job.out.write(folder + file, job.set.bytes(picture, name));
        if (name == "color") row["file_name"] = file;
        else if (is_image_column(name)) row[name + "_file_name"] = file;
        else row[name] = folder + file;
    }
    for (const char* name : {"picture", "room", "room_type", "style", "prompt", "camera", "world_from_camera", "look",
                             "film", "instances", "flow_to"})
        if (picture.about.contains(name)) row[name] = picture.about[name];
    row["room_document"] = fmt::format("rooms/{:07}.json", picture.room);
    return row.dump() + "\n";
}

void write_huggingface(const ExportJob& job) {
    std::vector<std::string> rows(job.set.pictures().size());  // by place in the set
    job.for_each([&](std::size_t split, const SetPicture& picture) {
        rows[static_cast<std::size_t>(&picture - job.set.pictures().data())] = write_row(
            job, picture, fmt::format("data/{}/", kSplits[split]));
    });
    std::set<int> rooms;
    for (std::size_t s = 0; s < kSplits.size(); ++s) {
        if (job.splits[s].empty()) continue;
        std::string lines;
        for (const SetPicture* picture : job.splits[s]) {
            lines += rows[static_cast<std::size_t>(picture - job.set.pictures().data())];
            if (rooms.insert(picture->room).second)
                job.out.write(fmt::format("rooms/{:07}.json", picture->room), job.set.bytes(*picture, "room_document"));
        }
        job.out.write(fmt::format("data/{}/metadata.jsonl", kSplits[s]), lines);
    }
    job.out.write("README.md", card_header(job) + card_of(job.set, statistics_of(job.set)));
}

}  // namespace

DatasetFormat huggingface() {
    return {.name = "huggingface",
            .about = "image folders with metadata.jsonl and a card",
            .readers = "Hugging Face datasets (load_dataset(\"imagefolder\"))",
            .write = write_huggingface};
}

}  // namespace fastscene::dataset_formats
