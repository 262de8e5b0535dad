#include <cstdlib>

#include "fastscene/cli/flags.h"
#include "fastscene/cli/inpaint.h"
#include "fastscene/inpaint/train.h"
#include "fastscene/nn/launch.h"

namespace fastscene::cli {

Verb add_inpaint_train(CLI::App& inpaint) {
    struct Flags {
        std::string data, out, seed = "0";
        std::shared_ptr<Given> given = std::make_shared<Given>();
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = inpaint.add_subcommand("train", "Trains AOT-GAN on such a dataset; the same command resumes it.");
    verb->add_option("data", flags->data, "Folder made by `fastscene inpaint dataset`.")->type_name("DIR")->required();
    verb->add_option(
            "-o,--out", flags->out,
            "Folder of the training: generator.safetensors (for --walk-inpaint-weights), checkpoint, curves, sheets.")
        ->type_name("DIR")
        ->required();
    verb->add_option("--seed", flags->seed, "Same seed and settings, same training.")
        ->type_name("N")
        ->capture_default_str();
    add_fields(*verb, "", InpaintTrainParams{}, flags->given, "Settings of the training");
    verb->footer(
        "Example:\n  fastscene inpaint train data/holes -o out/inpainter --width 16 --blocks 4 --skips --size 128 "
        "--holes harmonic");
    return {verb, [flags](const Session& session) {
                InpaintTrainParams params;
                apply_fields("", params, *flags->given);
                check_fields("", params);
                take_launch(params.network.training, ::getenv);
                const auto figures = train_inpainter(flags->data, params, flags->out,
                                                     session.run(number_from<std::uint64_t>("--seed", flags->seed)));
                if (figures.empty()) return session.print("done; process 0 saves the network", Json::object());
                std::string text = flags->out + "/generator.safetensors: held out:";
                Json json{{"weights", flags->out + "/generator.safetensors"}};
                for (const auto& [name, value] : figures) {
                    text += fmt::format("  {} {:.4g}", name, value);
                    json["held_out"][name] = value;
                }
                session.print(text, json);
            }};
}

}  // namespace fastscene::cli
