// The source of a scene. Each alternative defines its fields once, in visit_fields: command line flags, run.json and
// messages are derived from that (source_json.h). A field with a flag is
//
// v("range_map", s.range_map, SourceFlag{"--range", "FILE", "range map"}, "The flag's sentence in --help.");
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

#include "fastscene/panorama/panorama.h"

namespace fastscene {

// A prompt. The described room is laid out and path traced: everything about it is known.
struct PromptSource {
    std::string prompt;
};
struct RoomDocument;  // rooms/document.h

// A room as a document (rooms/document.h), built as it is.
struct DocumentSource {
    std::string prompt;          // the words it came from, or its type
    std::filesystem::path room;  // the file, in messages
    std::string document;        // its text, kept in run.json
    // The run that it is an edit of, from which the new one begins (earlier_run.h), and the hash of that run's stages.
    std::filesystem::path edited_from = {};  // empty: none
    std::string edited_from_hash = {};
};
// A panorama provided by the user.
struct PictureSource {
    std::string prompt;  // describes its content, for upscaling
    std::filesystem::path picture;
    std::filesystem::path range_map;  // empty: range is estimated
    std::filesystem::path more;       // list of further panoramas (panorama/more_panoramas.h); empty: none
    std::filesystem::path weights;    // weights for upscaling; empty: no upscaling
};
// PaintingSource (panorama/panorama.h): a prompt for Diffusion360.

// Photographs with cameras from another program (capture_run.h).
struct CaptureSource {
    std::string kind = "colmap";   // a name in io/capture_io.h: capture_kinds()
    std::filesystem::path source;  // what that kind takes: the model's folder, transforms.json …
    std::filesystem::path images;  // empty: the format's default
    std::filesystem::path masks;   // empty: next to the model, if there are any
    std::filesystem::path points;  // empty: the capture's own, if it has any
};

using SceneSource = std::variant<PromptSource, DocumentSource, PictureSource, PaintingSource, CaptureSource>;

// `flag`: the command line flag, or empty for the positional argument; `kind`: its argument's type; `called`: name in
// messages.
struct SourceFlag {
    std::string_view flag, kind, called;
};
namespace source_flags {
inline constexpr SourceFlag kPrompt{"prompt", "PROMPT", "prompt"};
inline constexpr SourceFlag kWeights{"--weights", "DIR", "weights"};
inline constexpr std::string_view kPromptSentence =
    "The scene in a sentence, for example \"a cozy bedroom with a red armchair\".";
inline constexpr std::string_view kWeightsSentence =
    "Folder of Diffusion360's weights in diffusers' layout: unet/ vae/ text_encoder/ tokenizer/ scheduler/; default: "
    "those of `models pull diffusion360`.";
}  // namespace source_flags

template <class V>
void visit_fields(PromptSource& s, V&& v) {
    v("prompt", s.prompt, source_flags::kPrompt, source_flags::kPromptSentence);
}
template <class V>
void visit_fields(DocumentSource& s, V&& v) {
    v("room", s.room, SourceFlag{"--room", "FILE", "room"},
      "Build the room of this document instead of a prompt's: a room.json of `rooms plan`, of a run, or written by "
      "hand (docs/room-document.md).");
}
template <class V>
void visit_fields(PictureSource& s, V&& v) {
    v("prompt", s.prompt, source_flags::kPrompt, source_flags::kPromptSentence);
    v("picture", s.picture, SourceFlag{"--panorama", "FILE|diffusion360", "picture"},
      "Start from this panorama instead of a prompt: a picture of the whole sphere (2:1) or of a part of it, or the "
      "faces of a cube (docs/photographs.md); or diffusion360: "
      "generate it from the prompt with --weights.");
    v("range_map", s.range_map, SourceFlag{"--range", "FILE", "range map"},
      "Range map of that picture (.exr, .pfm, .tif, 16-bit .png in millimetres); without it range is estimated.");
    v("more", s.more, SourceFlag{"--more", "FILE", "further panoramas"},
      "Further panoramas of the same place with their poses, as a JSON list (docs/depth.md).");
    v("weights", s.weights, source_flags::kWeights, source_flags::kWeightsSentence);
}
template <class V>
void visit_fields(PaintingSource& s, V&& v) {
    v("prompt", s.prompt, source_flags::kPrompt, source_flags::kPromptSentence);
    v("weights", s.weights, source_flags::kWeights, source_flags::kWeightsSentence);
    v("photo", s.photo, SourceFlag{"--photo", "FILE", "photo"},
      "With --panorama diffusion360: a photo to outpaint to a full panorama. Its field of view: "
      "--panorama-photo-fov-deg.");
}
template <class V>
void visit_fields(CaptureSource& s, V&& v) {
    v("kind", s.kind, SourceFlag{"--colmap, --nerfstudio …", "", "kind"}, "Whose cameras they are.");
    v("source", s.source, SourceFlag{"--colmap, --nerfstudio …", "DIR|FILE", "photographs"},
      "Where the cameras are.");
    v("images", s.images, SourceFlag{"--images", "DIR", "pictures"},
      "Folder of the pictures; default: images/ next to the model.");
    v("masks", s.masks, SourceFlag{"--masks", "DIR", "masks"},
      "Folder of masks, white = used; default: masks/ next to the model, if it exists.");
    v("points", s.points, SourceFlag{"--points", "FILE", "points"},
      "Initial points as .ply, instead of the capture's own.");
}

// Calls v(alternative with defaults, how the command line selects it) for those that `make` supports.
template <class V>
void visit_starting_sources(V&& v) {
    v(PromptSource{}, std::string_view("a prompt alone"));
    v(DocumentSource{}, std::string_view("--room"));
    v(PictureSource{}, std::string_view("--panorama FILE"));
    v(PaintingSource{}, std::string_view("--panorama diffusion360"));
}

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

// Whether the panorama was rendered from a known room.
inline bool has_room(const SceneSource& source) {
    return std::holds_alternative<PromptSource>(source) || std::holds_alternative<DocumentSource>(source);
}
RoomOrigin origin_of(const SceneSource& source);
// Throws Error naming file and place if there is no such document, or if it is none.
DocumentSource document_source(const std::filesystem::path& file);
DocumentSource document_source(const RoomDocument& document, const std::filesystem::path& file);
// Empty if there is none.
std::string prompt_of(const SceneSource& source);
void set_prompt(SceneSource& source, const std::string& prompt);  // photographs have no prompt
std::filesystem::path picture_of(const SceneSource& source);
std::filesystem::path range_map_of(const SceneSource& source);
std::filesystem::path more_of(const SceneSource& source);
std::filesystem::path weights_of(const SceneSource& source);  // for Diffusion360
// The backend of its panorama: PanoramaParams::backend.
std::string panorama_backend(const SceneSource& source);
// For display: the prompt, or the picture's name.
std::string title_of(const SceneSource& source);
// The panorama's origin, in messages: "the picture a.jpg".
std::string what_is_behind(const SceneSource& source);

}  // namespace fastscene
