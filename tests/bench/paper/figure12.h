// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Figure 12 over several sets of points: bench/scenes/paper/fig12.toml with the seed of its points replaced.

#include <optional>
#include <string>
#include <vector>

#include <nodal/study.h>
#include <nodal/trial.h>

namespace nodal::paper {

inline constexpr const char* kOneThird = "0.3333333333333333";
inline constexpr int kSeeds = 10;  ///< of points: 1, 2, …, kSeeds

enum class Fit { annealing, levenberg_marquardt };  ///< the scene's optimizers, in its order

/// What a study of the scene's points leaves open.
struct Figure12 {
  std::string topology = "delaunay";
  std::string poisson = "0.3";
  std::string initial = "\"area\"";  ///< rule of the start, as TOML
  int evaluations = 50000;           ///< per trial
};

/// The scene's study for one set of points; its problems are 0, 1, 5, 15 and 50 iterations.
[[nodiscard]] Study make_study(int seed, const Figure12& figure = {});

/// One trial per set of points of the problem that has so many iterations. Independent of the machine's speed: both
/// methods end by themselves or by their evaluations.
[[nodiscard]] std::vector<TrialRecord> fits(int iterations, Fit fit, const Figure12& figure = {});

[[nodiscard]] double median_start_error(const std::vector<TrialRecord>& records);
[[nodiscard]] double median_best_error(const std::vector<TrialRecord>& records);

/// The scene's iterations.
[[nodiscard]] const std::vector<int>& iteration_counts();

}  // namespace nodal::paper
