// The columns of result tables: meaning, source of the values, which direction is better.
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
    std::string measure;        // from measure_names(), or "cost", which every scene has
    std::string image_measure;  // from image_measure_names() (metrics/images.h), if computed from pictures
    std::string about;
    bool quoted = false;  // a quoted figure, the same for every scene, without deviation
};
const std::vector<Column>& columns();
const Column& column_of(std::string_view key);  // must exist
std::vector<std::string> column_keys();

}  // namespace fastscene
