// Sources: read back from run.json as written, and each input file opened once per run.
#include "fastscene/pipeline/source.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>

#include "fastscene/base/file.h"
#include "fastscene/io/image_io.h"
#include "fastscene/pipeline/pipeline.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

// Counts how often a file is opened (inotify).
class OpenCount {
  public:
    explicit OpenCount(const fs::path& file) : descriptor_(::inotify_init1(IN_NONBLOCK)) {
        ::inotify_add_watch(descriptor_, file.c_str(), IN_OPEN);
    }
    ~OpenCount() { ::close(descriptor_); }
    OpenCount(const OpenCount&) = delete;
    OpenCount& operator=(const OpenCount&) = delete;
    int count() {
        alignas(inotify_event) std::array<char, 4096> buffer;
        for (ssize_t size; (size = ::read(descriptor_, buffer.data(), buffer.size())) > 0;)
            for (char* at = buffer.data(); at < buffer.data() + size;) {
                const auto* event = reinterpret_cast<const inotify_event*>(at);
                count_ += (event->mask & IN_OPEN) != 0;
                at += sizeof(inotify_event) + event->len;
            }
        return count_;
    }

  private:
    int descriptor_, count_ = 0;
};

fs::path empty_folder(const char* name) {
    const fs::path folder = fs::path(::testing::TempDir()) / (std::string("fastscene-source-") + name);
    fs::remove_all(folder);
    make_directories(folder);
    return folder;
}

void save_panorama(const fs::path& path) {
    ImageRgb8 picture(128, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 128; ++x) picture.at(x, y) = {static_cast<std::uint8_t>(y * 3), 90, 70};
    save_png(path, picture);
}

TEST(Source, APictureIsReadOnceInARun) {
    const fs::path folder = empty_folder("reads");
    save_panorama(folder / "mine.png");
    SceneRequest request;
    request.source = PictureSource{"", folder / "mine.png", {}, {}, {}};
    request.params = params_of_quality("draft");
    request.params.panorama.backend = "image";
    request.params.depth.backend = "layout";
    request.last_stage = "depth";
    OpenCount opened(folder / "mine.png");
    ASSERT_EQ(read_file(folder / "mine.png").substr(1, 3), "PNG");
    ASSERT_EQ(opened.count(), 1) << "the kernel tells what is opened";
    make_scene(request, {folder / "run"}, {});
    EXPECT_EQ(opened.count(), 2);
    make_scene(request, {folder / "run"}, {});  // plus once to verify that nothing has changed
    EXPECT_EQ(opened.count(), 3);
}

TEST(Source, IsWhatItWasAfterRunJson) {
    const SceneSource sources[] = {PromptSource{"a loft"}, PictureSource{"a hall", "/a.png", "/a.exr", "/l.json", "/w"},
                                   PaintingSource{"a loft", "/w", "/p.jpg"},
                                   CaptureSource{"nerfstudio", "/t.json", "/i", "/m"}};
    for (const SceneSource& source : sources) {
        const SceneSource back = source_from_json(json_of_source(source));
        EXPECT_EQ(back.index(), source.index());
        EXPECT_EQ(json_of_source(back), json_of_source(source));
    }
}

// Records of earlier versions without an explicit kind: the kind follows from the files present.
TEST(Source, RecordsOfEarlierProgramsAreRead) {
    const auto read = [](const char* text) { return source_from_json(Json::parse(text)); };
    EXPECT_EQ(prompt_of(read(R"({"prompt": "a loft"})")), "a loft");
    EXPECT_TRUE(has_room(read(R"({"prompt": "a loft"})")));
    const SceneSource picture = read(R"({"prompt": "", "picture": "/a.png", "range_map": "/a.exr", "weights": "/w"})");
    EXPECT_EQ(picture_of(picture), "/a.png");
    EXPECT_EQ(range_map_of(picture), "/a.exr");
    EXPECT_EQ(weights_of(picture), "/w");
    EXPECT_EQ(panorama_backend(read(R"({"prompt": "a loft", "weights": "/w", "photo": "/p.jpg"})")), "diffusion360");
    EXPECT_THROW(read("{}"), Json::exception);
}

}  // namespace
}  // namespace fastscene
