// For tests: a prompt read without the furniture pack, and what it wishes of a class.
#pragma once

#include <string>
#include <string_view>

#include "fastscene/rooms/rooms.h"

namespace fastscene {

inline PromptSpec read(const std::string& text) { return understand_prompt(text, false); }

inline const PromptObject* object_of(const PromptSpec& spec, std::string_view kind) {
    for (const PromptObject& o : spec.objects)
        if (o.kind == kind && !o.forbidden) return &o;
    return nullptr;
}

}  // namespace fastscene
