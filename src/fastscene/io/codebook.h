// Codebooks: many values said by the index of the nearest of few (vector quantization). Private to io/.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace fastscene {

// 256 numbers, ascending, by Lloyd's iteration.
using ScalarCodebook = std::array<float, 256>;
ScalarCodebook scalar_codebook(std::vector<float> values);
std::uint8_t nearest_in(const ScalarCodebook& codebook, float value);

struct VectorCodebook {
    std::size_t dimensions = 0;
    std::vector<float> centroids;       // one after the other
    std::vector<std::uint32_t> labels;  // of each point: which centroid
    std::size_t size() const { return dimensions ? centroids.size() / dimensions : 0; }
};
// At most `count` centroids for points of so many dimensions, by k-means in two levels: cells first, centroids inside
// them after; then each point looks for its nearest in the cells around it. All against all would take hundreds of
// times as long for 65536. Deterministic for any number of threads.
VectorCodebook vector_codebook(std::span<const float> points, std::size_t dimensions, std::size_t count);

}  // namespace fastscene
