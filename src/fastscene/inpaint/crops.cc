#include "fastscene/inpaint/crops.h"

#include <algorithm>

namespace fastscene {
namespace {

struct Box {
    int left, top, right, bottom;  // right and bottom are exclusive
};
bool overlap(const Box& a, const Box& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}
Box hull(const Box& a, const Box& b) {
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right), std::max(a.bottom, b.bottom)};
}

// Cell size for grouping holes: closer ones share a crop anyway.
constexpr int kCell = 16;

// Bounding boxes of holes with margin, merged until none overlap.
std::vector<Box> boxes_of(const ImageMask& hole, int margin) {
    std::vector<Box> boxes;
    for (int top = 0; top < hole.height; top += kCell)
        for (int left = 0; left < hole.width; left += kCell) {
            Box box{hole.width, hole.height, 0, 0};
            for (int y = top; y < std::min(top + kCell, hole.height); ++y)
                for (int x = left; x < std::min(left + kCell, hole.width); ++x)
                    if (hole.at(x, y)) box = hull(box, {x, y, x + 1, y + 1});
            if (box.right == 0) continue;
            box = {std::max(0, box.left - margin), std::max(0, box.top - margin),
                   std::min(hole.width, box.right + margin), std::min(hole.height, box.bottom + margin)};
            // The merged box may overlap others again: restart with it.
            for (std::size_t i = 0; i < boxes.size();)
                if (overlap(boxes[i], box)) {
                    box = hull(box, boxes[i]);
                    boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(i));
                    i = 0;
                } else {
                    ++i;
                }
            boxes.push_back(box);
        }
    return boxes;
}

struct Span {
    int begin, size;
};
// Covers one side of a box with spans of allowed sizes within 0..limit, as far as possible.
std::vector<Span> spans(int begin, int end, int limit, int margin, int multiple, int smallest, int largest) {
    const auto fitted = [&](int from, int length) {
        const int size = std::clamp((length + multiple - 1) / multiple * multiple, smallest, largest);
        return Span{std::max(0, std::min(from, limit - size)), size};
    };
    std::vector<Span> out;
    if (end - begin <= largest) return {fitted(begin, end - begin)};
    const int step = largest - margin, count = (end - begin - margin + step - 1) / step;
    for (int i = 0; i < count; ++i) out.push_back(fitted(std::min(begin + i * step, end - largest), largest));
    return out;
}

}  // namespace

std::vector<Crop> crops_around(const ImageMask& hole, int margin, int multiple, int smallest, int largest) {
    std::vector<Crop> out;
    for (const Box& box : boxes_of(hole, margin))
        for (const Span& y : spans(box.top, box.bottom, hole.height, margin, multiple, smallest, largest))
            for (const Span& x : spans(box.left, box.right, hole.width, margin, multiple, smallest, largest))
                out.push_back({x.begin, y.begin, x.size, y.size});
    return out;
}

}  // namespace fastscene
