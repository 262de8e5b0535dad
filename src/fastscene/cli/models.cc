// models list, pull, verify, path: fetches third-party weights and verifies them.
#include <algorithm>
#include <cmath>

#include "fastscene/cli/verb.h"
#include "fastscene/models/pull.h"

namespace fastscene::cli {
namespace {

std::string size_text(std::int64_t bytes) {
    if (bytes >= 1000000000) return fmt::format("{:.2f} GB", static_cast<double>(bytes) / 1e9);
    if (bytes >= 1000000) return fmt::format("{:.0f} MB", static_cast<double>(bytes) / 1e6);
    return fmt::format("{:.0f} kB", std::ceil(static_cast<double>(bytes) / 1e3));
}

struct Presence {
    std::size_t files = 0;
    std::int64_t bytes = 0;
};
Presence presence_of(const Model& model) {
    Presence here;
    for (const ModelFile& file : model.files)
        if (const auto path = file_in_cache(model, file)) {
            ++here.files;
            here.bytes += static_cast<std::int64_t>(std::filesystem::file_size(*path));
        }
    return here;
}

std::string state_text(const Model& model, const Presence& here) {
    if (here.files == model.files.size()) return "here, " + size_text(here.bytes);
    if (here.files > 0) return fmt::format("{} of {} files here", here.files, model.files.size());
    if (model.by_hand()) return "by hand";
    const bool all_known = std::all_of(model.files.begin(), model.files.end(),
                                       [](const ModelFile& file) { return file.bytes > 0; });
    return all_known ? size_text(model.known_bytes()) : "size not known";
}

Json json_of(const Model& model, const Presence& here) {
    Json files = Json::array();
    for (const ModelFile& file : model.files) {
        const std::vector<std::string> urls = urls_of(model, file);
        files.push_back({{"name", file.name},
                         {"names", file.names()},
                         {"urls", urls},
                         {"bytes", file.bytes ? Json(file.bytes) : Json()},
                         {"sha256", file.sha256.empty() ? Json() : Json(file.sha256)}});
    }
    return {{"name", model.name},
            {"what", model.what},
            {"use", model.use},
            {"licence", model.licence},
            {"licence_url", model.licence_url},
            {"home", model.home},
            {"by_hand", model.by_hand()},
            {"mirror_folder", model.folder},
            {"folder", (models_root() / model.folder).string()},
            {"here", here.files == model.files.size()},
            {"accepted", is_accepted(model)},
            {"files", files}};
}

// As on a mirror: FOLDER/FILE, or one of several.
std::string file_text(const Model& model, const ModelFile& file) {
    std::string text;
    for (const std::string& name : file.names()) text += (text.empty() ? "" : " or ") + model.folder + "/" + name;
    return text + (file.bytes > 0 ? ", " + size_text(file.bytes) : "");
}

void list(const Session& session) {
    std::string text;
    Json json = Json::array();
    for (const Model& model : models()) {
        const Presence here = presence_of(model);
        text += fmt::format("{:<23} {:<22} {}\n{:<23} {:<22} licence: {}\n", model.name, state_text(model, here),
                            model.what, "", "", model.licence);
        for (const ModelFile& file : model.files)
            text += fmt::format("{:<23} {:<22} {}\n", "", "", file_text(model, file));
        json.push_back(json_of(model, here));
    }
    session.print(text + fmt::format("in {} (FASTSCENE_MODELS names another folder)", models_root().string()), json);
}

std::string report_text(const ModelReport& report) {
    std::string text;
    for (const FileReport& file : report.files) {
        const std::string known = file.known ? "" : ", hash not known beforehand";
        text += fmt::format("{:<9} {}/{}{}\n", name_of(file.state), report.model, file.name,
                            !file.problem.empty() ? ": " + file.problem
                            : file.sha256.empty() ? ""
                                                  : fmt::format(": {}{}", file.sha256, known));
    }
    return text;
}

void print_reports(const std::vector<ModelReport>& reports, const Session& session) {
    std::string text;
    Json json = Json::array();
    for (const ModelReport& report : reports) {
        text += report_text(report);
        json.push_back(to_json(report));
    }
    if (!text.empty()) text.pop_back();
    if (reports.empty()) text = fmt::format("no file of any model is here, in {}", models_root().string());
    session.print(text, json);
}

Verb add_regularizers(CLI::App& models_verb) {
    struct Flags {
        std::vector<std::string> names;
        std::string mirror;
        bool accept = false;
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = models_verb.add_subcommand(
        "pull",
        "Downloads models. Interrupted downloads are resumed by the same command; damaged files are downloaded again.");
    verb->add_option("names", flags->names, "Names from `models list`.")->type_name("NAME")->required();
    verb->add_flag("--accept", flags->accept, "I have read the licence and accept it. Required once per model.");
    verb->add_option("--mirror", flags->mirror,
                     "A folder or URL that contains FOLDER/FILE for each file, for sites without internet access; "
                     "default: $FASTSCENE_MODELS_MIRROR.")
        ->type_name("DIR|URL");
    return {verb, [flags](const Session& session) {
                const Run run = session.run(0);
                std::vector<const Model*> wanted;
                for (const std::string& name : flags->names)
                    wanted.push_back(&model_named(name));  // validate all names before downloading
                std::vector<ModelReport> reports;
                for (const Model* model : wanted)
                    reports.push_back(pull_model(
                        *model,
                        {models_root(), flags->mirror.empty() ? default_mirror() : flags->mirror, flags->accept}, run));
                print_reports(reports, session);
            }};
}

std::string remedy_for(const ModelReport& report) {
    const Model& model = model_named(report.model);
    const std::string pull = "fastscene models pull " + model.name;
    return model.by_hand() ? fmt::format("fetch them by hand at {} into {}, or from a mirror: {} --mirror DIR",
                                         model.home, report.folder.string(), pull)
                           : fmt::format("`{}` fetches them again", pull);
}

Verb add_verify(CLI::App& models_verb) {
    auto names = std::make_shared<std::vector<std::string>>();
    CLI::App* verb = models_verb.add_subcommand(
        "verify", "Verifies the files against their known hashes, or those recorded when they were first seen.");
    verb->add_option("names", *names, "Names from `models list`; none: all installed ones.")->type_name("NAME");
    return {verb, [names](const Session& session) {
                const Run run = session.run(0);
                std::vector<ModelReport> reports;
                for (const std::string& name : *names)
                    reports.push_back(verify_model(model_named(name), models_root(), run));
                if (names->empty())
                    for (const Model& model : models())
                        if (presence_of(model).files > 0) reports.push_back(verify_model(model, models_root(), run));
                print_reports(reports, session);
                for (const ModelReport& report : reports)
                    if (!report.whole())
                        throw Error("models verify: expected whole models, found {} missing or damaged files in {}; {}",
                                    std::count_if(report.files.begin(), report.files.end(),
                                                  [](const FileReport& f) { return !f.problem.empty(); }),
                                    report.model, remedy_for(report));
            }};
}

Verb add_path(CLI::App& models_verb) {
    auto name = std::make_shared<std::string>();
    CLI::App* verb = models_verb.add_subcommand(
        "path", "Prints where a model is stored, or where to put it if it must be downloaded by hand.");
    verb->add_option("name", *name, "A name from `models list`; none: the folder of all models.")->type_name("NAME");
    return {verb, [name](const Session& session) {
                const std::string path = (name->empty() ? models_root() : models_root() / model_named(*name).folder)
                                             .string();
                session.print(path, {{"path", path}});
            }};
}

}  // namespace

Verb add_models(CLI::App& app) {
    CLI::App* verb = app.add_subcommand("models", "Third-party weights: list, download, verify.");
    verb->require_subcommand(1);
    verb->footer("Examples:\n  fastscene models list\n  fastscene models pull lpips --accept");
    CLI::App* list_verb = verb->add_subcommand(
        "list", "Lists the models that this program can use, their licences, and which are installed.");
    const std::vector<Verb> parts{{list_verb, list}, add_regularizers(*verb), add_verify(*verb), add_path(*verb)};
    for (const Verb& part : parts) part.app->fallthrough();  // common flags belong to `models`
    return {verb, [parts](const Session& session) {
                for (const Verb& part : parts)
                    if (part.app->parsed()) part.act(session);
            }};
}

}  // namespace fastscene::cli
