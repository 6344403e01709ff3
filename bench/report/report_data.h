// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What table, CSV and page are made from: everything a report says, collected once from stored trials.
///
///     ReportData data = collect(stores);
///     data.pictures[label] = plates_html(make_plates(…));  // plates.h, html.h: where a problem is elastic
///     console_table(data), summary_csv(data), report_html(data)

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/analysis.h>
#include <nodal/store.h>
#include <nodal/study.h>

#include "details.h"

namespace nodal::report {

/// Best quality so far of one optimizer, over each axis.
struct OptimizerCurves {
  std::string optimizer;
  std::array<std::vector<CurvePoint>, 3> by_axis;  ///< by Axis
};

/// The best point of all trials on a problem, from which plates are drawn.
struct BestOfAll {
  std::string optimizer;
  int repeat = 0;
  double quality = 0.0;
  std::vector<double> x;
};

struct ProblemReport {
  std::string kind;  ///< as the study says it; empty when the manifest doesn't know
  ProblemTable table;
  std::optional<double>
      error_per_quality;                ///< relative error / quality where that is one constant: curves hold quality
  std::vector<OptimizerCurves> curves;  ///< in the table's order; optimizers without a point are left out
  std::optional<BestOfAll> best;
  SystemDetails details;  ///< empty where the manifests have none
};

struct FailedTrial {
  std::string problem, optimizer;
  int repeat = 0;
  End end = End::failed;
  std::string reason;
};

struct ReportData {
  std::string study_name, study_text;
  std::vector<ProblemReport> problems;
  std::vector<Value> builds;  ///< provenance of every build that ran trials, each once
  std::vector<std::string> warnings;
  std::vector<LeftOut> left_out;
  std::vector<FailedTrial> failed;
  std::map<std::string, std::string> pictures;  ///< HTML by problem, filled by the caller
};

/// Merges the stores: of two stores' records with one key that of the first store counts; problems and optimizers stand
/// in the order in which the manifests name them. A store's records that its current study doesn't ask for (other
/// budgets or seeds) are left out, with a warning. InputError when stores mean different problems by one label: their
/// figures don't compare.
[[nodiscard]] ReportData collect(std::span<const Store> stores);

}  // namespace nodal::report
