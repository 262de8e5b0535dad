#include <algorithm>
#include <map>
#include <sstream>

#include "fastscene/base/file.h"
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

// One sentence a line; empty lines and comments ("#") are skipped.
std::vector<std::string> sentences_of(const std::string& path) {
    std::vector<std::string> out;
    std::istringstream lines(read_file(path));
    for (std::string line; std::getline(lines, line);) {
        if (line.ends_with('\r')) line.pop_back();
        if (!line.empty() && line.front() != '#') out.push_back(line);
    }
    if (out.empty()) throw UsageError("--sentences: expected a file with a sentence a line, found none in {}", path);
    return out;
}

double percent(double share, double of) { return of > 0 ? 100 * share / of : 0; }

Json measures_json(const CheckReport& report) {
    const LayoutMeasures& m = report.measures;
    Json found = Json::array();
    for (const CheckedRoom& room : report.measured) {
        Json findings = Json::array();
        for (const LayoutFinding& f : room.measures.findings)
            findings.push_back({{"measure", f.measure}, {"text", f.text}});
        found.push_back({{"prompt", room.prompt}, {"seed", room.seed}, {"findings", findings}});
    }
    return {{"pieces", m.pieces},
            {"colliding_percent", percent(m.colliding, m.pieces)},
            {"rooms_with_collisions_percent", percent(m.rooms_colliding, m.rooms)},
            {"navigability_percent", percent(m.navigability, m.rooms)},
            {"outside_percent", percent(m.outside, m.pieces)},
            {"openings", m.openings},
            {"clear_openings_percent", percent(m.clear, m.openings)},
            {"untouched_openings_percent", percent(m.untouched, m.openings)},
            {"free_opening_area_percent", 100 - percent(m.covered_m2, m.opening_m2)},
            {"repeated_forms", m.repeats},
            {"found", found}};
}

std::string measures_text(const CheckReport& report) {
    const LayoutMeasures& m = report.measures;
    std::string text;
    for (const CheckedRoom& room : report.measured)
        for (const LayoutFinding& f : room.measures.findings)
            text += fmt::format("{}, seed {}: {}: {}\n", room.prompt, room.seed, f.measure, f.text);
    const auto row = [&](const char* name, double value, const std::string& of) {
        text += fmt::format("{:<38}{:>8.2f} %  {}\n", name, value, of);
    };
    row("pieces that collide", percent(m.colliding, m.pieces), fmt::format("{} of {}", m.colliding, m.pieces));
    row("rooms with pieces that collide", percent(m.rooms_colliding, m.rooms),
        fmt::format("{} of {}", m.rooms_colliding, m.rooms));
    row("free floor that is connected", percent(m.navigability, m.rooms), "mean of the rooms");
    row("pieces out of bounds", percent(m.outside, m.pieces), fmt::format("{} of {}", m.outside, m.pieces));
    row("doors and windows that are clear", percent(m.clear, m.openings), fmt::format("{} of {}", m.clear, m.openings));
    row("… before which nothing is at all", percent(m.untouched, m.openings),
        fmt::format("{} of {}", m.untouched, m.openings));
    row("area of doors and windows that is free", 100 - percent(m.covered_m2, m.opening_m2),
        fmt::format("of {:.0f} m²", m.opening_m2));
    return text + fmt::format("{:<38}{:>8}\n", "forms repeated without being a set", m.repeats);
}

void print_report(const CheckReport& report, const CheckDepth& depth, const Session& session) {
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
    if (depth.measures) text += measures_text(report);
    for (const auto& [kind, count] : kinds) text += fmt::format("{} {}, ", count, kind);
    text += fmt::format("{} rooms with {} pieces, {} rooms with faults", report.rooms, report.pieces,
                        report.faulty.size());
    Json json{{"rooms", report.rooms}, {"pieces", report.pieces}, {"faults", kinds}, {"faulty", faulty}};
    if (depth.measures) json["measures"] = measures_json(report);
    session.print(text, json);
}

}  // namespace

Verb add_rooms_check(CLI::App& rooms) {
    struct Flags {
        std::string count = "10", seed = "0";
        std::string sentences;
        std::vector<std::string> rooms, styles;
        CheckDepth depth;
    };
    auto flags = std::make_shared<Flags>();
    CLI::App* verb = rooms.add_subcommand(
        "check", "Furnishes many rooms and looks for faults: overlaps, blocked doors, floating objects …");
    verb->add_option("--count", flags->count, "Seeds for each room and style, or sentence (1 to 100000).")
        ->type_name("N")
        ->capture_default_str();
    verb->add_option("--seed", flags->seed, "The first seed.")->type_name("N")->capture_default_str();
    verb->add_option("--rooms", flags->rooms, "Only these rooms, comma-separated.")->type_name("NAMES")->delimiter(',');
    verb->add_option("--styles", flags->styles, "Only these styles, comma-separated.")
        ->type_name("NAMES")
        ->delimiter(',');
    verb->add_option(
            "--sentences", flags->sentences,
            "A text file with one sentence a line, to be furnished instead; lines that begin with # are comments.")
        ->type_name("FILE");
    verb->add_flag("--triangles", flags->depth.triangles,
                   "Also test triangles for interpenetration by more than 12 mm.");
    verb->add_flag("--measures", flags->depth.measures,
                   "Also measure the layouts as SceneEval does: collision, navigability, out of bounds, clearance of "
                   "openings; and forms repeated in a room.");
    verb->footer("Example:\n  fastscene rooms check --measures --count 1 --sentences tests/data/layout_sentences.txt");
    return {verb, [flags](const Session& session) {
                const int count = number_from<int>("--count", flags->count);
                if (count < 1 || count > 100000)
                    throw UsageError("--count: expected a number from 1 to 100000, found {}", count);
                if (!flags->sentences.empty() && !(flags->rooms.empty() && flags->styles.empty()))
                    throw UsageError("--sentences: expected neither --rooms nor --styles beside it");
                check_names("--rooms", flags->rooms, room_types());
                check_names("--styles", flags->styles, styles());
                const fastscene::Run run = session.run(number_from<std::uint64_t>("--seed", flags->seed));
                const CheckReport report = flags->sentences.empty()
                                               ? check_rooms(flags->rooms, flags->styles, count, flags->depth, run)
                                               : check_sentences(sentences_of(flags->sentences), count, flags->depth,
                                                                 run);
                print_report(report, flags->depth, session);
                if (!report.faulty.empty())
                    throw Error("rooms check: expected no faults, found {} rooms with some", report.faulty.size());
            }};
}

}  // namespace fastscene::cli
