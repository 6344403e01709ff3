// SPDX-License-Identifier: GPL-3.0-or-later
#include "golden.h"

#include <dlfcn.h>
#include <gnu/libc-version.h>

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <nodal/provenance.h>
#include <nodal/verify.h>

#include "../support/components.h"

namespace nodal::golden {

namespace {

constexpr std::size_t kMostPrinted = 5000;  // of a field, bytes

std::uint64_t fnv1a(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

// Of the flags what changes bits: not -O, -g, -DNDEBUG.
std::string flags_that_count(const std::string& flags) {
  std::istringstream words(flags);
  std::string counting;
  for (std::string word; words >> word;)
    if (!word.starts_with("-O") && !word.starts_with("-g") && word != "-DNDEBUG") counting += word + " ";
  return counting;
}

// The widest that the lanes have kernels for.
std::string instructions() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))
    return "avx512";
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? "avx2" : "sse2";
#else
  return "generic";
#endif
}

Value without_seconds(const Value& table) {
  Value rest;
  for (const auto& [key, value] : table.table())
    if (key != "seconds") rest.set(key, value);
  return rest;
}

}  // namespace

const std::vector<Set>& sets() {
  static const std::vector<Set> all = {
      {"plate",
       5000,
       {"annealing", "annealing-adaptive", "random-search", "nlopt-direct-l", "nlopt-crs2-lm", "nlopt-isres",
        "nlopt-esch", "nlopt-mlsl-lds", "nlopt-ccsaq", "nlopt-slsqp", "multi-start L-BFGS", "ceres-levenberg-marquardt",
        "ceres-dogleg", "gauss-newton"}},
      {"gear", 300, {"annealing-adaptive", "gauss-newton", "nlopt-lbfgs", "nlopt-ccsaq"}},
      {"liver", 2000, {"annealing-adaptive", "gauss-newton", "nlopt-lbfgs", "nlopt-ccsaq"}},
      {"bracket",
       2000,
       {"annealing", "annealing-adaptive", "gauss-newton", "nlopt-lbfgs", "ceres-levenberg-marquardt"}},
      {"block", 100, {"annealing", "annealing-adaptive", "gauss-newton", "nlopt-lbfgs", "nlopt-ccsaq"}},
      {"paper/fig02", 1000, {"annealing", "gauss-newton"}},
      {"paper/fig12", 2000, {"annealing, 100 temperatures", "ceres-levenberg-marquardt"}},
  };
  return all;
}

std::string file_of(const Set& set) {
  std::string name = set.scene + ".jsonl";
  std::ranges::replace(name, '/', '-');
  return name;
}

Value platform() {
  // CHOLMOD's BLAS is whichever library stands behind libblas.so.3; only OpenBLAS can say what it chose.
  using CoreName = const char* (*)();
  const auto core = reinterpret_cast<CoreName>(::dlsym(RTLD_DEFAULT, "openblas_get_corename"));
  (void)components();  // they name their libraries
  const Value built = provenance();
  Value platform;
  platform.set("compiler", built.text_or("compiler", "unknown"));
  platform.set("flags", flags_that_count(built.text_or("flags", "unknown")));
  platform.set("instructions", instructions());
  platform.set("blas_core", core != nullptr ? core() : "unknown");
  platform.set("libc", ::gnu_get_libc_version());
  platform.set("libraries", built.at("libraries"));
  return platform;
}

Study study_of(const Set& set) {
  const std::string scene = std::string(NODAL_SOURCE_DIR "/bench/scenes/") + set.scene + ".toml";
  StudyOverrides overrides;
  overrides.evaluations = set.evaluations;
  overrides.repeats = 1;
  Study study = read_study(scene, components(), overrides);
  study.budget.seconds.reset();
  std::erase_if(study.optimizers,
                [&](const StudyOptimizer& o) { return std::ranges::count(set.optimizers, o.label) == 0; });
  return study;
}

Value kept(const TrialRecord& record) {
  TrialRecord told = untimed(record);
  if (told.best && told.best->x.size() > 200) {
    Value::List x(told.best->x.begin(), told.best->x.end());
    told.reason += fmt::format(" [best x: {:016x}]", fnv1a(to_json(Value(std::move(x)))));
    told.best->x.clear();
  }
  Value all = without_seconds(parse_json(to_json_line(told), "a record"));
  for (auto& [key, value] : all.table())
    if (const std::string text = to_json(value); key != "best" && text.size() > kMostPrinted)
      value = fmt::format("{} bytes, FNV-1a {:016x}", text.size(), fnv1a(text));
  return all;
}

}  // namespace nodal::golden
