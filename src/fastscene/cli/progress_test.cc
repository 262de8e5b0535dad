#include "fastscene/cli/progress.h"

#include <gtest/gtest.h>

#include <sstream>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"
#include "fastscene/base/suggest.h"

namespace fastscene::cli {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

TEST(Progress, PlainSaysALineEachTenthOfTheWork) {
    std::ostringstream out;
    ProgressDisplay display(out, ProgressStyle::plain);
    for (int i = 0; i <= 1000; ++i) display.tell(ProgressEvent{"walk", i, 1000});
    const auto lines = lines_of(out.str());
    EXPECT_EQ(lines.size(), 11u) << out.str();
    EXPECT_NE(lines.front().find("0 %"), std::string::npos);
    EXPECT_NE(lines.back().find("100 %"), std::string::npos);
}

TEST(Progress, JsonLinesAreJsonAndNeverGoBack) {
    std::ostringstream out;
    ProgressDisplay display(out, ProgressStyle::json);
    for (int i = 0; i <= 50; ++i) display.tell(ProgressEvent{"splat", i, 50, 0.5 + 0.01 * i});
    display.tell(WarningEvent{"careful: \"\xff\""});
    double last = -1;
    for (const std::string& line : lines_of(out.str())) {
        const Json json = Json::parse(line);
        if (json.at("event") != "progress") continue;
        EXPECT_GE(json.at("overall").get<double>(), last);
        last = json.at("overall");
    }
    EXPECT_EQ(last, 1);
}

TEST(Progress, NoneStillWarns) {
    std::ostringstream out;
    ProgressDisplay display(out, ProgressStyle::none);
    display.tell(ProgressEvent{"walk", 1, 2});
    display.tell(NoteEvent{"by the way"});
    EXPECT_EQ(out.str(), "");
    display.tell(WarningEvent{"mind this"});
    EXPECT_EQ(out.str(), "warning: mind this\n");
}

TEST(Progress, TheRewrittenLineIsLeftBeforeOtherTextAndWipesWhatWasLonger) {
    std::ostringstream out;
    {
        ProgressDisplay display(out, ProgressStyle::line);
        display.tell(ProgressEvent{"a work with a long name indeed, longer", 0, 2});
        display.tell(ProgressEvent{"short", 2, 2});
        display.tell(NoteEvent{"done"});
    }
    const std::string text = out.str();
    EXPECT_NE(text.find("\ndone\n"), std::string::npos) << text;
    EXPECT_EQ(text.back(), '\n');
}

TEST(Progress, WhatFilesSayDoesNotReachTheTerminalAsOrders) {
    std::ostringstream out;
    ProgressDisplay(out, ProgressStyle::plain)
        .tell(WarningEvent{"a\x1b[2J\rb\x7f\xc2\x9b"
                           "31m \x9b"
                           "4m \xe5\xae \n\tgr\xc3\xbc\xc3\x9f \xe5\xae\xb6"});
    EXPECT_EQ(out.str(),
              "warning: a\\x1b[2J\\x0db\\x7f\\xc2\\x9b31m \\x9b4m \\xe5\\xae \n\tgr\xc3\xbc\xc3\x9f \xe5\xae\xb6\n");
}

TEST(Progress, UnknownStylesAreRefused) {
    EXPECT_EQ(progress_style("auto", true), ProgressStyle::line);
    EXPECT_EQ(progress_style("auto", false), ProgressStyle::plain);
    EXPECT_THROW(progress_style("loud", true), UsageError);
}

TEST(Suggest, NamesTheNearestWordOnlyWhenItIsNear) {
    const std::vector<std::string> flags{"--quality", "--seed", "--panorama-width", "--splat-steps"};
    EXPECT_EQ(nearest_word("--qualty", flags), "--quality");
    EXPECT_EQ(nearest_word("--width", flags), "--panorama-width");
    EXPECT_EQ(nearest_word("--sed", flags), "--seed");
    EXPECT_EQ(nearest_word("--zebra", flags), "");
    EXPECT_EQ(nearest_word("--x", flags), "");
}

}  // namespace
}  // namespace fastscene::cli
