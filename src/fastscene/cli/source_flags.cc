#include "fastscene/cli/source_flags.h"

#include <set>
#include <vector>

#include "fastscene/base/error.h"

namespace fastscene::cli {
namespace {

constexpr std::string_view kPicture = "--panorama";

// Writes the texts into the fields of one source.
struct FillFields {
    const SourceTexts& texts;
    template <class T>
    void operator()(std::string_view, T& value, const SourceFlag& flag, std::string_view) const {
        if (const auto found = texts.find(flag.flag); found != texts.end()) value = found->second;
    }
};
struct CollectFlags {
    std::set<std::string, std::less<>>& flags;
    template <class T>
    void operator()(std::string_view, T&, const SourceFlag& flag, std::string_view) const {
        flags.emplace(flag.flag);
    }
};

template <class Source>
std::set<std::string, std::less<>> flags_of(Source source) {
    std::set<std::string, std::less<>> flags;
    visit_fields(source, CollectFlags{flags});
    return flags;
}

// Reports which flags a rejected flag belongs with.
[[noreturn]] void refuse(const std::string& flag, std::string_view found) {
    std::string owners;
    visit_starting_sources([&](auto source, std::string_view brought_by) {
        if (flags_of(source).contains(flag)) owners += (owners.empty() ? "" : " or ") + std::string(brought_by);
    });
    throw UsageError("{}: expected together with {}, found {}", flag, owners, found);
}

template <class Source>
SceneSource filled(const SourceTexts& texts, std::string_view brought_by) {
    const auto known = flags_of(Source{});
    for (const auto& [flag, text] : texts)
        if (!text.empty() && flag != kPicture && !known.contains(flag)) refuse(flag, brought_by);
    Source source;
    visit_fields(source, FillFields{texts});
    return source;
}

}  // namespace

void add_source_flags(CLI::App& app, SourceTexts& texts) {
    std::set<std::string, std::less<>> added;
    const auto add = [&](std::string_view, const auto&, const SourceFlag& flag, std::string_view sentence) {
        if (!added.emplace(flag.flag).second) return;
        app.add_option_function<std::string>(
               std::string(flag.flag),
               [&texts, name = std::string(flag.flag)](const std::string& text) { texts[name] = text; },
               std::string(sentence))
            ->type_name(std::string(flag.kind));
    };
    visit_starting_sources([&](auto source, std::string_view) { visit_fields(source, add); });
}

SceneSource source_of(const SourceTexts& texts, bool painted) {
    const auto picture = texts.find(kPicture);
    if (painted) return filled<PaintingSource>(texts, "--panorama diffusion360");
    if (texts.contains("--room"))
        return document_source(std::get<DocumentSource>(filled<DocumentSource>(texts, "--room")).room);
    if (picture != texts.end() && !picture->second.empty()) return filled<PictureSource>(texts, "--panorama FILE");
    return filled<PromptSource>(texts, "alone");
}

}  // namespace fastscene::cli
