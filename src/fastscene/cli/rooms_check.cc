#include <algorithm>
#include <map>

#include "fastscene/cli/flags.h"
#include "fastscene/cli/rooms.h"
#include "fastscene/rooms/lexicon.h"
#include "fastscene/rooms/style.h"
#include "fastscene/rooms/validate.h"

namespace fastscene::cli {
namespace {

void check_names(const char* flag, std::vector<std::string>& names, const std::vector<std::string>& known) {
    if (names.empty()) names = known;
    for (const std::string& name : names)
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw UsageError("{}: expected {}, found \"{}\"", flag, fmt::join(known, ", "), name);
}

void print_report(const CheckReport& report, const Session& session) {
    std::map<std::string, int> kinds;
    Json faulty = Json::array();
    std::string text;
    for (const CheckedRoom& room : report.faulty) {
        Json faults = Json::array();
        for (const Fault& fault : room.faults) {
            ++kinds[fault.kind];
            faults.push_back({{"kind", fault.kind}, {"text", fault.text}});
            text += fmt::format("{}, seed {}: {}: {}\n", room.prompt, room.seed, fault.kind, fault.text);
        }
        faulty.push_back({{"prompt", room.prompt}, {"seed", room.seed}, {"faults", faults}});
    }
    for (const auto& [kind, count] : kinds) text += fmt::format("{} {}, ", count, kind);
    text += fmt::format("{} rooms with {} pieces, {} rooms with faults", report.rooms, report.pieces,
                        report.faulty.size());
    session.print(text, {{"rooms", report.rooms}, {"pieces", report.pieces}, {"faults", kinds}, {"faulty", faulty}});
}

}  // namespace

Verb add_rooms_check(CLI::App& rooms) {
    struct Flags {
        std::string count = "10", seed = "0";
        std::vector<std::string> rooms, styles;
        bool triangles = false;
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = rooms.add_subcommand(
        "check", "Furnishes many rooms and looks for faults: overlaps, blocked doors, floating objects …");
    verb->add_option("--count", flags->count, "Seeds for each room and style (1 to 100000).")
        ->type_name("N")
        ->capture_default_str();
    verb->add_option("--seed", flags->seed, "The first seed.")->type_name("N")->capture_default_str();
    verb->add_option("--rooms", flags->rooms, "Only these rooms, comma-separated.")->type_name("NAMES")->delimiter(',');
    verb->add_option("--styles", flags->styles, "Only these styles, comma-separated.")
        ->type_name("NAMES")
        ->delimiter(',');
    verb->add_flag("--triangles", flags->triangles, "Also test triangles for interpenetration by more than 12 mm.");
    return {verb, [flags](const Session& session) {
                const int count = number_from<int>("--count", flags->count);
                if (count < 1 || count > 100000)
                    throw UsageError("--count: expected a number from 1 to 100000, found {}", count);
                check_names("--rooms", flags->rooms, room_types());
                check_names("--styles", flags->styles, styles());
                const fastscene::Run run = session.run(number_from<std::uint64_t>("--seed", flags->seed));
                const CheckReport report = check_rooms(flags->rooms, flags->styles, count, flags->triangles, run);
                print_report(report, session);
                if (!report.faulty.empty())
                    throw Error("rooms check: expected no faults, found {} rooms with some", report.faulty.size());
            }};
}

}  // namespace fastscene::cli
