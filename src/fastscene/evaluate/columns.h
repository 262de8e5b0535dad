// The columns that a table of results may have: what each means, who fills it, which way is better.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fastscene {

enum class Better { higher, lower, neither };
struct Column {
    std::string key, label, unit;
    Better better = Better::neither;
    int digits = 2;
    std::string measure;        // of measure_names(), or "cost": every scene has it
    std::string image_measure;  // of image_measure_names() (metrics/images.h), where pictures fill it
    std::string about;
    bool quoted = false;  // somebody's figure, the same for every scene: it deviates by nothing
};
const std::vector<Column>& columns();
const Column& column_of(std::string_view key);  // must exist
std::vector<std::string> column_keys();

}  // namespace fastscene
