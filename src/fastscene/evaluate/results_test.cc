#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "fastscene/base/file.h"
#include "fastscene/evaluate/cells.h"
#include "fastscene/evaluate/picture.h"
#include "fastscene/evaluate/rows.h"
#include "fastscene/evaluate/stills.h"
#include "fastscene/evaluate/write.h"
#include "fastscene/io/image_io.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

Suite suite_of_two(const std::string& scene = "prompt = \"a\"\n") {
    return read_suite(
        "measures = [\"stills\", \"source\"]\ncolumns = [\"niqe\", \"clip_l14\", \"source_psnr\"]\n[[scene]]\n" +
            scene + "[[published]]\nname = \"Them & us_1\"\nniqe = 3.9\n",
        "two", "two.toml");
}
Suite suite_of_seeds() { return suite_of_two("prompt = \"a\"\nseeds = [0, 1]\n"); }

Json record(const std::string& variant, double niqe, const Json& psnr, int seed = 0, const std::string& kind = "ours") {
    const Json notes{{"clip_l14", {"fetch clip-vit-large-patch14; or `fastscene models pull clip`"}}};
    return {{"variant", variant},
            {"kind", kind},
            {"scene", "a"},
            {"seed", seed},
            {"prompt", "a <b>"},
            {"folder", "x"},
            {"figures", Json::array()},
            {"samples", {{{"group", ""}, {"values", {{"niqe", niqe}, {"source_psnr", psnr}}}, {"notes", notes}}}}};
}
Json failed_record(const std::string& variant, int seed, const std::string& why) {
    return {{"variant", variant}, {"kind", "ours"}, {"scene", "a"}, {"seed", seed},
            {"prompt", ""},       {"folder", "x"},  {"failed", why}};
}
Json results_of(const Suite& suite, const std::vector<Json>& records) {
    Json columns = Json::array();
    for (const std::string& key : suite.columns)
        columns.push_back({{"key", key},
                           {"label", key},
                           {"unit", ""},
                           {"digits", 2},
                           {"about", ""},
                           {"better", key == "niqe" ? "lower" : "higher"}});
    return {{"suite", "two"},
            {"title", "Two <rows>"},
            {"about", ""},
            {"notes", Json::array()},
            {"versions", {{"fastscene", "0"}}},
            {"scenes_done", records.size()},
            {"scenes_all", records.size()},
            {"columns", columns},
            {"rows", table_rows(suite, records)},
            {"records", records},
            {"parameters", parameters_used(suite, records)}};
}
bool is_in(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Rows, MeansOverScenesAndReasonsWhereThereIsNothing) {
    const Json rows = table_rows(suite_of_seeds(),
                                 {record("ours", 4, 30.0, 0), record("ours", 6, "inf", 1), record("other", 1, "inf")});
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0]["kind"], "published");
    EXPECT_EQ(rows[0]["cells"]["niqe"]["value"], 3.9);
    EXPECT_FALSE(rows[0]["cells"]["clip_l14"].contains("value"));
    EXPECT_EQ(rows[1]["cells"]["niqe"]["value"], 5.0);
    EXPECT_NEAR(rows[1]["cells"]["niqe"]["sd"].get<double>(), std::sqrt(2.0), 1e-12);
    EXPECT_EQ(rows[1]["scenes"], 2);
    EXPECT_EQ(rows[1]["cells"]["source_psnr"]["value"], 30.0) << "an equal picture does not swallow the mean";
    EXPECT_EQ(rows[1]["cells"]["source_psnr"]["count"], 1);
    EXPECT_EQ(rows[1]["cells"]["source_psnr"]["notes"], Json({"a, seed 1: infinite, not in the mean"}))
        << "and is not silent";
    EXPECT_EQ(rows[2]["cells"]["source_psnr"]["value"], "inf");
    EXPECT_EQ(rows[1]["cells"]["clip_l14"]["notes"],
              Json({"fetch clip-vit-large-patch14; or `fastscene models pull clip`"}))
        << "the column stays";
    EXPECT_EQ(rows[2]["of"], 2) << "of the scenes that were asked for";
}

