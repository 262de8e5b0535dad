// Tar archives of samples: the files of one have a common name up to its first dot (webdataset/webdataset).
#include "fastscene/base/file.h"
#include "fastscene/base/parallel.h"
#include "fastscene/dataset/format.h"
#include "fastscene/io/tar.h"

namespace fastscene::dataset_formats {
namespace {

using namespace dataset;
namespace fs = std::filesystem;

struct Archive {
    std::string name;
    std::vector<const SetPicture*> pictures;
};

std::string json_text(const SetPicture& picture) { return picture.about.dump(2) + "\n"; }

std::uint64_t sample_size(const SetPicture& picture) {
    std::uint64_t size = tar_entry_size(json_text(picture).size());
    for (const auto& [name, sum] : picture.about.at("files").items())
        size += tar_entry_size(checksum_from_json(sum).bytes);
    return size;
}

// Filled in the order of the pictures, so that the same pictures come into the same archive every time.
std::vector<Archive> archives_of(const ExportJob& job) {
    std::vector<Archive> out;
    for (std::size_t s = 0; s < kSplits.size(); ++s) {
        std::uint64_t size = kTarEndSize;
        int number = 0;
        for (const SetPicture* picture : job.splits[s]) {
            const std::uint64_t more = sample_size(*picture);
            const bool is_full = number > 0 &&
                                 (out.back().pictures.size() >= static_cast<std::size_t>(job.settings.shard_samples) ||
                                  size + more > job.settings.shard_bytes);
            if (number == 0 || is_full) {
                out.push_back({fmt::format("{}-{:06}.tar", kSplits[s], number++), {}});
                size = kTarEndSize;
            }
            out.back().pictures.push_back(picture);
            size += more;
        }
    }
    return out;
}

void add_sample(const ExportJob& job, const SetPicture& picture, TarWriter& tar) {
    for (const Channel& channel : job.set.channels()) {
        const fs::path file = job.set.file(picture, channel.name);
        tar.add(file.filename().string(), read_file(file));
    }
    tar.add(picture.name + ".json", json_text(picture));
    tar.add(picture.name + ".room.json", job.set.bytes(picture, "room_document"));
}

void write_webdataset(const ExportJob& job) {
    const std::vector<Archive> archives = archives_of(job);
    Progress progress(job.run, "pictures", static_cast<std::int64_t>(job.set.pictures().size()));
    parallel_for(static_cast<std::int64_t>(archives.size()), 1, [&](std::int64_t begin, std::int64_t) {
        const Archive& archive = archives[static_cast<std::size_t>(begin)];
        job.out.write_by(archive.name, [&](const fs::path& path) {
            write_pieces(path, [&](const auto& put) {
                TarWriter tar(put);
                for (const SetPicture* picture : archive.pictures) {
                    job.run.check_stop();
                    add_sample(job, *picture, tar);
                    progress.advance();
                }
                tar.finish();
            });
        });
    });
}

}  // namespace

DatasetFormat webdataset() {
    return {.name = "webdataset",
            .about = "tar archives of samples, for streaming",
            .readers = "webdataset, torchdata, Hugging Face datasets",
            .sharded = true,
            .write = write_webdataset};
}

}  // namespace fastscene::dataset_formats
