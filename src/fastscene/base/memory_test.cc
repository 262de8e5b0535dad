#include "fastscene/base/memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "fastscene/base/file.h"

namespace fastscene {
namespace {

namespace fs = std::filesystem;

TEST(Memory, TheLeastOfMachineAndContainersCounts) {
    const fs::path root = fs::temp_directory_path() / ("fastscene_memory_test_" + std::to_string(::getpid()));
    const auto put = [&](const std::string& name, std::string_view text) {
        make_directories((root / name).parent_path());
        write_file(root / name, text);
    };
    EXPECT_EQ(available_memory(root), 0) << "nothing is known";
    put("proc/meminfo", "MemTotal: 9000 kB\nMemAvailable:    8000 kB\n");
    EXPECT_EQ(available_memory(root), 8000 * 1024);
    put("proc/self/cgroup", "0::/batch/job\n");
    EXPECT_EQ(available_memory(root), 8000 * 1024) << "a group without a limit";
    put("sys/fs/cgroup/batch/job/memory.max", "max\n");
    put("sys/fs/cgroup/batch/memory.max", "5000000\n");
    put("sys/fs/cgroup/batch/memory.current", "4000000\n");
    EXPECT_EQ(available_memory(root), 1000000) << "the limit of the group around it";
    put("sys/fs/cgroup/batch/memory.stat", "anon 7\ninactive_file 500000\n");
    EXPECT_EQ(available_memory(root), 1500000) << "pages of files are given back";
    put("sys/fs/cgroup/batch/memory.current", "9000000\n");
    EXPECT_EQ(available_memory(root), 0);
    put("sys/fs/cgroup/batch/memory.current", "1000000\n");

    put("proc/self/cgroup", "12:cpu,cpuacct:/job\n9:memory:/docker/job\n0::/batch/job\n");
    put("sys/fs/cgroup/memory/docker/memory.limit_in_bytes", "3000000\n");
    put("sys/fs/cgroup/memory/docker/memory.usage_in_bytes", "2000000\n");
    put("sys/fs/cgroup/memory/docker/memory.stat", "inactive_file 9\ntotal_inactive_file 400000\n");
    put("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
    put("sys/fs/cgroup/memory/memory.usage_in_bytes", "5000000\n");
    EXPECT_EQ(available_memory(root), 1400000) << "control groups of version 1";

    put("proc/self/status", "Name:\tfastscene\nVmSize:\t    1000 kB\n");
    put("proc/self/limits",
        "Limit  Soft Limit  Hard Limit  Units\nMax address space         unlimited            unlimited            "
        "bytes\n");
    EXPECT_EQ(available_memory(root), 1400000) << "a shell without a limit";
    put("proc/self/limits",
        "Limit  Soft Limit  Hard Limit  Units\nMax address space         1524000              unlimited            "
        "bytes\n");
    EXPECT_EQ(available_memory(root), 500000) << "ulimit -v";
    fs::remove_all(root);
    EXPECT_GT(available_memory(), 0);
}

}  // namespace
}  // namespace fastscene
