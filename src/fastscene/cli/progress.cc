#include "fastscene/cli/progress.h"

#include <fmt/format.h>

#include <ostream>

#include "fastscene/base/error.h"
#include "fastscene/base/json.h"

namespace fastscene::cli {
namespace {

using Seconds = std::chrono::duration<double>;

// A rewritten line is legible at this rate; updating faster would waste time.
constexpr Seconds kLineEvery{0.1};
// Logs should be short: a line per tenth of the work, or after this long a silence.
constexpr int kPlainStepPercent = 10;
constexpr Seconds kPlainEvery{10};
constexpr Seconds kJsonEvery{1};  // a program draws it

std::string clock_text(double seconds) {
    const auto s = static_cast<long>(seconds + 0.5);
    return s >= 3600 ? fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60)
                     : fmt::format("{}:{:02}", s / 60, s % 60);
}

}  // namespace

ProgressStyle progress_style(const std::string& name, bool is_terminal) {
    if (name == "auto") return is_terminal ? ProgressStyle::line : ProgressStyle::plain;
    if (name == "plain") return ProgressStyle::plain;
    if (name == "json") return ProgressStyle::json;
    if (name == "none") return ProgressStyle::none;
    throw UsageError("--progress: expected auto, plain, json or none, found \"{}\"", name);
}

std::string printable(std::string_view text) {
    const auto byte_at = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : std::uint8_t{0};
    };
    const auto continues = [&](std::size_t i) { return (byte_at(i) & 0xc0) == 0x80; };
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const unsigned char byte = byte_at(i);
        const std::size_t length = byte < 0x80 ? 1 : byte >= 0xf0 ? 4 : byte >= 0xe0 ? 3 : 2;
        bool plain = byte < 0x80 ? (byte >= 0x20 && byte != 0x7f) || byte == '\n' || byte == '\t'
                                 : byte >= 0xc2 && byte < 0xf5;
        for (std::size_t k = 1; k < length; ++k) plain = plain && continues(i + k);
        if (byte == 0xc2 && byte_at(i + 1) < 0xa0) plain = false;  // C1 control characters
        // Control characters and invalid UTF-8 are escaped byte by byte.
        if (plain) out += text.substr(i, length);
        else out += fmt::format("\\x{:02x}", byte);
        i += plain ? length : 1;
    }
    return out;
}

void ProgressDisplay::tell(const Event& event) {
    const std::lock_guard guard(mutex_);
    if (const auto* progress = std::get_if<ProgressEvent>(&event)) show(*progress);
    if (const auto* note = std::get_if<NoteEvent>(&event); note && style_ != ProgressStyle::none)
        say("note", note->text);
    if (const auto* warning = std::get_if<WarningEvent>(&event)) say("warning", warning->text);
}

void ProgressDisplay::end_line() {
    if (line_length_ > 0) out_ << '\n' << std::flush;
    line_length_ = 0;
}

void ProgressDisplay::say(const std::string& kind, const std::string& text) {
    end_line();
    if (style_ == ProgressStyle::json)
        out_ << Json{{"event", kind}, {"text", text}}.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
    else out_ << (kind == "note" ? "" : kind + ": ") << printable(text) << std::endl;
}

// Extrapolates the average speed so far.
double ProgressDisplay::seconds_left(const ProgressEvent& event) const {
    if (event.overall >= 0) {
        const double made = event.overall - overall_first_;
        const double spent = Seconds(Clock::now() - overall_begin_).count();
        // Too early, an estimate would fluctuate.
        return made > 0.005 ? spent * (1 - event.overall) / made : -1;
    }
    if (event.done <= 0) return -1;
    const double spent = Seconds(Clock::now() - begin_).count();
    return spent * static_cast<double>(event.total - event.done) / static_cast<double>(event.done);
}

void ProgressDisplay::show(const ProgressEvent& event) {
    if (style_ == ProgressStyle::none) return;
    const auto now = Clock::now();
    if (event.overall >= 0 && overall_first_ < 0) {
        overall_first_ = event.overall;
        overall_begin_ = now;
    }
    if (event.work != work_ || event.done == 0) {
        if (event.work != work_) end_line();
        work_ = event.work;
        begin_ = now;
        shown_ = {};
        shown_percent_ = -1;
    }
    const int percent = static_cast<int>(100 * event.done / event.total);
    const bool finished = event.done >= event.total;
    const Seconds since = now - shown_;
    if (style_ == ProgressStyle::line) {
        if (!finished && since < kLineEvery) return;
    } else {
        const Seconds every = style_ == ProgressStyle::json ? kJsonEvery : kPlainEvery;
        const bool due = percent >= shown_percent_ + kPlainStepPercent || since >= every || shown_percent_ < 0;
        if (!due && !(finished && shown_percent_ < 100)) return;
    }
    if (finished && shown_percent_ == 100) return;
    shown_ = now;
    shown_percent_ = percent;

    const double left = seconds_left(event);
    if (style_ == ProgressStyle::json) {
        Json json{{"event", "progress"}, {"work", event.work}, {"done", event.done}, {"total", event.total}};
        if (event.overall >= 0) json["overall"] = event.overall;
        if (left >= 0) json["seconds_left"] = left;
        out_ << json.dump() << std::endl;
        return;
    }
    std::string text = fmt::format("{:<24} {:>3} %", event.work, percent);
    if (event.overall >= 0) text += fmt::format("   all {:>2.0f} %", 100 * event.overall);
    if (left >= 0 && Seconds(now - begin_).count() > 0.5) text += fmt::format(", {} left", clock_text(left));
    if (style_ == ProgressStyle::plain) {
        out_ << text << std::endl;
        return;
    }
    const std::size_t length = text.size();
    if (length < line_length_) text.append(line_length_ - length, ' ');
    out_ << '\r' << text << std::flush;
    line_length_ = length;
}

}  // namespace fastscene::cli