TEST(Rows, AFailedSceneIsMissingFromTheMeansAndSaysSoEverywhere) {
    const Suite suite = suite_of_seeds();
    const Json results = results_of(suite,
                                    {record("ours", 4, 30.0, 0), failed_record("ours", 1, "no | space, 5 % left")});
    EXPECT_EQ(results["rows"][1]["cells"]["niqe"]["value"], 4.0);
    const std::string markdown = table_markdown(results), latex = table_latex(results), csv = table_csv(results);
    EXPECT_TRUE(is_in(markdown, "| ours | 4.00 (1 of 2) | –<sup>")) << markdown;
    EXPECT_TRUE(is_in(markdown, "- failed: ours, a, seed 1: no | space, 5 % left\n")) << markdown;
    EXPECT_TRUE(is_in(latex, "ours & 4.00 (1 of 2) & --")) << latex;
    EXPECT_TRUE(is_in(latex, "\n% failed: ours, a, seed 1: no | space")) << latex;
    EXPECT_TRUE(is_in(csv, "\"ours\",\"\",ours,1,2,\"ours, a, seed 1: no | space, 5 % left\",4,,1,")) << csv;
    const std::string html = report_html(results, fs::temp_directory_path());
    EXPECT_TRUE(is_in(html, "4.00 <small class=\"share\">1 of 2</small>")) << html;
    EXPECT_TRUE(is_in(html, "<li>ours, a, seed 1: no | space"));
    const Json nothing = table_rows(suite, {failed_record("ours", 0, "x"), failed_record("ours", 1, "x")});
    EXPECT_EQ(nothing[1]["scenes"], 0) << "the row stays";
    EXPECT_EQ(nothing[1]["of"], 2);
}

TEST(Rows, TheBestIsOneOfRowsOverTheSameScenes) {
    const Suite seeds = suite_of_seeds();
    const auto best = [](const Json& results, int row) {
        return is_best(results, results["rows"][static_cast<std::size_t>(row)], results["columns"][0]);
    };
    const Json equal = results_of(
        seeds, {record("a", 4, 30.0, 0), record("a", 5, 30.0, 1), record("b", 6, 30.0, 0), record("b", 7, 30.0, 1)});
    EXPECT_TRUE(best(equal, 1));
    EXPECT_FALSE(best(equal, 2));
    const Json fewer = results_of(seeds, {record("a", 4, 30.0, 0), record("b", 6, 30.0, 0), record("b", 7, 30.0, 1)});
    EXPECT_FALSE(best(fewer, 1)) << "a mean over an easier half is not better";
    const Json others = results_of(seeds, {record("a", 4, 30.0, 0), record("b", 6, 30.0, 1)});
    EXPECT_FALSE(best(others, 1)) << "as many scenes, but others";
    const Suite one = suite_of_two();
    EXPECT_FALSE(best(results_of(one, {record("a", 4.001, 30.0), record("b", 4.002, 30.0)}), 1))
        << "the same at the digits that are shown";
    EXPECT_TRUE(best(results_of(one, {record("a", 4, 30.0), record("peer", 5, 30.0, 0, "peer")}), 1));
    EXPECT_FALSE(best(
        results_of(seeds, {record("a", 4, 30.0, 0), record("a", 4, 30.0, 1), record("peer", 5, 30.0, 0, "peer")}), 1))
        << "two seeds against one";
}

TEST(Tables, EqualIsBetterThanAnyNumber) {
    const std::string markdown = table_markdown(
        results_of(suite_of_two(), {record("ours", 4, 30.0), record("same", 5, "inf", 0, "peer")}));
    EXPECT_TRUE(is_in(markdown, " | 30.00 |")) << markdown;
    EXPECT_TRUE(is_in(markdown, " | **inf**")) << markdown;
    const std::string both = table_markdown(
        results_of(suite_of_two(), {record("ours", 4, "inf"), record("same", 5, "inf", 0, "peer")}));
    EXPECT_FALSE(is_in(both, "**inf**")) << "neither is the best: " << both;
}

