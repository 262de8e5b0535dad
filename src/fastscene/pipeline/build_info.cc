#include "fastscene/pipeline/build_info.h"

#include "fastscene/base/hash.h"
#include "fastscene/build_sources.h"  // generated: cmake/build_sources.cmake

namespace fastscene {

std::string_view program_version() { return generated::kVersion; }
std::string_view source_dir() { return generated::kSourceDir; }

std::string code_version(std::string_view stage) {
    // The modules that a stage's result depends on besides the lower layers.
    const auto matters = [stage](std::string_view room) {
        if (room == "metrics") return stage == "scores";  // true pictures and bounds hang on what makes them
        for (const std::string_view other : {"panorama", "depth", "inpaint", "walk", "views", "splat"})
            if (room == other) return room == stage || (stage == "walk" && room == "inpaint");
        const bool makes_rooms = room == "trace" || room == "rooms";
        return makes_rooms ? stage == "panorama" || stage == "depth" || stage == "walk" : true;
    };
    Hash hash;
    for (const auto& [room, sources] : generated::kRooms)
        if (matters(room)) hash.add(room).add(sources);
    return hash.hex();
}

Json build_json() {
    Json json;
    json["fastscene"] = program_version();
    json["compiler"] = generated::kCompiler;
    json["build"] = generated::kBuildType;
    return json;
}

}  // namespace fastscene
