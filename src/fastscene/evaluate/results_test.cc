#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "fastscene/base/file.h"
#include "fastscene/evaluate/picture.h"
#include "fastscene/evaluate/rows.h"
#include "fastscene/evaluate/stills.h"
#include "fastscene/evaluate/write.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

Suite suite_of_two() {
    return read_suite("measures = [\"stills\"]\ncolumns = [\"niqe\", \"clip_l14\", \"source_psnr\"]\n[[scene]]\nprompt = \"a\"\n[[published]]\nname = \"Them & us_1\"\nniqe = 3.9\n", "two", "two.toml");
}
Json record(const std::string& variant, double niqe, const Json& psnr) {
    return {{"variant", variant}, {"kind", "ours"}, {"scene", "a"}, {"seed", 0}, {"prompt", "a <b>"}, {"folder", "x"}, {"figures", Json::array()},
            {"samples", {{{"group", ""}, {"values", {{"niqe", niqe}, {"source_psnr", psnr}}}, {"notes", {{"clip_l14", "fetch clip-vit-large-patch14; or `fastscene models pull clip`"}}}}}}};
}
Json results_of(const Suite& suite, const std::vector<Json>& records) {
    Json columns = Json::array();
    for (const std::string& key : suite.columns) columns.push_back({{"key", key}, {"label", key}, {"unit", ""}, {"digits", 2}, {"about", ""}, {"better", key == "niqe" ? "lower" : "higher"}});
    return {{"suite", "two"}, {"title", "Two <rows>"}, {"about", ""}, {"notes", Json::array()}, {"versions", {{"fastscene", "0"}}}, {"scenes_done", records.size()}, {"scenes_all", records.size()},
            {"columns", columns}, {"rows", table_rows(suite, records)}, {"records", records}};
}

TEST(Rows, MeansOverScenesAndReasonsWhereThereIsNothing) {
    const Suite suite = suite_of_two();
    const Json rows = table_rows(suite, {record("ours", 4, 30.0), record("ours", 6, "inf"), record("other", 1, "inf")});
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0]["kind"], "published");
    EXPECT_EQ(rows[0]["cells"]["niqe"]["value"], 3.9);
    EXPECT_EQ(rows[0]["cells"]["clip_l14"]["note"], "not published");
    EXPECT_EQ(rows[1]["cells"]["niqe"]["value"], 5.0);
    EXPECT_NEAR(rows[1]["cells"]["niqe"]["sd"].get<double>(), std::sqrt(2.0), 1e-12);
    EXPECT_EQ(rows[1]["scenes"], 2);
    EXPECT_EQ(rows[1]["cells"]["source_psnr"]["value"], 30.0) << "an equal picture does not swallow the mean";
    EXPECT_EQ(rows[2]["cells"]["source_psnr"]["value"], "inf");
    EXPECT_EQ(rows[1]["cells"]["clip_l14"]["note"], "fetch clip-vit-large-patch14; or `fastscene models pull clip`") << "the column stays";
}

TEST(Rows, AFailedSceneLeavesItsReason) {
    const Json failed{{"variant", "ours"}, {"kind", "ours"}, {"scene", "a"}, {"seed", 0}, {"failed", "no space"}};
    const Json rows = table_rows(suite_of_two(), {failed});
    EXPECT_EQ(rows[1]["cells"]["niqe"]["note"], "failed: no space");
    EXPECT_EQ(table_rows(suite_of_two(), {failed, record("ours", 4, 30.0)})[1]["cells"]["niqe"]["value"], 4.0);
}