TEST(Rows, AVariantsOwnRowComesFirstAndItsCurvesLast) {
    const auto sample = [](const std::string& group, const Json& more) {
        Json out{{"group", group}, {"values", {{"niqe", 3.0}}}, {"notes", Json::object()}};
        out.update(more);
        return out;
    };
    std::vector<Json> records{record("a", 1, 30.0), record("b", 1, 30.0)};
    for (Json& r : records)
        r["samples"] = {sample("x +0.33", {{"series", "along x"}, {"at", 0.33}}),
                        sample("within 0.3 m", {{"series", ""}, {"at", 0.3}}), sample("", Json::object())};
    std::vector<std::string> titles;
    const Json rows = table_rows(suite_of_two(), records);
    for (const Json& row : rows)
        if (row["kind"] != "published") titles.push_back(row_title(row));
    EXPECT_EQ(titles,
              (std::vector<std::string>{"a", "a, within 0.3 m", "a, x +0.33", "b", "b, within 0.3 m", "b, x +0.33"}));
}

TEST(Rows, AQuotedFigureHasNoDeviation) {
    const Suite suite = read_suite("measures = [\"holes\"]\n[[scene]]\nname = \"a\"\nprompt = \"a\"\nseeds = [0, 1]\n",
                                   "two", "two.toml");
    std::vector<Json> records{record("ours", 4, 30.0, 0), record("ours", 5, 30.0, 1)};
    for (int i = 0; i < 2; ++i)
        records[static_cast<std::size_t>(i)]["samples"][0]["values"] = {{"holes_paper", 64.3}, {"holes", 12.0 + i}};
    const Json cells = table_rows(suite, records)[0]["cells"];
    EXPECT_FALSE(cells["holes_paper"].contains("sd")) << cells;
    EXPECT_TRUE(cells["holes"].contains("sd")) << cells;
}

TEST(Rows, OneFigureForAllScenesHasNoDeviation) {
    const Suite suite = read_suite(
        "measures = [\"stills\"]\ncolumns = [\"minutes\"]\n[[scene]]\nprompt = \"a\"\n[[scene]]\nprompt = \"b\"\n",
        "two", "two.toml");
    std::vector<Json> records;
    for (const char* scene : {"a", "b"})
        records.push_back(
            {{"variant", "P"},
             {"kind", "peer"},
             {"scene", scene},
             {"seed", 0},
             {"samples",
              {{{"group", ""}, {"values", {{"minutes", 70}}}, {"notes", Json::object()}, {"shared", true}}}}});
    EXPECT_FALSE(table_rows(suite, records)[0]["cells"]["minutes"].contains("sd"));
    for (Json& r : records) r["samples"][0].erase("shared");
    EXPECT_EQ(table_rows(suite, records)[0]["cells"]["minutes"]["sd"], 0.0);
}

TEST(Rows, PicturesLeftOutAreCountedAndFilesNamed) {
    Json with = record("ours", 4, 30.0);
    with["samples"][0]["notes"]["niqe"] = {"undefined for 2 of 30 pictures"};
    with["samples"][0]["pictures"]["niqe"] = {{"counted", 28}, {"of", 30}};
    with["parameters"]["niqe"] = {{"files", {"/w/niqe.json"}}, {"identity", "0123456789abcdef"}};
    Json results = results_of(suite_of_two(), {with});
    EXPECT_EQ(results["rows"][1]["cells"]["niqe"]["pictures"]["counted"], 28);
    const std::string markdown = table_markdown(results);
    EXPECT_TRUE(is_in(markdown, "| ours | 4.00<sup>a</sup> |")) << markdown;
    EXPECT_TRUE(is_in(markdown, "- <sup>a</sup> niqe: undefined for 2 of 30 pictures\n")) << markdown;
    EXPECT_TRUE(is_in(markdown, "- niqe with niqe.json (01234567)\n")) << markdown;
    Json other = record("other", 5, 30.0);
    other["parameters"]["niqe"] = {{"files", {"/w/niqe.json"}}, {"identity", "fedcba9876543210"}};
    results = results_of(suite_of_two(), {with, other});
    EXPECT_TRUE(is_in(table_markdown(results), "these figures do not compare")) << table_markdown(results);
    EXPECT_TRUE(
        is_in(report_html(results, fs::temp_directory_path()), "Scenes measured with different parameter files"));
}

