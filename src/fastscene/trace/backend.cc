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

void check_device(const TraceBackend& backend, const std::string& flag) {
    for (const TraceBackendEntry& e : registered<TraceBackendEntry>())
        if (e.check_device && (e.name == backend.name || backend.device == "list"))
            e.check_device(backend.device, flag);
}

}  // namespace fastscene
