// Networks exported as TorchScript: small ones made here by libtorch itself, so that what runs is what others export.
#include "fastscene/nn/scripted.h"

#include <gtest/gtest.h>
#include <torch/script.h>
#include <unistd.h>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/models/trust.h"
#include "fastscene/nn/made_script.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

std::string said(const std::function<void()>& act) {
    try {
        act();
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

TEST(Scripted, RunsOnlyWhatIsTrusted) {
    const MadeScript made("def forward(self, x):\n    return x * 2\n");
    const std::string text = said([&] { ScriptedNetwork::load(made.file, {}, {"cpu", "--depth-device"}); });
    EXPECT_NE(text.find("--trust " + made.file.string()), std::string::npos) << text;
    EXPECT_NE(said([&] {
                  ScriptedNetwork::load(made.file, {"/other/file", std::string(64, 'a')}, {"cpu", "-"});
              }).find("found others"),
              std::string::npos);
    const std::string hash = check_trusted(made.file, {made.file.string()});
    EXPECT_EQ(hash.size(), 64u);
    std::string upper = hash;
    for (char& c : upper) c = static_cast<char>(std::toupper(c));
    EXPECT_EQ(check_trusted(made.file, {upper}), hash);
    EXPECT_EQ(ScriptedNetwork::load(made.file, {hash}, {"cpu", "-"}).sha256(), hash);
}

TEST(Scripted, TensorsTuplesAndDictionaries) {
    for (const auto& [body, output] : {std::pair{"    return x * 2\n", ""},
                                       {"    return (x, x * 2)\n", "1"},
                                       {"    return {\"other\": x, \"depth\": x * 2}\n", "depth"},
                                       {"    return x[0] * 2\n", ""}}) {
        const MadeScript made(std::string("def forward(self, x):\n") + body);
        const auto network = ScriptedNetwork::load(made.file, {made.file.string()}, {"cpu", "-"});
        PicturePlanes in(3, 5, 4);
        in.at(1, 2, 3) = 7;
        const PicturePlanes out = network.run({in}, output, {});
        EXPECT_EQ(out.count, 3);
        EXPECT_EQ(out.width, 5);
        EXPECT_EQ(out.height, 4);
        EXPECT_EQ(out.at(1, 2, 3), 14) << body;
        EXPECT_EQ(out.at(0, 2, 3), 0) << body;
    }
}

TEST(Scripted, MistakesNameTheFile) {
    const MadeScript made("def forward(self, x):\n    return torch.mm(x, x)\n");
    const auto network = ScriptedNetwork::load(made.file, {made.file.string()}, {"cpu", "-"});
    const std::string cannot = said([&] { network.run({PicturePlanes(3, 8, 8)}, "", {}); });
    EXPECT_NE(cannot.find(made.file.string() + ": cannot run on 8 x 8 pixels"), std::string::npos) << cannot;
    EXPECT_EQ(cannot.find('\n'), std::string::npos);
    const MadeScript other("def forward(self, x):\n    return {\"depth\": x}\n");
    const auto named = ScriptedNetwork::load(other.file, {other.file.string()}, {"cpu", "-"});
    EXPECT_NE(said([&] { named.run({PicturePlanes(3, 8, 8)}, "range", {}); }).find("\"range\""), std::string::npos);
    const fs::path junk = made.file.string() + ".junk";
    write_file(junk, std::string_view("no archive"));
    EXPECT_NE(said([&] {
                  ScriptedNetwork::load(junk, {junk.string()}, {"cpu", "-"});
              }).find("TorchScript"),
              std::string::npos);
    fs::remove(junk);
}

TEST(Scripted, TheJsonBesideIt) {
    const MadeScript made("def forward(self, x):\n    return x\n");
    EXPECT_TRUE(beside_network(made.file).empty());
    const fs::path json = made.file.string() + ".json";
    write_file(json, std::string_view("{\"width\": 512}"));
    EXPECT_EQ(beside_network(made.file).at("width"), 512);
    write_file(json, std::string_view("[1]"));
    EXPECT_THROW(beside_network(made.file), Error);
    fs::remove(json);
}

}  // namespace
}  // namespace fastscene