TEST(Tables, SayTheSameInEveryForm) {
    const Json results = results_of(suite_of_two(), {record("ours", 4, 30.0), record("other|x^2 ~\\", 6, 31.0)});
    const std::string markdown = table_markdown(results), latex = table_latex(results), csv = table_csv(results),
                      scenes = scenes_csv(results);
    EXPECT_TRUE(is_in(markdown, "| ours | **4.00** | –<sup>a</sup> | 30.00 |")) << markdown;
    EXPECT_TRUE(is_in(markdown, "| other\\|x^2 \\~\\\\ | 6.00 | –<sup>a</sup> | **31.00** |")) << markdown;
    EXPECT_TRUE(is_in(markdown, "| Them & us_1 (published) | 3.90 |"))
        << "published figures are never the best: " << markdown;
    EXPECT_TRUE(is_in(markdown, "- <sup>a</sup> clip_l14: fetch clip-vit-large-patch14")) << markdown;
    EXPECT_TRUE(is_in(latex, "Them \\& us\\_1 & 3.90 & -- & -- \\\\")) << latex;
    EXPECT_TRUE(is_in(latex, "ours & \\textbf{4.00} & --\\textsuperscript{a} & 30.00 \\\\")) << latex;
    EXPECT_TRUE(is_in(latex, "other|x\\textasciicircum{}2 \\textasciitilde{}\\textbackslash{} & 6.00")) << latex;
    EXPECT_TRUE(is_in(csv, "\"ours\",\"\",ours,1,1,,4,,1,,,,30,,1\n")) << csv;
    EXPECT_TRUE(is_in(scenes, "\"ours\",\"\",\"a\",0,clip_l14,,\"fetch clip-vit-large-patch14;")) << scenes;
}

// Names are shown literally in every format.
TEST(Tables, NamesStartNothing) {
    const std::string name = "[*] a_b _c_ `d` <i>e</i> \"f\", #1 50% $g$ {h}\nj|k";
    const Json results = results_of(suite_of_two(), {record(name, 4, 30.0), record("*", 5, 30.0)});
    const std::string markdown = table_markdown(results), latex = table_latex(results), csv = table_csv(results),
                      html = report_html(results, fs::temp_directory_path());
    EXPECT_TRUE(is_in(markdown, "| \\[\\*] a_b \\_c\\_ \\`d\\` \\<i>e\\</i> \"f\", #1 50% $g$ {h} j\\|k | 4.00 |") ||
                is_in(markdown, "j\\|k | **4.00** |"))
        << markdown;
    EXPECT_FALSE(is_in(markdown, " <i>")) << markdown;
    EXPECT_TRUE(
        is_in(latex, "\n{}[*] a\\_b \\_c\\_ `d` <i>e</i> \"f\", \\#1 50\\% \\$g\\$ \\{h\\} j|k & \\textbf{4.00}"))
        << latex;
    EXPECT_TRUE(is_in(latex, "\n{}* & 5.00")) << latex;
    for (std::size_t at = 0; (at = latex.find("\\\\\n", at)) != std::string::npos; ++at)
        EXPECT_FALSE(latex.substr(at + 3, 1) == "[" || latex.substr(at + 3, 1) == "*")
            << "an argument of the row above: " << latex;
    EXPECT_TRUE(is_in(csv, "\"[*] a_b _c_ `d` <i>e</i> \"\"f\"\", #1 50% $g$ {h}\nj|k\",\"\",ours")) << csv;
    EXPECT_FALSE(is_in(html, "<i>"));
}

