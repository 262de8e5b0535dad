#include "fastscene/nn/launch.h"

#include <gtest/gtest.h>

#include <map>

namespace fastscene {
namespace {

Environment with(const std::map<std::string, std::string>& variables) {
    return [variables](const char* name) {
        const auto found = variables.find(name);
        return found == variables.end() ? nullptr : found->second.c_str();
    };
}

const std::map<std::string, std::string> kSrun{{"SLURM_STEP_NUM_TASKS", "8"},
                                               {"SLURM_PROCID", "3"},
                                               {"SLURM_STEP_NODELIST", "gpu[003-010]"},
                                               {"SLURM_JOB_ID", "1234567"},
                                               {"SLURM_STEP_ID", "1"}};

TEST(Launch, TheFirstNodeOfAList) {
    EXPECT_EQ(first_node("node7"), "node7");
    EXPECT_EQ(first_node("node7,node9"), "node7");
    EXPECT_EQ(first_node("gpu[003-010,12],login1"), "gpu003");
    EXPECT_EQ(first_node("rack[2,4]-node[01-16].site"), "rack2-node01.site");
}

TEST(Launch, SrunSaysWhoIsWho) {
    const std::optional<Launch> launch = launch_from(with(kSrun));
    ASSERT_TRUE(launch);
    EXPECT_EQ(launch->processes, 8);
    EXPECT_EQ(launch->process, 3);
    EXPECT_EQ(launch->meet, "gpu003:24568");
}

TEST(Launch, OneProcessIsAlone) {
    EXPECT_FALSE(launch_from(with({})));
    EXPECT_FALSE(launch_from(with({{"SLURM_NTASKS", "8"}, {"SLURM_PROCID", "0"}, {"SLURM_JOB_ID", "7"}})));  // a script
    auto alone = kSrun;
    alone["SLURM_STEP_NUM_TASKS"] = "1";
    EXPECT_FALSE(launch_from(with(alone)));
}

TEST(Launch, AnotherLauncher) {
    auto both = kSrun;
    both.insert({{"RANK", "1"}, {"WORLD_SIZE", "2"}, {"MASTER_ADDR", "head"}, {"MASTER_PORT", "29500"}});
    const std::optional<Launch> launch = launch_from(with(both));
    ASSERT_TRUE(launch);
    EXPECT_EQ(launch->processes, 2);
    EXPECT_EQ(launch->process, 1);
    EXPECT_EQ(launch->meet, "head:29500");
    both["RANK"] = "one";
    EXPECT_THROW(launch_from(with(both)), UsageError);
}

TEST(Launch, WhatTheUserSaysStays) {
    TrainingParams params;
    params.meet = "head:1000";
    take_launch(params, with(kSrun));
    EXPECT_EQ(params.processes, 8);
    EXPECT_EQ(params.process, 3);
    EXPECT_EQ(params.meet, "head:1000");
    params.processes = 2, params.process = 1;
    take_launch(params, with(kSrun));
    EXPECT_EQ(params.processes, 2);
    EXPECT_EQ(params.process, 1);
}

}  // namespace
}  // namespace fastscene
