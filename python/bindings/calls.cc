#include "calls.h"

namespace fastscene::python {

void Caller::tell(const Event& event) {
    if (const auto* warning = std::get_if<WarningEvent>(&event)) {
        const std::lock_guard lock(mutex_);
        warnings_.push_back(warning->text);
    }
    const auto* progress = std::get_if<ProgressEvent>(&event);
    if (progress && !on_progress_.is_none())
        call([&] { on_progress_(progress->work, progress->done, progress->total); });
}

void Caller::check_signals() {
    call([] {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    });
}

void Caller::finish() {
    if (error_) throw py::error_already_set(*error_);
    for (const std::string& text : warnings_)
        if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 2) != 0) throw py::error_already_set();
}

}  // namespace fastscene::python