TEST(Tables, SayTheDeviationBetweenScenesInEveryForm) {
    const Json results = results_of(
        suite_of_seeds(), {record("ours", 4, 30.0, 0), record("ours", 5, 30.0, 1), record("peer", 6, 31.0, 0, "peer")});
    const std::string markdown = table_markdown(results);
    EXPECT_TRUE(is_in(markdown, "| ours | 2 | 4.50 ± 0.71 |"))
        << "and how many scenes, where rows differ: " << markdown;
    EXPECT_TRUE(is_in(markdown, "| peer | 1 | 6.00 |")) << markdown;
    EXPECT_TRUE(is_in(table_latex(results), "ours & 2 & 4.50 $\\pm$ 0.71 &")) << table_latex(results);
    EXPECT_TRUE(is_in(table_csv(results), "\"ours\",\"\",ours,2,2,,4.5,0.70710")) << table_csv(results);
    EXPECT_TRUE(is_in(report_html(results, fs::temp_directory_path()), "<th>scenes</th>"));
}

TEST(Tables, PublishedIsSaidOnce) {
    EXPECT_EQ(published_title({{"name", "FastScene (the paper)"}, {"group", ""}, {"kind", "published"}}),
              "FastScene (the paper, published)");
    EXPECT_EQ(published_title({{"name", "Ours (all)"}, {"group", ""}, {"kind", "ours"}}), "Ours (all)");
}

TEST(Tables, ReadWhatEarlierVersionsWrote) {
    Json results = results_of(suite_of_two(), {record("ours", 4, 30.0)});
    results.erase("parameters");
    Json& row = results["rows"][1];
    row.erase("of");
    row["cells"]["niqe"] = {{"value", 4.0}, {"count", 1}};
    row["cells"]["clip_l14"] = {{"note", "fetch it"}};
    results["records"][0]["samples"][0]["notes"] = {{"clip_l14", "fetch it"}};
    EXPECT_TRUE(is_in(table_markdown(results), "| ours | 4.00 | –<sup>a</sup> |"));
    EXPECT_TRUE(is_in(scenes_csv(results), "clip_l14,,\"fetch it\""));
    EXPECT_TRUE(is_in(report_html(results, fs::temp_directory_path()), "fetch it"));
}

TEST(Report, StandsWithBrokenPictures) {
    const fs::path out = fs::temp_directory_path() / "fastscene_report_broken_test";
    fs::remove_all(out);
    fs::create_directories(out);
    write_file(out / "broken & co.png", "no picture");
    save_png(out / "whole.png", ImageRgb8(40, 20, Rgb8{10, 200, 30}));
    Json r = record("peer", 4, 30.0, 0, "peer");
    r["panorama"] = "gone.png";
    Json pictures = Json::array();
    for (const char* file : {"broken & co.png", "gone.png", "whole.png"})
        pictures.push_back({{"label", ""}, {"file", file}});
    r["figures"] = {{{"caption", ""}, {"wide", false}, {"pictures", pictures}}};
    const std::string html = report_html(results_of(suite_of_two(), {r}), out);
    for (const char* file : {"broken &amp; co.png", "gone.png"})
        EXPECT_TRUE(is_in(html, std::string(file) + ": not there, or cannot be read")) << html;
    EXPECT_FALSE(is_in(html, "src=\"\"")) << html;
    EXPECT_TRUE(is_in(html, "src=\"data:image/jpeg")) << html;
}

