# Headers of libraries that nearly every source reads are read once (a third of a build's time is theirs). The first target of a kind
# keeps them, the others of that kind share its file; a kind is a set of flags. The preset `dev` builds without, so that every source
# goes on to name what it includes.
set(FASTSCENE_COMMON_HEADERS <algorithm> <array> <atomic> <chrono> <cmath> <cstdint> <cstring> <filesystem> <fstream> <functional> <limits> <map>
  <memory> <mutex> <numeric> <optional> <random> <set> <span> <sstream> <stdexcept> <string> <string_view> <thread> <unordered_map> <utility>
  <variant> <vector> <nlohmann/json.hpp>)

# fastscene_precompile(target kind [headers…])
function(fastscene_precompile target kind)
  # What ccache needs to see through a precompiled header; and GCC 12 then warns of its own std::string more often (GCC bugs 105329, 105651).
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    target_compile_options(${target} PRIVATE -fpch-preprocess -Wno-stringop-overflow -Wno-array-bounds)
  endif()
  get_property(keeper GLOBAL PROPERTY FASTSCENE_PRECOMPILED_${kind})
  if(keeper)
    target_precompile_headers(${target} REUSE_FROM ${keeper})
  else()
    target_precompile_headers(${target} PRIVATE ${FASTSCENE_COMMON_HEADERS} ${ARGN})
    set_property(GLOBAL PROPERTY FASTSCENE_PRECOMPILED_${kind} ${target})
  endif()
endfunction()

# fastscene_own_flags(file flag…): a source compiled for another processor, or with other rounding, than the rest; it shares no
# precompiled header. Source flags come last on the command line, so they win over -march=native.
function(fastscene_own_flags file)
  set_source_files_properties(${PROJECT_SOURCE_DIR}/src/fastscene/${file} PROPERTIES COMPILE_OPTIONS "${ARGN}" SKIP_PRECOMPILE_HEADERS ON)
endfunction()
