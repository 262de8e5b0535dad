#include "fastscene/trace/backend.h"

#include "fastscene/trace/trace.h"

namespace fastscene {

std::vector<std::string> trace_backend_names() { return registered_names<TraceBackendEntry>(); }

const std::string& about_trace_backends() {
    static const std::string text = [] {
        std::string out = "Renderer of rooms.";
        for (const TraceBackendEntry& e : registered<TraceBackendEntry>())
            out += " " + e.name + ": " + e.about + (&e == &registered<TraceBackendEntry>().back() ? "." : ";");
        return out;
    }();
    return text;
}

}  // namespace fastscene
