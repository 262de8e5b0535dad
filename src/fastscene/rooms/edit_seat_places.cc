// Places of seats at a table: evenly around it, and who goes to which.
#include <algorithm>
#include <cmath>

#include "fastscene/rooms/edit_parts.h"

namespace fastscene::editing {

Seat seat_of(Vec3f middle, Vec3f out, float off) { return {middle + out * off, yaw_of(out * -1.f)}; }

std::vector<std::size_t> left_over(const std::vector<Vec3f>& from, const std::vector<Seat>& to,
                                   std::vector<std::size_t>& taken) {
    std::vector<bool> used(to.size());
    taken.assign(from.size(), 0);
    std::vector<bool> done(from.size());
    for (std::size_t n = 0; n < from.size(); ++n) {
        float least = 1e9f;
        std::size_t seat = 0, place = 0;
        for (std::size_t i = 0; i < from.size(); ++i)
            for (std::size_t k = 0; k < to.size() && !done[i]; ++k)
                if (const float far = length(from[i] - to[k].at); !used[k] && far < least)
                    least = far, seat = i, place = k;
        taken[seat] = place, used[place] = done[seat] = true;
    }
    std::vector<std::size_t> out;
    for (std::size_t k = 0; k < to.size(); ++k)
        if (!used[k]) out.push_back(k);
    return out;
}

std::vector<Seat> seats_around(const Placed& table, Vec3f middle, int count, Vec3f size, float first, float least) {
    const float radius = table.piece.size_m.x / 2;
    std::vector<Seat> out;
    for (const float gap : {least, std::max(least, 0.08f), std::max(least, 0.15f)}) {
        const auto n = static_cast<float>(count);
        if (count > 2 && 2 * (radius + gap) * std::tan(kPi / n) < size.x) continue;
        for (int k = 0; k < count; ++k) {
            const float angle = first + 2 * kPi * static_cast<float>(k) / n;
            out.push_back(seat_of(middle, {std::sin(angle), 0, std::cos(angle)}, radius + gap + size.z / 2));
        }
        break;
    }
    return out;
}

std::pair<std::vector<float>, float> spread(const std::vector<float>& free, int count) {
    constexpr float kStep = kPi / 36;
    if (count < 2) return {free.empty() ? free : std::vector<float>{free.front()}, 2 * kPi};
    for (float apart = 2 * kPi / static_cast<float>(count); apart > kStep; apart -= kStep)
        for (std::size_t first = 0; first < free.size(); ++first) {
            std::vector<float> out{free[first]};
            for (std::size_t k = first + 1; k < free.size() && static_cast<int>(out.size()) < count; ++k)
                if (free[k] - out.back() > apart - 1e-3f && free[first] + 2 * kPi - free[k] > apart - 1e-3f)
                    out.push_back(free[k]);
            if (static_cast<int>(out.size()) == count) return {out, apart};
        }
    return {{}, 0};
}

}  // namespace fastscene::editing
