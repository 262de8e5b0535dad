// The subcommands of `rooms`, one file each.
#pragma once

#include "fastscene/cli/verb.h"

namespace fastscene::cli {

Verb add_rooms_sheet(CLI::App& rooms);
Verb add_rooms_check(CLI::App& rooms);
Verb add_rooms_read(CLI::App& rooms);
Verb add_rooms_plan(CLI::App& rooms);
Verb add_rooms_schema(CLI::App& rooms);
Verb add_rooms_dataset(CLI::App& rooms);

}  // namespace fastscene::cli
