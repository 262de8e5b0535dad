// Normals for meshes that come without: smooth, except across edges sharper than 40 degrees. Private to io/.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "fastscene/math/vec.h"

namespace fastscene {

class SmoothNormals {
  public:
    explicit SmoothNormals(std::size_t positions) : around_(positions) {}

    // `normal`: as long as the face's area, times two.
    void add(const std::array<std::size_t, 3>& positions, Vec3f normal) {
        for (const std::size_t p : positions) around_[p].push_back(normals_.size());
        normals_.push_back(normal);
    }
    // Of the face added as number `face`: its winding was wrong.
    void turn(std::size_t face) { normals_[face] = -normals_[face]; }
    // The area-weighted mean normal of the faces around a position that deviate by less than 40 degrees from `own`.
    Vec3f at(std::size_t position, Vec3f own) const {
        constexpr float kSmoothCosine = 0.766f;
        // A fan of very many triangles would take time by their square. Those seen are flat.
        constexpr std::size_t kMostFaces = 1024;
        const std::vector<std::size_t>& faces = around_[position];
        const Vec3f unit = normalize(own);
        Vec3f sum{};
        if (faces.size() <= kMostFaces)
            for (const std::size_t i : faces) {
                const float l = length(normals_[i]);
                if (l > 0 && dot(normals_[i], unit) > kSmoothCosine * l) sum += normals_[i];
            }
        return length(sum) > 0 ? normalize(sum) : unit;
    }

  private:
    std::vector<std::vector<std::size_t>> around_;
    std::vector<Vec3f> normals_;
};

}  // namespace fastscene
