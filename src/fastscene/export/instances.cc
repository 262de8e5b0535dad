#include "fastscene/export/instances.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

#include "fastscene/base/error.h"
#include "fastscene/base/suggest.h"
#include "fastscene/export/identities.h"
#include "fastscene/export/shell.h"
#include "fastscene/rooms/catalogue.h"

namespace fastscene {
namespace {

constexpr std::array<std::string_view, 3> kShellLabels{"floor", "ceiling", "wall"};  // NYU40, in the order of Shell

int nyu40_named(std::string_view label) {
    const auto all = nyu40_labels();
    return static_cast<int>(std::find(all.begin(), all.end(), label) - all.begin());
}

[[noreturn]] void refuse(const char* flag, const std::string& word, const std::set<std::string>& known) {
    const std::vector<std::string> all(known.begin(), known.end());
    const std::string guess = nearest_word(word, all);
    throw UsageError("{}: expected one of {}, found \"{}\"{}", flag, fmt::join(all, ", "), word,
                     guess.empty() ? "" : "; did you mean " + guess + "?");
}

}  // namespace

std::vector<Instance> instances_of(const Room& room) {
    std::vector<Instance> out{{"outside", "outside", 0}};
    const std::vector<std::string> ids = object_ids(room);
    for (std::size_t i = 0; i < ids.size(); ++i)
        out.push_back({ids[i], room.objects[i].kind, nyu40_label(room.objects[i].kind)});
    for (std::size_t k = 0; k < kShellNames.size(); ++k)
        out.push_back({kShellNames[k], kShellNames[k], nyu40_named(kShellLabels[k])});
    return out;
}

std::vector<std::uint16_t> instance_by_mesh(const Room& room) {
    std::vector<std::uint16_t> out;
    for (const Mesh& mesh : room.meshes)
        out.push_back(static_cast<std::uint16_t>(
            mesh.object >= 0 ? at(mesh.object) + 1
                             : room.objects.size() + 1 + static_cast<std::size_t>(shell_of(room, mesh))));
    return out;
}

Json instances_json(const std::vector<Instance>& instances) {
    Json out = Json::array();
    for (std::size_t i = 0; i < instances.size(); ++i)
        out.push_back(
            {{"instance", i}, {"id", instances[i].id}, {"class", instances[i].kind}, {"nyu40", instances[i].nyu40}});
    return out;
}

std::vector<Instance> instances_from_json(const Json& json, const std::string& where) {
    std::vector<Instance> out;
    try {
        for (const Json& entry : json) {
            if (entry.at("instance").get<std::size_t>() != out.size())
                throw Error("{}: expected instance {}, found {}", where, out.size(), entry.at("instance").dump());
            out.push_back({entry.at("id"), entry.at("class"), entry.at("nyu40")});
            if (const int label = out.back().nyu40; label < 0 || label >= static_cast<int>(nyu40_labels().size()))
                throw Error("{}: expected an NYU40 label of 0 to 40, found {}", where, label);
        }
    } catch (const Json::exception&) {
        throw Error("{}: expected instances with \"instance\", \"id\", \"class\" and \"nyu40\"", where);
    }
    return out;
}

std::vector<std::uint16_t> numbers_of(const std::vector<Instance>& instances, const std::vector<std::string>& ids,
                                      const std::vector<std::string>& classes) {
    std::set<std::string> known_ids, known_classes;
    const auto label_of = [](const Instance& i) { return std::string(nyu40_labels()[at(i.nyu40)]); };
    for (const Instance& i : instances) {
        known_ids.insert(i.id);
        known_classes.insert(i.kind);
        known_classes.insert(label_of(i));
    }
    for (const std::string& id : ids)
        if (!known_ids.contains(id)) refuse("--id", id, known_ids);
    for (const std::string& kind : classes)
        if (!known_classes.contains(kind)) refuse("--class", kind, known_classes);
    std::vector<std::uint16_t> out;
    const auto has = [](const std::vector<std::string>& list, const std::string& word) {
        return std::find(list.begin(), list.end(), word) != list.end();
    };
    for (std::size_t i = 0; i < instances.size(); ++i)
        if (has(ids, instances[i].id) || has(classes, instances[i].kind) || has(classes, label_of(instances[i])))
            out.push_back(static_cast<std::uint16_t>(i));
    return out;
}

}  // namespace fastscene
