#include "fastscene/pipeline/source.h"

#include "fastscene/rooms/document.h"
#include "fastscene/rooms/lexicon.h"

namespace fastscene {
namespace fs = std::filesystem;
namespace {

// A member if the alternative has it, else a default.
template <class Alternative, class T>
T member_of(const SceneSource& source, T Alternative::*member) {
    const auto* one = std::get_if<Alternative>(&source);
    return one ? one->*member : T{};
}

}  // namespace

std::string prompt_of(const SceneSource& source) {
    return std::visit(
        Overloaded{[](const CaptureSource&) { return std::string(); }, [](const auto& one) { return one.prompt; }},
        source);
}
void set_prompt(SceneSource& source, const std::string& prompt) {
    std::visit(Overloaded{[](CaptureSource&) {}, [&](auto& one) { one.prompt = prompt; }}, source);
}
fs::path picture_of(const SceneSource& source) { return member_of(source, &PictureSource::picture); }
fs::path range_map_of(const SceneSource& source) { return member_of(source, &PictureSource::range_map); }
fs::path weights_of(const SceneSource& source) {
    return std::visit(
        Overloaded{[](const PictureSource& one) { return one.weights; },
                   [](const PaintingSource& one) { return one.weights; }, [](const auto&) { return fs::path(); }},
        source);
}
fs::path more_of(const SceneSource& source) { return member_of(source, &PictureSource::more); }

RoomOrigin origin_of(const SceneSource& source) {
    if (const auto* document = std::get_if<DocumentSource>(&source)) return {document->prompt, document->document};
    return {prompt_of(source), {}};
}

DocumentSource document_source(const fs::path& file) { return document_source(load_document(file), file); }

DocumentSource document_source(const RoomDocument& document, const fs::path& file) {
    return {document.prompt.empty() ? room_title(document.type) : document.prompt, file,
            document_json(document).dump()};
}

std::string panorama_backend(const SceneSource& source) {
    return std::visit(
        Overloaded{[](const PictureSource&) { return "image"; }, [](const PaintingSource&) { return "diffusion360"; },
                   [](const auto&) { return "rooms"; }},
        source);
}

std::string title_of(const SceneSource& source) {
    const std::string prompt = prompt_of(source);
    return prompt.empty() ? picture_of(source).stem().string() : prompt;
}

std::string what_is_behind(const SceneSource& source) {
    return std::visit(Overloaded{[](const PromptSource&) { return std::string("a prompt"); },
                                 [](const DocumentSource& one) { return "the room " + one.room.string(); },
                                 [](const PictureSource& one) { return "the picture " + one.picture.string(); },
                                 [](const PaintingSource&) { return std::string("a painted panorama"); },
                                 [](const CaptureSource& one) { return "the photographs of " + one.source.string(); }},
                      source);
}

}  // namespace fastscene
