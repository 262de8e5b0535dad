#include "fastscene/pipeline/run_folder.h"

namespace fastscene {

std::vector<std::string> RunFolder::owned() {
    std::vector<std::string> names{"run.json", "report.json",  "viewer.html", "preview.jpg", "painting.png",
                                   "painting", "training.jpg", "credits.txt", "metrics"};
    for (const std::string_view stage : kStages) names.emplace_back(stage);
    return names;
}

std::string slug_of(std::string_view text) {
    constexpr std::size_t kLongest = 60;
    std::string slug;
    for (const char c : text) {
        const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        const bool plain = (lower >= 'a' && lower <= 'z') || (lower >= '0' && lower <= '9');
        if (plain) slug += lower;
        else if (!slug.empty() && slug.back() != '-') slug += '-';
        if (slug.size() >= kLongest) break;
    }
    while (!slug.empty() && slug.back() == '-') slug.pop_back();
    return slug.empty() ? "scene" : slug;
}

}  // namespace fastscene
