// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include <nodal/shard.h>
#include <nodal/trial.h>

#include "../support/messages.h"
#include "toy_compare.h"

namespace nodal {
namespace {

using namespace toy;

// 2 optimizers, 20 repeats; one of them is deterministic and has 3.
Study many() {
  return study(
      "[study]\nrepeats = 20\n[budget]\nevaluations = 9\n[problem]\nkind = \"bowl\"\n"
      "[[optimizer]]\nuse = \"wanderer\"\n[[optimizer]]\nuse = \"wanderer\"\nlabel = \"other\"\n"
      "[[optimizer]]\nuse = \"halving\"\n");
}

Shard automatic(std::map<std::string, std::string> variables) {
  return read_shard("auto", [&](const char* name) {
    const auto found = variables.find(name);
    return found == variables.end() ? nullptr : found->second.c_str();
  });
}

std::string refusal(const std::string& text, const std::map<std::string, std::string>& variables = {}) {
  return message_of([&] {
    if (text == "auto")
      (void)automatic(variables);
    else
      (void)read_shard(text, [](const char*) { return nullptr; });
  });
}

void expect_shard(const Shard& shard, std::size_t index, std::size_t count) {
  EXPECT_EQ(shard.index, index);
  EXPECT_EQ(shard.count, count);
}

TEST(Shards, DealEveryTrialOnceAndEvenly) {
  const Study study = many();
  for (const std::size_t count : {1u, 2u, 3u, 7u, 100u}) {
    std::set<std::string> dealt;
    std::size_t least = 1000, most = 0, all = 0;
    for (std::size_t k = 1; k <= count; ++k) {
      const std::vector<std::string> own = shard_keys(study, {k, count});
      dealt.insert(own.begin(), own.end());
      all += own.size();
      least = std::min(least, own.size());
      most = std::max(most, own.size());
    }
    EXPECT_EQ(all, 43u) << count;
    EXPECT_EQ(dealt.size(), 43u) << count;
    EXPECT_LE(most - least, 1u) << count;
  }
}

// In the order of a study every second trial would be of one optimizer.
TEST(Shards, HaveSomeOfEveryOptimizer) {
  const Study study = many();
  std::map<std::string, std::string> optimizers;
  for (const Trial& trial : all_trials(study))
    optimizers[trial_key(study, trial)] = study.optimizers[trial.optimizer].label;
  for (std::size_t k = 1; k <= 2; ++k) {
    std::map<std::string, int> counts;
    for (const std::string& key : shard_keys(study, {k, 2})) ++counts[optimizers.at(key)];
    EXPECT_GE(counts["wanderer"], 4) << k;
    EXPECT_GE(counts["other"], 4) << k;
  }
}

TEST(Shards, AreGivenOrRefused) {
  expect_shard(read_shard("3/8", [](const char*) { return nullptr; }), 3, 8);
  for (const char* wrong : {"", "3", "0/8", "9/8", "3/", "/8", "-1/8", "3/8x", "a/b", "1/0", "3 /8"})
    EXPECT_NE(refusal(wrong).find("give K/N"), std::string::npos) << wrong;
}

TEST(Shards, AreWhatASchedulerSays) {
  expect_shard(automatic({{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "4"}}), 1, 4);
  expect_shard(automatic({{"PMI_RANK", "3"}, {"PMI_SIZE", "4"}}), 4, 4);
  expect_shard(automatic({{"SLURM_PROCID", "1"}, {"SLURM_STEP_NUM_TASKS", "2"}}), 2, 2);
  expect_shard(
      automatic({{"SLURM_ARRAY_TASK_ID", "7"}, {"SLURM_ARRAY_TASK_COUNT", "3"}, {"SLURM_ARRAY_TASK_MIN", "5"}}), 3, 3);
  expect_shard(automatic({{"SLURM_ARRAY_TASK_ID", "9"},
                          {"SLURM_ARRAY_TASK_COUNT", "3"},
                          {"SLURM_ARRAY_TASK_MIN", "1"},
                          {"SLURM_ARRAY_TASK_STEP", "4"}}),
               3, 3);
}

// An array whose tasks start several processes each: every pair has a share of its own.
TEST(Shards, OfRanksWithinAnArrayAreAllDifferent) {
  std::set<std::size_t> seen;
  for (int task = 0; task < 3; ++task)
    for (int rank = 0; rank < 4; ++rank) {
      const Shard shard = automatic({{"SLURM_ARRAY_TASK_ID", std::to_string(task)},
                                     {"SLURM_ARRAY_TASK_COUNT", "3"},
                                     {"SLURM_PROCID", std::to_string(rank)},
                                     {"SLURM_STEP_NUM_TASKS", "4"}});
      EXPECT_EQ(shard.count, 12u);
      seen.insert(shard.index);
    }
  EXPECT_EQ(seen.size(), 12u);
  EXPECT_EQ(*seen.begin(), 1u);
  EXPECT_EQ(*seen.rbegin(), 12u);
}

// The first task of a batch script, outside of a step, would otherwise run a share and leave the rest undone.
TEST(Shards, AreNotGuessed) {
  EXPECT_NE(refusal("auto").find("auto finds no variable"), std::string::npos);
  EXPECT_NE(refusal("auto", {{"SLURM_PROCID", "0"}, {"SLURM_NTASKS", "8"}}).find("auto finds no variable"),
            std::string::npos);
  EXPECT_NE(refusal("auto", {{"PMI_RANK", "4"}, {"PMI_SIZE", "4"}}).find("PMI_RANK is 4"), std::string::npos);
  EXPECT_NE(refusal("auto", {{"PMI_RANK", "x"}, {"PMI_SIZE", "4"}}).find("no whole number"), std::string::npos);
  EXPECT_NE(
      refusal("auto", {{"SLURM_ARRAY_TASK_ID", "9"}, {"SLURM_ARRAY_TASK_COUNT", "3"}, {"SLURM_ARRAY_TASK_MIN", "1"}})
          .find("gaps"),
      std::string::npos);
}

TEST(Shards, InOneStoreMakeTheTrialsOfOneProcess) {
  const TemporaryDirectory whole, shared;
  const Study study = many();
  EXPECT_EQ(run(study, whole).ran, 43u);
  for (std::size_t k = 1; k <= 4; ++k) {
    CompareOptions options;
    options.keys = shard_keys(study, {k, 4});
    const CompareResult result = run(study, shared, options);
    EXPECT_EQ(result.ran, options.keys->size());
  }
  EXPECT_EQ(outcomes(whole), outcomes(shared));
  EXPECT_EQ(run(study, shared).ran, 0u);
}

TEST(ListedTrials, AreKeysOfTheStudy) {
  const Study study = many();
  const std::vector<std::string> all = shard_keys(study, {1, 1});
  EXPECT_EQ(listed_keys(study, "# mine\n" + all[3] + "\tbowl\twanderer\t7\n\n" + all[0] + "\n", "list"),
            (std::vector<std::string>{all[3], all[0]}));
  EXPECT_TRUE(listed_keys(study, "", "list").empty());
  EXPECT_EQ(message_of([&] {
              (void)listed_keys(study, all[0] + "\nnonsense\n", "list");
            }).rfind("list:2: 'nonsense' is the key of no trial", 0),
            0u);
}

}  // namespace
}  // namespace nodal
