// Weight files: PyTorch's formats, safetensors, and all ways in which a file can be broken.
#include "fastscene/weights/weights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>

#include "fastscene/base/error.h"
#include "fastscene/base/file.h"
#include "fastscene/base/random.h"
#include "fastscene/math/half.h"
#include "fastscene/weights/safetensors.h"
#include "fastscene/nn/tiny_model.h"
#include "fastscene/nn/weights_torch.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

fs::path data_file(const std::string& name) { return fs::path(FASTSCENE_SOURCE_DIR) / "tests/data/weights" / name; }

struct Folder {
    fs::path path = fs::temp_directory_path() / ("fastscene-weights-" + std::to_string(::getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
};

void expect_state_dict(const Weights& w) {
    EXPECT_EQ(w.tensors.size(), 6u);
    EXPECT_EQ(w.at("a.weight").shape, (std::vector<std::int64_t>{2, 3}));
    EXPECT_EQ(w.at("a.weight").floats(), (std::vector<float>{0, 0.5f, 1, 1.5f, 2, 2.5f}));
    EXPECT_EQ(w.at("a.bias").floats(), (std::vector<float>{3, 3.5f, 4}));  // a Parameter inside a shared storage
    EXPECT_EQ(w.at("a.turned").floats(), (std::vector<float>{0, 1.5f, 0.5f, 2, 1, 2.5f}));  // transposed
    EXPECT_EQ(w.at("half").type, NumberType::f16);
    EXPECT_EQ(w.at("half").floats(), (std::vector<float>{1.5f, -2, 0.25f, 0x1p-24f}));
    EXPECT_TRUE(w.at("steps").shape.empty());
    EXPECT_EQ(w.at("steps").floats(), (std::vector<float>{7}));
    EXPECT_EQ(w.at("wide").type, NumberType::f64);
    EXPECT_EQ(w.at("wide").floats()[0], 3.25f);
}

TEST(Weights, ReadsBothFormsOfTorchSave) {
    for (const char* name : {"state_dict.pt", "state_dict_old_form.pth"}) {
        SCOPED_TRACE(name);
        expect_state_dict(load_weights(data_file(name)));
    }
}

TEST(Weights, AWholeTrainingStateIsUnwrappedAndNothingInItRuns) {
    fs::remove("/tmp/fastscene-pickle-ran");
    for (const char* name : {"training_state.pt", "training_state_old_form.pth"}) {
        SCOPED_TRACE(name);
        const Weights all = load_weights(data_file(name));
        EXPECT_EQ(all.numbers.at("epoch"), 3);
        EXPECT_EQ(all.numbers.at("lr"), 1e-4);
        EXPECT_EQ(all.numbers.at("history.1"), 2.5);
        EXPECT_TRUE(all.has("netG.module.a.weight"));
        expect_state_dict(unwrapped(all, "a.weight"));
    }
    EXPECT_FALSE(fs::exists("/tmp/fastscene-pickle-ran"));
}

TEST(Weights, AreFoundUnderTheNamesThatTrainingOnManyGpusGivesThem) {
    const Weights plain = load_weights(data_file("state_dict.pt"));
    for (const std::string prefix :
         {"", "module.", "module.module.", "model.", "net.module.", "g_ema.", "state_dict.module.module."}) {
        SCOPED_TRACE(prefix);
        Weights named = plain;
        named.tensors.clear();
        for (const auto& [key, tensor] : plain.tensors) named.tensors.emplace(prefix + key, tensor);
        expect_state_dict(unwrapped(named, "a.weight"));
    }
}

TEST(Weights, SafetensorsComeBackAsTheyWere) {
    const Folder folder;
    Weights w = load_weights(data_file("state_dict.pt"));
    w.metadata["rates"] = "[1, 2]";
    save_safetensors(folder.path / "w.safetensors", w);
    const Weights back = load_weights(folder.path / "w.safetensors");
    expect_state_dict(back);
    EXPECT_EQ(back.metadata.at("rates"), "[1, 2]");
    save_safetensors(folder.path / "h.safetensors", w, SaveAs::f16);
    EXPECT_EQ(load_weights(folder.path / "h.safetensors").at("a.weight").type, NumberType::f16);
    EXPECT_EQ(load_weights(folder.path / "h.safetensors").at("steps").type, NumberType::i64);
    expect_state_dict(load_weights(folder.path / "h.safetensors").has("wide") ? back : w);
}

TEST(Weights, HalvesRoundAsTheStandardSays) {
    for (std::uint32_t bits = 0; bits < 0x10000; ++bits) {
        const float value = float_from_half(static_cast<std::uint16_t>(bits));
        if (std::isnan(value)) continue;
        ASSERT_EQ(half_from_float(value), bits);
        ASSERT_EQ(value, static_cast<float>(c10::Half(static_cast<std::uint16_t>(bits), c10::Half::from_bits())));
    }
    Random r(1, "half");
    for (int i = 0; i < 100000; ++i) {
        const float value = std::ldexp(r.uniform(-1, 1), r.index(48) - 28);
        ASSERT_EQ(half_from_float(value), c10::Half(value).x) << value;
        ASSERT_EQ(bfloat_from_float(value), c10::BFloat16(value).x) << value;
    }
}

// Any file truncated anywhere or with any byte changed is either still valid or refused with an Error naming it. Never
// a crash.
TEST(Weights, BrokenFilesAreRefusedOrHarmless) {
    const Folder folder;
    save_safetensors(folder.path / "w.safetensors", load_weights(data_file("state_dict.pt")));
    const fs::path broken = folder.path / "broken";
    int refused = 0, cuts = 0;
    const auto try_it = [&](const std::string& bytes) {
        write_file(broken, bytes);
        try {
            for (const auto& [name, tensor] : load_weights(broken).tensors) (void)tensor.floats();
        } catch (const Error& e) {
            ++refused;
            EXPECT_NE(std::string(e.what()).find(broken.string()), std::string::npos) << e.what();
        }
    };
    for (const fs::path& file :
         {data_file("state_dict.pt"), data_file("state_dict_old_form.pth"), data_file("training_state.pt"),
          data_file("training_state_old_form.pth"), folder.path / "w.safetensors"}) {
        const std::string whole = read_file(file);
        for (std::size_t size = 0; size < whole.size(); size += 1 + size / 64) {
            try_it(whole.substr(0, size));
            ++cuts;
            EXPECT_EQ(refused, cuts) << file << " cut to " << size;
            refused = cuts;
        }
        Random r(7, file.filename().string());
        const int before = refused;
        for (int i = 0; i < 400; ++i) {
            std::string other = whole;
            for (int k = r.index(3); k >= 0; --k)
                other[static_cast<std::size_t>(r.index(static_cast<int>(other.size())))] = static_cast<char>(
                    r.next_u32());
            try_it(other);
        }
        refused = before;
    }
}

TEST(Weights, HostileSafetensorsSayWhatIsWrong) {
    const Folder folder;
    const fs::path path = folder.path / "x.safetensors";
    const auto with_header = [&](const std::string& header, std::size_t payload) {
        const std::uint64_t length = header.size();
        write_file(path, std::string(reinterpret_cast<const char*>(&length), 8) + header + std::string(payload, '\0'));
        return message_of([&] { (void)load_weights(path); });
    };
    EXPECT_EQ(with_header(R"({"a":{"dtype":"F32","shape":[2],"data_offsets":[0,8]}})", 8), "");
    EXPECT_NE(with_header(R"({"a":{"dtype":"F32","shape":[2],"data_offsets":[0,8]}})", 7).find("cut off"),
              std::string::npos);
    EXPECT_NE(with_header(R"({"a":{"dtype":"F32","shape":[3],"data_offsets":[0,8]}})", 8).find("F32 [3]"),
              std::string::npos);
    EXPECT_NE(with_header(R"({"a":{"dtype":"F33","shape":[2],"data_offsets":[0,8]}})", 8).find("F33"),
              std::string::npos);
    EXPECT_NE(with_header(R"({"a":{"dtype":"F32","shape":[-2],"data_offsets":[0,8]}})", 8), "");
    EXPECT_NE(with_header(R"({"a":{"dtype":"F32","shape":[4611686018427387905,4],"data_offsets":[0,16]}})", 16), "");
    EXPECT_NE(with_header(R"({"a":{"dtype":"F32","shape":[2],"data_offsets":[8,0]}})", 8), "");
    EXPECT_NE(with_header(R"({"a":{"dtype":"F32","shape":[2.5],"data_offsets":[0,8]}})", 8), "");
    EXPECT_NE(with_header(R"({"a":7})", 8), "");
    EXPECT_NE(with_header("{\"a\":", 8), "");
}

// Small pickles that expand: a list that doubles itself, a tower of tuples, one storage used over and over.
TEST(Weights, PicklesThatExplodeAreStopped) {
    const Folder folder;
    const fs::path path = folder.path / "bomb.pth";
    const auto outcome = [&](const std::string& bytes) {
        write_file(path, bytes);
        return message_of([&] { (void)load_weights(path); });
    };
    EXPECT_NE(outcome("\x80\x02" + std::string(2000000, ']') + "."), "");
    EXPECT_NE(outcome("\x80\x02N" + std::string(3000000, '\x85') + "."), "");
    std::string doubling = "\x80\x02]q";
    doubling += '\0';
    for (int i = 0; i < 40; ++i) doubling += std::string("(h\0h\0e", 6);
    EXPECT_NE(outcome(doubling + "."), "");
    EXPECT_NE(outcome(std::string("\x80\x02X\xff\xff\xff\xff", 7)), "");
}

TEST(Weights, WhatDoesNotFitIsNamed) {
    const Weights w = load_weights(data_file("state_dict.pt"));
    EXPECT_NE(message_of([&] { (void)w.at("a.weigth"); }).find("a.weight"), std::string::npos);
    const nn::NamedTensors targets{{"a.weight", at::zeros({3, 2})}, {"b", at::zeros({1})}};
    const std::string text = message_of([&] { nn::load_into(targets, w); });
    EXPECT_NE(text.find("missing: b [1]"), std::string::npos) << text;
    EXPECT_NE(text.find("a.weight (expected [3, 2], found [2, 3])"), std::string::npos) << text;
    EXPECT_NE(text.find("unexpected: a.bias"), std::string::npos) << text;
    const nn::NamedTensors fitting{{"a.bias", at::zeros({3})}};
    nn::load_into(fitting, w, true);
    EXPECT_EQ(fitting[0].second[1].item<float>(), 3.5f);
}

}  // namespace
}  // namespace fastscene
