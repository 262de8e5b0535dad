// A network that knows nothing of the seam of a panorama, run on several turns of it. Private to nn/ (torch).
#pragma once

#include <ATen/core/Tensor.h>

#include <functional>

namespace fastscene::nn {

// color [1, 3, H, W] -> distances [1, H, W] up to one factor for each call.
using DistanceNet = std::function<at::Tensor(const at::Tensor& color)>;
// net(color) for one turn. For more, the geometric mean of what `net` finds in the panorama turned by 1 / turns, 2 /
// turns … of a whole turn, scaled to agree with the first. A pass counts most where it looks straight ahead and nothing
// at its own borders, so that the result closes at the seam and has no other.
at::Tensor over_turns(const at::Tensor& color, int turns, const DistanceNet& net);

}  // namespace fastscene::nn