TEST(Report, StandsAlone) {
    const fs::path out = fs::temp_directory_path() / "fastscene_report_test";
    fs::remove_all(out);
    fs::create_directories(out);
    save_png(out / "a.png", ImageRgb8(900, 450, Rgb8{10, 200, 30}));
    Json with_picture = record("ours", 4, 30.0);
    with_picture["figures"] = {
        {{"caption", "look"}, {"wide", true}, {"pictures", {{{"label", "L"}, {"file", "a.png"}}}}}};
    with_picture["panorama"] = "a.png";
    const std::string html = report_html(results_of(suite_of_two(), {with_picture, record("other", 6, 31.0)}), out);
    EXPECT_NE(html.find("data:image/jpeg;base64,"), std::string::npos);
    EXPECT_EQ(html.find("src=\"http"), std::string::npos);
    EXPECT_EQ(html.find("url("), std::string::npos);
    EXPECT_NE(html.find("Two &lt;rows&gt;"), std::string::npos) << "text is escaped";
    EXPECT_NE(html.find("a &lt;b&gt;"), std::string::npos);
    EXPECT_NE(html.find("<td class=\"none\">–<sup>a</sup></td>"), std::string::npos)
        << "a metric without weights keeps its column";
    EXPECT_NE(html.find("<code>fastscene models pull clip</code>"), std::string::npos) << html;
    EXPECT_EQ(html.find("fastscene models pull clip"), html.rfind("fastscene models pull clip"))
        << "and says what to do once";
    EXPECT_NE(html.find("<svg"), std::string::npos);
    EXPECT_NE(html.find(">1 room, made in 2 ways, "), std::string::npos)
        << "rooms are counted, not what each row made of them";
    EXPECT_EQ(html.find("<section"), html.rfind("<section")) << "a section a room";
    EXPECT_EQ(html.find("class=\"panorama\""), html.rfind("class=\"panorama\"")) << "and its panorama once";
    fs::remove_all(out);
}

TEST(Report, RowsOfARoomStandBesideEachOther) {
    const fs::path out = fs::temp_directory_path() / "fastscene_report_beside_test";
    fs::remove_all(out);
    fs::create_directories(out);
    std::vector<Json> records;
    for (const char* variant : {"one", "two"}) {
        Json one = record(variant, 4, 30.0);
        Json pictures = Json::array();
        for (const char* label : {"truth", "splats", "difference"}) {
            const std::string file = std::string(variant) + label + ".png";
            save_png(out / file, ImageRgb8(8, 8, Rgb8{10, 200, 30}));
            pictures.push_back({{"label", label}, {"file", file}});
        }
        one["figures"] = {{{"caption", "At poses"}, {"wide", false}, {"pictures", pictures}}};
        records.push_back(one);
    }
    const std::string html = report_html(results_of(suite_of_two(), records), out);
    EXPECT_TRUE(is_in(html, "<div class=\"row beside\" style=\"--columns: 3\">")) << html;
    EXPECT_EQ(html.find("<span>truth</span>"), html.rfind("<span>truth</span>"))
        << "what both are held against stands once";
    EXPECT_LT(html.find("<span>one</span>"), html.find("<span>two</span>"));
    fs::remove_all(out);
}

TEST(Charts, ShowWhatWasMeasuredWithLabelsInFull) {
    const std::string name(90, 'x'), long_name = "The first words of a long name of a row " + name;
    Json results = results_of(suite_of_two(), {record(long_name, 4, 30.0)});
    const std::string html = report_html(results, fs::temp_directory_path());
    EXPECT_TRUE(is_in(html, ">The first words of a long name of a row</text>")) << "broken between words, not cut";
    EXPECT_TRUE(is_in(html, ">" + std::string(54, 'x') + "</text>"));
    EXPECT_FALSE(is_in(html, "…")) << html;
    for (Json& row : results["rows"]) row["kind"] = "published";
    EXPECT_FALSE(is_in(report_html(results, fs::temp_directory_path()), "<svg"))
        << "a chart of published figures alone says nothing of ours";
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
