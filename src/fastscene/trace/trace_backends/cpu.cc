#include "fastscene/trace/backend.h"

namespace fastscene::trace_backends {

TraceBackendEntry cpu() { return {.name = "cpu", .about = "Embree and threads on the processor", .make = nullptr}; }

}  // namespace fastscene::trace_backends
