// What a scene is made from. Each alternative says its fields once, in visit_fields: from them come the flags of the
// command line, run.json and the messages about them (source_json.h). A field with a flag is
//
//     v("range_map", s.range_map, SourceFlag{"--range", "FILE", "range map"}, "The flag's sentence in --help.");
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

#include "fastscene/panorama/panorama.h"

namespace fastscene {

// A sentence. The room that it describes is laid out and traced: everything about it is known.
struct PromptSource {
    std::string prompt;
};
// A panorama of the user's.
struct PictureSource {
    std::string prompt;  // what it shows, for the network that makes it larger
    std::filesystem::path picture;
    std::filesystem::path range_map;  // empty: range is estimated
    std::filesystem::path more;       // list of further panoramas (panorama/more_panoramas.h); empty: there are none
    std::filesystem::path weights;    // of the network that makes it larger; empty: it stays as it is
};
// PaintingSource (panorama/panorama.h): a sentence that Diffusion360 paints.

// Photographs with the cameras of another program (capture_run.h).
struct CaptureSource {
    std::string kind = "colmap";   // or "nerfstudio"
    std::filesystem::path source;  // the folder, or transforms.json
    std::filesystem::path images;  // empty: the format's own
    std::filesystem::path masks;   // empty: beside the model, where there are some
};

using SceneSource = std::variant<PromptSource, PictureSource, PaintingSource, CaptureSource>;

// `flag`: how the command line calls a field, by itself where that is no word; `kind`: of argument; `called`: by
// people.
struct SourceFlag {
    std::string_view flag, kind, called;
};
namespace source_flags {
inline constexpr SourceFlag kPrompt{"prompt", "PROMPT", "prompt"};
inline constexpr SourceFlag kWeights{"--weights", "DIR", "weights"};
inline constexpr std::string_view kPromptSentence =
    "The scene in a sentence, for example \"a cozy bedroom with a red armchair\".";
inline constexpr std::string_view kWeightsSentence =
    "Folder of Diffusion360's weights as diffusers saves them: unet/ vae/ text_encoder/ tokenizer/ scheduler/; "
    "default: those of `models pull diffusion360`.";
}  // namespace source_flags

template <class V>
void visit_fields(PromptSource& s, V&& v) {
    v("prompt", s.prompt, source_flags::kPrompt, source_flags::kPromptSentence);
}
template <class V>
void visit_fields(PictureSource& s, V&& v) {
    v("prompt", s.prompt, source_flags::kPrompt, source_flags::kPromptSentence);
    v("picture", s.picture, SourceFlag{"--panorama", "FILE|diffusion360", "picture"},
      "Start from this 2:1 picture (.jpg, .png, .webp, .tif, .hdr, .exr) instead of a prompt; or diffusion360: paint "
      "the prompt with --weights.");
    v("range_map", s.range_map, SourceFlag{"--range", "FILE", "range map"},
      "Range map of that picture (.exr, .pfm, .tif, 16-bit .png in millimetres); without it range is estimated.");
    v("more", s.more, SourceFlag{"--more", "FILE", "further panoramas"},
      "Further panoramas of the same place with their poses, a list in JSON (docs/depth.md).");
    v("weights", s.weights, source_flags::kWeights, source_flags::kWeightsSentence);
}
template <class V>
void visit_fields(PaintingSource& s, V&& v) {
    v("prompt", s.prompt, source_flags::kPrompt, source_flags::kPromptSentence);
    v("weights", s.weights, source_flags::kWeights, source_flags::kWeightsSentence);
    v("photo", s.photo, SourceFlag{"--photo", "FILE", "photo"},
      "With --panorama diffusion360: a photo that is continued all around. How wide it sees: "
      "--panorama-photo-fov-deg.");
}
template <class V>
void visit_fields(CaptureSource& s, V&& v) {
    v("kind", s.kind, SourceFlag{"--colmap, --nerfstudio", "", "kind"}, "Whose cameras they are.");
    v("source", s.source, SourceFlag{"--colmap, --nerfstudio", "DIR|FILE", "photographs"}, "Where the cameras are.");
    v("images", s.images, SourceFlag{"--images", "DIR", "pictures"},
      "Folder of the pictures; default: images beside the model.");
    v("masks", s.masks, SourceFlag{"--masks", "DIR", "masks"},
      "Folder of masks, white = counts; default: masks beside the model, where it is.");
}

// Calls v(alternative with its defaults, what brings it about on the command line) for those that `make` starts from.
template <class V>
void visit_starting_sources(V&& v) {
    v(PromptSource{}, std::string_view("a prompt alone"));
    v(PictureSource{}, std::string_view("--panorama FILE"));
    v(PaintingSource{}, std::string_view("--panorama diffusion360"));
}

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

// Whether a room of which all is known stands behind the panorama.
inline bool has_room(const SceneSource& source) { return std::holds_alternative<PromptSource>(source); }
// Empty where there is none.
std::string prompt_of(const SceneSource& source);
void set_prompt(SceneSource& source, const std::string& prompt);  // photographs have none
std::filesystem::path picture_of(const SceneSource& source);
std::filesystem::path range_map_of(const SceneSource& source);
std::filesystem::path more_of(const SceneSource& source);
std::filesystem::path weights_of(const SceneSource& source);  // of Diffusion360
// What makes its panorama: PanoramaParams::backend.
std::string panorama_backend(const SceneSource& source);
// For people: the prompt, or the picture's name.
std::string title_of(const SceneSource& source);
// What is behind the panorama, in messages: "the picture a.jpg".
std::string what_is_behind(const SceneSource& source);

}  // namespace fastscene
