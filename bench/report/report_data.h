// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What table, CSV and page are made from: everything a report says, collected once from stored trials.
///
///     ReportData data = collect(stores, registry);
///     data.pictures[label] = exhibit.report(…);  // where the problem can be built again
///     console_table(data), summary_csv(data), report_html(data)

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/analysis.h>
#include <nodal/scrutiny.h>
#include <nodal/store.h>
#include <nodal/study.h>

#include "answer.h"
#include "ends.h"
#include "optimizer_detail.h"
#include "profiles.h"

namespace nodal::report {

/// Best quality so far of one optimizer, or its unseen error there, over each axis.
struct OptimizerCurves {
  std::string optimizer;
  ByAxis<std::vector<CurvePoint>> by_axis;
};

/// The best point of all trials on a problem, which is drawn.
struct BestOfAll {
  std::string optimizer;
  int repeat = 0;
  double quality = 0.0;
  std::vector<double> x;
  std::optional<double> cost = {};
  std::optional<double> digits = {};  ///< of its quality that hold in arithmetic of more (Exhibit::exact_quality), by
                                      ///< the caller
};

/// What a sceptic finds in the trials of an optimizer, and between optimizers (scrutiny.h).
struct OptimizerScrutiny {
  std::string optimizer;
  ClaimsSeen claims;
  std::optional<double> first_to_rest;
};
struct Scrutiny {
  std::vector<OptimizerScrutiny> optimizers;  ///< in the table's order
  std::vector<Alias> aliases;
};

struct ProblemReport {
  std::string kind;                      ///< as the study says it; empty when the manifest doesn't know
  std::string quality_name = "quality";  ///< as the kind calls it
  std::string quality_help = {};
  std::vector<FindingDescription> findings;  ///< those of the kind, then others that records have, each by its name
  ProblemTable table;
  std::vector<RowRequest> contestants = {};    ///< all optimizers of the study, in its order: by it a line looks the
                                               ///< same in the charts of every problem
  std::optional<double> error_per_quality;     ///< relative error / quality where that is one constant: curves hold
                                               ///< quality. None with a prior
  std::vector<OptimizerCurves> curves;         ///< in the table's order; optimizers without a point are left out
  std::vector<OptimizerCurves> unseen_curves;  ///< the same of unseen errors
  std::optional<BestOfAll> best;
  std::vector<BestOfAll> bests = {};        ///< of each optimizer, the best first: the first one is `best`
  std::vector<double> known_point = {};     ///< of the best known quality that was given, where its point was, too …
  double known_quality = 0.0;               ///< … and that quality
  std::optional<double> known_digits = {};  ///< … and its digits, as BestOfAll has them
  Scrutiny scrutiny = {};
  Ends ends = {};
  std::vector<OptimizerDetail> optimizers = {};  ///< in the table's order
  std::vector<std::string> notes;  ///< what is to be known of any result: Exhibit::notes_at the start. By the caller
  ReportPart details;              ///< of how it was made; empty where the manifests say nothing
  std::string fingerprint = {};    ///< of the files it was read from (StudyProblem), as the stores have it

  double least_gap = 0.0;  ///< below it gaps are no targets (convergence.h), and not shown

  /// What gaps, targets and curves are of: "G", "G with prior".
  [[nodiscard]] std::string raced_name() const { return quality_name + (table.has_prior ? " with prior" : ""); }
};

struct FailedTrial {
  std::string problem, optimizer;
  int repeat = 0;
  End end = End::failed;
  std::string reason;
};

/// What runs the study again beside its text.
struct RunAgain {
  std::string file;                    ///< without its folder; empty where stores are of different studies
  std::vector<IncludedFile> included;  ///< what the study is joined with
  std::vector<std::string> settings;   ///< by --set
};

struct ReportData {
  std::string study_name, study_text;
  RunAgain run_again = {};
  std::vector<ProblemReport> problems;
  std::vector<Value> builds;  ///< provenance of every build that ran trials, each once
  std::vector<std::string> warnings;
  std::vector<LeftOut> left_out;
  std::vector<FailedTrial> failed;
  Answer answer;                                ///< empty without trials
  std::vector<ProblemConvergence> convergence;  ///< of the problems, in their order
  std::vector<Profiles> profiles;               ///< over all of them, by axis
  std::map<std::string, ReportPart> pictures;   ///< by problem, filled by the caller

  /// Null where there are none.
  [[nodiscard]] const ConvergenceFigures* figures_of(const std::string& problem, const std::string& optimizer) const;
};

/// Merges the stores: of two stores' records with one key that of the first store counts; problems and optimizers stand
/// in the order in which the manifests name them. A store's records that its current study doesn't ask for (other
/// budgets or seeds) are left out, with a warning. InputError when stores mean different problems by one label, by what
/// the study says or by the files that it names: their figures don't compare.
[[nodiscard]] ReportData collect(std::span<const Store> stores, const Registry& registry);

}  // namespace nodal::report
