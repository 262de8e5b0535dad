#include "fastscene/cli/flags.h"
#include "fastscene/cli/rooms.h"
#include "fastscene/dataset/dataset.h"

namespace fastscene::cli {
namespace {

std::string summary(const std::string& folder, const DatasetState& state) {
    std::string text = fmt::format("{}: {} of {} pictures done, {} in this run", folder, state.there, state.count,
                                   state.made);
    if (state.there < state.count)
        text += fmt::format("; {} claimed by other processes: run the same command again to finish what they leave",
                            state.count - state.there);
    return text;
}

}  // namespace

Verb add_rooms_dataset(CLI::App& rooms) {
    struct Flags {
        std::string out, seed = "0", size = "1024x512", count;
        std::shared_ptr<Given> given = std::make_shared<Given>();
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = rooms.add_subcommand(
        "dataset", "Random rooms as training data: color, range, normals, class and instance ids, cameras.");
    verb->add_option(
            "-o,--out", flags->out,
            "Folder of the dataset. Existing pictures are kept; any number of processes may work on one folder.")
        ->type_name("DIR")
        ->required();
    verb->add_option("--count", flags->count, "Total number of pictures. A larger number extends a dataset.")
        ->type_name("N")
        ->required();
    verb->add_option("--size", flags->size, "Size of the pictures.")->type_name("WIDTHxHEIGHT")->capture_default_str();
    verb->add_option("--seed", flags->seed, "Same seed and settings, same pictures, byte for byte.")
        ->type_name("N")
        ->capture_default_str();
    add_fields(*verb, "", DatasetParams{}, flags->given, "Settings of the pictures");
    verb->footer(
        "Files of picture 00000000 (docs/dataset.md): .color.jpg, .range.png (16 bit, millimetres along the ray, 0 = "
        "outside),\n"
        ".normal.png (camera frame, (n + 1) / 2), .class.png (NYU40), .instance.png (16 bit), .json (camera, prompt, "
        "instances).");
    return {verb, [flags](const Session& session) {
                DatasetRequest request;
                request.count = number_from<int>("--count", flags->count);
                const auto x = flags->size.find('x');
                if (x == std::string::npos)
                    throw UsageError("--size: expected WIDTHxHEIGHT, found \"{}\"", flags->size);
                request.width = number_from<int>("--size", flags->size.substr(0, x));
                request.height = number_from<int>("--size", flags->size.substr(x + 1));
                apply_fields("", request.params, *flags->given);
                check_fields("", request.params);
                const DatasetState state = make_dataset(request, flags->out,
                                                        session.run(number_from<std::uint64_t>("--seed", flags->seed)));
                session.print(
                    summary(flags->out, state),
                    {{"folder", flags->out}, {"count", state.count}, {"there", state.there}, {"made", state.made}});
            }};
}

}  // namespace fastscene::cli
