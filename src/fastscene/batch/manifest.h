// A batch on disk, for processes that share nothing but its folder: batch.json has the settings, scenes.jsonl the
// scenes that are left. They are made in chunks; each chunk has its own journal, tasks/NUMBER.jsonl.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fastscene/batch/batch.h"

namespace fastscene {

struct ChunkPlan {
    int scenes = 0;    // that are left
    int of_chunk = 1;  // scenes
    int chunks() const { return (scenes + of_chunk - 1) / of_chunk; }
};

// What must not differ between the processes of a batch: version and hash of the code that makes scenes.
std::string batch_version();

// batch.json of these settings.
Json batch_settings(int total, const BatchParams& params);

// Writes the manifest of all scenes that the journals do not know as done. The journals of earlier chunks go into the
// batch's own. `of_chunk` 0: as many as keep the chunks within `most_chunks`. Throws UsageError if there would be more.
// No process may work on the batch.
ChunkPlan write_manifest(const std::vector<BatchScene>& scenes, const std::filesystem::path& folder,
                         const BatchParams& params, int of_chunk, int most_chunks);

// The same for schedulers that the program has no interface to. Throws Error if another process works on the batch.
ChunkPlan prepare_chunks(const std::vector<BatchScene>& scenes, const std::filesystem::path& folder,
                         const BatchParams& params, int of_chunk);

struct Chunk {
    std::vector<BatchScene> scenes;
    BatchParams params;  // without program, threads and scratch
};
// Throws UsageError if there is no such manifest or chunk, Error if another version of the program wrote it.
Chunk read_chunk(const std::filesystem::path& folder, int number);

}  // namespace fastscene
