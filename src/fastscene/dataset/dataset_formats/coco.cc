// COCO's panoptic format: a JSON for each split, and a PNG for each picture whose colors are the numbers of segments.
#include <map>

#include "fastscene/base/error.h"
#include "fastscene/dataset/format.h"
#include "fastscene/dataset/nyu40_colors.h"
#include "fastscene/io/image_io.h"

namespace fastscene::dataset_formats {
namespace {

using namespace dataset;

// Numbers of things are those of the instance map; a part of the shell has this plus its class.
constexpr std::uint32_t kFirstShellSegment = 1u << 16;

struct Segment {
    int nyu40 = 0;
    std::int64_t area = 0;
    int left = 0, top = 0, right = 0, bottom = 0;  // its outermost pixels
    void add(int x, int y) {
        if (area++ == 0) left = right = x, top = bottom = y;
        left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
    }
};

Rgb8 color_of_segment(std::uint32_t id) {
    return {static_cast<std::uint8_t>(id), static_cast<std::uint8_t>(id >> 8), static_cast<std::uint8_t>(id >> 16)};
}

// Writes the picture's PNG, and returns its annotation.
Json annotate(const ExportJob& job, const SetPicture& picture, const std::string& folder) {
    const ImageMask classes = load_mask_png(job.set.file(picture, "class"));
    const ImageF instances = load_float(job.set.file(picture, "instance"), 1.f);
    if (!classes.same_size(instances)) throw Error("{}: expected class and instance maps of one size", picture.name);
    ImageRgb8 segments_png(classes.width, classes.height);
    std::map<std::uint32_t, Segment> segments;
    for (int y = 0; y < classes.height; ++y)
        for (int x = 0; x < classes.width; ++x) {
            const int nyu40 = classes.at(x, y);
            if (nyu40 == 0) continue;  // the outside has no label
            const std::uint32_t id = is_shell_class(nyu40) ? kFirstShellSegment + static_cast<std::uint32_t>(nyu40)
                                                           : static_cast<std::uint32_t>(instances.at(x, y));
            segments[id].nyu40 = nyu40;
            segments[id].add(x, y);
            segments_png.at(x, y) = color_of_segment(id);
        }
    const std::string name = picture.name + ".png";
    job.out.write_by(folder + name, [&](const std::filesystem::path& path) { save_png(path, segments_png); });
    Json infos = Json::array();
    for (const auto& [id, s] : segments)
        infos.push_back({{"id", id},
                         {"category_id", s.nyu40},
                         {"area", s.area},
                         {"bbox", {s.left, s.top, s.right - s.left + 1, s.bottom - s.top + 1}},
                         {"iscrowd", 0}});
    return {{"image_id", picture.number}, {"file_name", name}, {"segments_info", std::move(infos)}};
}

Json categories_of(const DataSet& set) {
    Json out = Json::array();
    const std::vector<std::string> names = set.classes();
    for (std::size_t i = 1; i < names.size(); ++i) {
        const bool is_shell = is_shell_class(static_cast<int>(i));
        const Rgb8 color = kNyu40Colors.at(i);
        out.push_back({{"id", i},
                       {"name", names[i]},
                       {"supercategory", is_shell ? "shell" : "thing"},
                       {"isthing", is_shell ? 0 : 1},
                       {"color", {color.r, color.g, color.b}}});
    }
    return out;
}

void write_coco(const ExportJob& job) {
    const std::size_t count = job.set.pictures().size();
    std::vector<Json> images(count), annotations(count);  // by place in the set
    job.for_each([&](std::size_t split, const SetPicture& picture) {
        const auto place = static_cast<std::size_t>(&picture - job.set.pictures().data());
        const std::filesystem::path color = job.set.file(picture, "color");
        const std::string name = picture.name + color.extension().string();
        job.out.write(fmt::format("{}/{}", kSplits[split], name), job.set.bytes(picture, "color"));
        images[place] = {{"id", picture.number},
                         {"file_name", name},
                         {"width", job.set.width()},
                         {"height", job.set.height()},
                         {"license", 1}};
        annotations[place] = annotate(job, picture, fmt::format("annotations/panoptic_{}/", kSplits[split]));
    });
    const Json info{{"description", "Furnished rooms, made by " + command_of(job.set.made())},
                    {"version", job.set.settings().value("program", "")}};
    const Json licenses{{{"id", 1}, {"name", job.set.license()}, {"url", ""}}};
    for (std::size_t s = 0; s < kSplits.size(); ++s) {
        if (job.splits[s].empty()) continue;
        Json file{{"info", info},
                  {"licenses", Json::array({licenses[0]})},
                  {"images", Json::array()},
                  {"annotations", Json::array()},
                  {"categories", categories_of(job.set)}};
        for (const SetPicture* picture : job.splits[s]) {
            const auto place = static_cast<std::size_t>(picture - job.set.pictures().data());
            file["images"].push_back(std::move(images[place]));
            file["annotations"].push_back(std::move(annotations[place]));
        }
        job.out.write(fmt::format("annotations/panoptic_{}.json", kSplits[s]), file.dump() + "\n");
    }
}

}  // namespace

DatasetFormat coco() {
    return {.name = "coco",
            .about = "COCO panoptic JSON and PNG",
            .readers = "panopticapi, detectron2, mmdetection",
            .write = write_coco};
}

}  // namespace fastscene::dataset_formats
