// Films of numbered pictures, by ffmpeg.
#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>

#include "fastscene/io/spherical_mp4.h"

namespace fastscene {

struct FilmFrames {
    std::filesystem::path folder;  // 00000.png, 00001.png …
    int count = 0;
    float fps = 30;
};
std::filesystem::path frame_file(const std::filesystem::path& folder, int frame);

// A rate as a fraction: 29.97 is 30000/1001, as television means it; others to a thousandth.
std::string rate_text(float fps);

// Whether the name is a film's: .mp4 or .webm.
bool is_film_name(const std::filesystem::path& path);

// Writes .mp4 (H.264) or .webm (VP9); each frame is shown for exactly one period of the rate, in .webm to a
// millisecond. Odd sizes get a row or column of black. `spherical`: marks the film for players of spheres. Throws Error
// if ffmpeg is not there or fails, Stopped if asked to stop; the frames stay.
void encode_film(const FilmFrames& frames, const std::filesystem::path& film,
                 const std::optional<SphericalFilm>& spherical, std::stop_token stop);
// Throws Error unless ffmpeg is on PATH, naming the film.
void check_ffmpeg(const std::filesystem::path& film);

}  // namespace fastscene
