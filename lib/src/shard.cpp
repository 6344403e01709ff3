// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/shard.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <unordered_set>

#include <fmt/format.h>

#include <nodal/shown.h>
#include <nodal/trial.h>

namespace nodal {

namespace {

Source option() { return {"--shard", 0}; }

std::optional<std::size_t> number_in(std::string_view text) {
  std::size_t number = 0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && at == end && !text.empty() ? std::optional(number) : std::nullopt;
}

std::optional<std::size_t> variable(const Environment& environment, const char* name) {
  const char* text = environment(name);
  if (!text) return std::nullopt;
  if (const std::optional<std::size_t> number = number_in(text)) return number;
  throw InputError(option(), fmt::format("auto: {} is '{}', which is no whole number; give K/N", name, shown(text)));
}

// A rank from 0 and how many there are, where both are said.
std::optional<Shard> pair(const Environment& environment, const char* rank, const char* size) {
  const std::optional<std::size_t> k = variable(environment, rank), n = variable(environment, size);
  if (!k || !n) return std::nullopt;
  if (*k >= *n) throw InputError(option(), fmt::format("auto: {} is {} and {} is {}; give K/N", rank, *k, size, *n));
  return Shard{*k + 1, *n};
}

std::optional<Shard> rank_in(const Environment& environment) {
  if (const auto found = pair(environment, "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE")) return found;
  if (const auto found = pair(environment, "PMI_RANK", "PMI_SIZE")) return found;
  // Outside of a step a batch script has rank 0 of all, and would run the first share alone.
  return pair(environment, "SLURM_PROCID", "SLURM_STEP_NUM_TASKS");
}

std::optional<Shard> array_task_in(const Environment& environment) {
  const std::optional<std::size_t> id = variable(environment, "SLURM_ARRAY_TASK_ID"),
                                   count = variable(environment, "SLURM_ARRAY_TASK_COUNT");
  if (!id || !count) return std::nullopt;
  const std::size_t first = variable(environment, "SLURM_ARRAY_TASK_MIN").value_or(0);
  const std::size_t step = std::max<std::size_t>(1, variable(environment, "SLURM_ARRAY_TASK_STEP").value_or(1));
  if (*id < first || (*id - first) % step != 0 || (*id - first) / step >= *count)
    throw InputError(option(),
                     fmt::format("auto: task {} is none of {} from {} by {}: an array with gaps has no order; "
                                 "give K/N",
                                 *id, *count, first, step));
  return Shard{(*id - first) / step + 1, *count};
}

Shard automatic(const Environment& environment) {
  const std::optional<Shard> rank = rank_in(environment), task = array_task_in(environment);
  if (!rank && !task)
    throw InputError(option(), "auto finds no variable of Slurm, Open MPI or PMI in the environment; give K/N, as 3/8");
  const Shard inner = rank.value_or(Shard{}), outer = task.value_or(Shard{});
  return {(outer.index - 1) * inner.count + inner.index, outer.count * inner.count};
}

}  // namespace

Shard read_shard(const std::string& text, const Environment& environment) {
  if (text == "auto") return automatic(environment);
  const std::size_t slash = text.find('/');
  const auto part = [&](std::size_t from, std::size_t size) {
    return number_in(std::string_view(text).substr(from, size));
  };
  const std::optional<std::size_t> k = slash == std::string::npos ? std::nullopt : part(0, slash);
  const std::optional<std::size_t> n = k ? part(slash + 1, std::string::npos) : std::nullopt;
  if (!k || !n || *k < 1 || *k > *n)
    throw InputError(option(), fmt::format("'{}' is no share; give K/N with 1 ≤ K ≤ N, as 3/8, or auto", shown(text)));
  return {*k, *n};
}

std::vector<std::string> shard_keys(const Study& study, const Shard& shard) {
  std::vector<std::string> all;
  for (const Trial& trial : all_trials(study)) all.push_back(trial_key(study, trial));
  std::ranges::sort(all);
  std::vector<std::string> own;
  for (std::size_t i = shard.index - 1; i < all.size(); i += shard.count) own.push_back(std::move(all[i]));
  return own;
}

std::vector<std::string> listed_keys(const Study& study, std::string_view text, const std::string& name) {
  std::unordered_set<std::string> known;
  for (const Trial& trial : all_trials(study)) known.insert(trial_key(study, trial));
  std::vector<std::string> keys;
  std::istringstream lines{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::string word;
    std::istringstream(line) >> word;
    if (word.empty() || word.front() == '#') continue;
    if (!known.contains(word))
      throw InputError({name, number},
                       fmt::format("'{}' is the key of no trial of this study; nodal trials prints them", shown(word)));
    keys.push_back(std::move(word));
  }
  return keys;
}

}  // namespace nodal