TEST(Tables, SayTheSameInEveryForm) {
    const Json results = results_of(suite_of_two(), {record("ours", 4, 30.0), record("other|x", 6, 31.0)});
    const std::string markdown = table_markdown(results), latex = table_latex(results), csv = table_csv(results), scenes = scenes_csv(results);
    EXPECT_NE(markdown.find("| ours | **4.00** | – | 30.00 |"), std::string::npos) << markdown;
    EXPECT_NE(markdown.find("| other\\|x | 6.00 | – | **31.00** |"), std::string::npos) << markdown;
    EXPECT_NE(markdown.find("| Them & us_1 (published) | 3.90 |"), std::string::npos) << "published figures are never the best: " << markdown;
    EXPECT_NE(markdown.find("fetch clip-vit-large-patch14"), std::string::npos) << markdown;
    EXPECT_NE(latex.find("Them \\& us\\_1 & 3.90 & -- & -- \\\\"), std::string::npos) << latex;
    EXPECT_NE(latex.find("ours & \\textbf{4.00} & -- & 30.00 \\\\"), std::string::npos) << latex;
    EXPECT_NE(csv.find("\"ours\",\"\",ours,1,4,,30\n"), std::string::npos) << csv;
    EXPECT_NE(scenes.find("\"ours\",\"\",\"a\",0,clip_l14,,\"fetch clip-vit-large-patch14;"), std::string::npos) << scenes;
}

TEST(Report, StandsAlone) {
    const fs::path out = fs::temp_directory_path() / "fastscene_report_test";
    fs::remove_all(out);
    fs::create_directories(out);
    save_png(out / "a.png", ImageRgb8(900, 450, Rgb8{10, 200, 30}));
    Json with_picture = record("ours", 4, 30.0);
    with_picture["figures"] = {{{"caption", "look"}, {"wide", true}, {"pictures", {{{"label", "L"}, {"file", "a.png"}}}}}};
    with_picture["panorama"] = "a.png";
    const std::string html = report_html(results_of(suite_of_two(), {with_picture, record("other", 6, 31.0)}), out);
    EXPECT_NE(html.find("data:image/jpeg;base64,"), std::string::npos);
    EXPECT_EQ(html.find("src=\"http"), std::string::npos);
    EXPECT_EQ(html.find("url("), std::string::npos);
    EXPECT_NE(html.find("Two &lt;rows&gt;"), std::string::npos) << "text is escaped";
    EXPECT_NE(html.find("a &lt;b&gt;"), std::string::npos);
    EXPECT_NE(html.find(">needs models pull clip<"), std::string::npos) << "a metric without weights keeps its column";
    EXPECT_NE(html.find("<svg"), std::string::npos);
    fs::remove_all(out);
}

TEST(Pictures, AreReducedByMeansAndDifferencesShow) {
    ImageRgb8 image(4, 2, Rgb8{100, 0, 0});
    image.at(0, 0) = image.at(1, 1) = {200, 0, 0};
    const ImageRgb8 small = thumbnail(image, 2);
    ASSERT_EQ(small.width, 2);
    ASSERT_EQ(small.height, 1);
    EXPECT_EQ(small.at(0, 0), (Rgb8{150, 0, 0}));
    EXPECT_EQ(thumbnail(image, 9), image);
    const ImageRgb8 map = error_map(image, ImageRgb8(4, 2, Rgb8{100, 0, 0}));
    EXPECT_EQ(map.at(3, 0), (Rgb8{0, 0, 4}));
    EXPECT_GT(map.at(0, 0).r, 200);
}

TEST(Stills, StandInFreeSpaceAndAreTheSameForEveryScene) {
    StillsParams params;
    params.radius_m = 0.5;
    const std::vector<Rigid> free = still_poses(params, {}), narrow = still_poses(params, ImageF(64, 32, 0.45f));
    ASSERT_EQ(free.size(), 30u);
    float farthest = 0, farthest_narrow = 0;
    for (std::size_t i = 0; i < free.size(); ++i) {
        farthest = std::max(farthest, length(free[i].translation));
        farthest_narrow = std::max(farthest_narrow, length(narrow[i].translation));
        EXPECT_LT(length(free[i].rotation * Vec3f{0, 0, 1} - narrow[i].rotation * Vec3f{0, 0, 1}), 1e-6f);
    }
    EXPECT_GT(farthest, 0.35f);
    EXPECT_LE(farthest, 0.5f);
    EXPECT_LE(farthest_narrow, 0.1501f) << "30 cm from every wall";
    EXPECT_GT(farthest_narrow, 0.14f);
    EXPECT_EQ(still_camera({}, 2048).width, 512);
    EXPECT_EQ(still_camera({}, 1024).width, 256);
}

}  // namespace
}  // namespace fastscene
