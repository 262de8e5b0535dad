// What a scene is made from.
#pragma once

#include <filesystem>
#include <string>

namespace fastscene {

// What a scene is made from: a sentence, or a panorama of the user's, with or without a range map.
struct SceneSource {
    std::string prompt;
    std::filesystem::path picture;  // empty: the prompt is furnished and traced, or painted
    std::filesystem::path range_map;
    std::filesystem::path weights;  // of Diffusion360, which paints the prompt or, where there is a picture, makes it
                                    // larger; empty: neither
    std::filesystem::path photo;    // that Diffusion360 continues all around; empty: it has the prompt alone
    std::filesystem::path more;  // list of further panoramas with their poses (panorama/more_panoramas.h); empty: the
                                 // picture is the only one
    bool is_painted() const { return picture.empty() && !weights.empty(); }
    bool has_room() const {
        return picture.empty() && weights.empty();
    }  // a room of which all is known stands behind the panorama
};

}  // namespace fastscene
