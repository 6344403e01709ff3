// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/record.h>

#include <fmt/format.h>

#include <nodal/shown.h>

#include "json_without_places.h"
#include "record_archive.h"

namespace nodal {

// One description of each table serves both directions: `describe(archive, table)` names every field once, the Writer
// archive makes JSON of it and the Reader archive checks and fills it. They are found by their arguments' namespace, so
// they can't hide in a namespace without a name. `T` is the table, const when it is written.

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, PointSummary>
void describe(Archive& archive, T& point) {
  archive.field("cost", point.cost);
  archive.field("quality", point.quality);
  archive.field("relative_error", point.relative_error);
  archive.field("data_quality", point.data_quality);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, BestPoint>
void describe(Archive& archive, T& best) {
  archive.field("evaluation", best.evaluation);
  describe(archive, best.summary);
  archive.field("x", best.x);
  archive.field("at_bounds", best.at_bounds);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, Counts>
void describe(Archive& archive, T& counts) {
  archive.field("evaluations", counts.evaluations);
  archive.field("values", counts.values);
  archive.field("gradients", counts.gradients);
  archive.field("residuals", counts.residuals);
  archive.field("jacobians", counts.jacobians);
  archive.field("products", counts.products);
  archive.field("proposed", counts.proposed);
  archive.field("accepted", counts.accepted);
  archive.field("refused", counts.refused);
}

struct WorkAndUnit {
  Work work;
  double flops_per_value = 0.0;
};

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, WorkAndUnit>
void describe(Archive& archive, T& entry) {
  archive.field("factorizations", entry.work.factorizations);
  archive.field("solves", entry.work.solves);
  archive.field("rank_one_updates", entry.work.rank_one_updates);
  archive.field("flops", entry.work.flops);
  archive.field("factorization_flops", entry.work.factorization_flops);
  archive.field("flops_per_value", entry.flops_per_value);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, Seconds>
void describe(Archive& archive, T& seconds) {
  archive.field("total", seconds.total);
  archive.field("evaluation", seconds.evaluation);
  archive.field("optimizer", seconds.optimizer);
  archive.field("harness", seconds.harness);
  archive.field("to_best", seconds.to_best);
  archive.field("cpu", seconds.cpu);
  archive.field("warm_up", seconds.warm_up);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, Conditions>
void describe(Archive& archive, T& conditions) {
  archive.field("build", conditions.build);
  archive.field("processor", conditions.processor);
  archive.field("jobs", conditions.jobs);
  archive.field("cores", conditions.cores);
  archive.unusual("beside_others", conditions.beside_others, false);
  archive.unusual("stopped", conditions.stopped, false);
  archive.field("core", conditions.core);
  archive.field("preempted", conditions.preempted);
  archive.field("waited", conditions.waited);
  archive.field("pace", conditions.pace);
  archive.field("cold", conditions.cold);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, AuditRecord>
void describe(Archive& archive, T& audit) {
  archive.field("stationarity", audit.stationarity);
  archive.field("digits", audit.digits);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, ClaimRecord>
void describe(Archive& archive, T& claim) {
  archive.field("cost", claim.cost);
  archive.field("x_equals_best", claim.x_equals_best);
  archive.field("evaluations", claim.evaluations);
  archive.field("status", claim.status);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, MovesReport>
void describe(Archive& archive, T& moves) {
  archive.field("choices", moves.choices);
  archive.field("more_choices", moves.more_choices);
  archive.field("checks", moves.checks);
  archive.field("taken_back", moves.taken_back);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, Health>
void describe(Archive& archive, T& health) {
  archive.field("error_estimate", health.error_estimate);
  archive.field("cost_error", health.cost_error);
  archive.field("residual", health.residual);
  archive.field("drift", health.drift);
  archive.findings(health.findings);
  archive.field("refused", health.refused);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, ValidatedStop>
void describe(Archive& archive, T& stop) {
  archive.field("evaluation", stop.evaluation);
  archive.field("fitted_evaluation", stop.fitted_evaluation);
  archive.field("fitted_quality", stop.fitted_quality);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, UnseenRecord>
void describe(Archive& archive, T& unseen) {
  archive.field("names", unseen.names);
  archive.field("points", unseen.points);
  archive.unusual("failed", unseen.failed, std::int64_t{0});
  archive.optional_table("stop", unseen.stop);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, TrialRecord>
void describe(Archive& archive, T& record,
              std::conditional_t<std::is_const_v<T>, const WorkAndUnit, WorkAndUnit>& work) {
  archive.field("schema", record.schema);
  archive.field("key", record.key);
  archive.unusual("attempt", record.attempt, std::int64_t{1});
  archive.field("problem", record.problem);
  archive.field("optimizer", record.optimizer);
  archive.field("use", record.use);
  archive.field("repeat", record.repeat);
  archive.field("seed", record.seed);
  archive.field("end", record.end);
  archive.unusual("limited", record.limited, false);
  archive.field("reason", record.reason);
  archive.field("options", record.options);
  archive.table("start", record.start);
  archive.optional_table("best", record.best);
  archive.table("counts", record.counts);
  archive.table("work", work);
  archive.table("seconds", record.seconds);
  archive.optional_table("conditions", record.conditions);
  archive.field("trace", record.trace);
  archive.optional_table("claimed", record.claimed);
  archive.optional_table("moves", record.moves);
  archive.table("health", record.health);
  archive.optional_table("audit", record.audit);
  archive.optional_table("unseen", record.unseen);
}

std::string_view to_string(End end) noexcept { return kEndNames[static_cast<int>(end)]; }

bool has_died(End end) noexcept { return end == End::timeout || end == End::crashed; }

bool is_failure(End end) noexcept { return end == End::failed || has_died(end); }

std::string to_json_line(const TrialRecord& record) {
  const WorkAndUnit work{record.work, record.flops_per_value};
  Writer writer;
  describe(writer, record, work);
  return to_json(writer.result);
}

TrialRecord parse_record(std::string_view line, const std::string& name) {
  const Value value = parse_json_without_places(line, name);
  if (!value.is_table()) throw InputError(name + ": not a trial's record: it is no table");
  const Value* schema = value.find("schema");
  if (schema && schema->is_integer() && schema->integer() > kRecordSchema)
    throw NewerSchemaError(
        fmt::format("{}: the record has schema {}, this build reads up to {}; use a newer nodal or "
                    "another directory",
                    name, schema->integer(), kRecordSchema));
  if (schema && schema->is_integer() && schema->integer() < 1)
    throw InputError(fmt::format("{}: not a trial's record: its schema is {}", name, schema->integer()));
  TrialRecord record;
  WorkAndUnit work;
  Reader reader(value, "", name);
  describe(reader, record, work);
  if (record.unseen && record.unseen->names.size() < (record.unseen->stop ? 2 : 1))
    throw InputError(fmt::format("{}: not a trial's record: 'unseen' names too few things", name));
  if (record.unseen)
    for (const UnseenPoint& point : record.unseen->points)
      if (point.errors.size() != record.unseen->names.size())
        throw InputError(fmt::format("{}: not a trial's record: a point of 'unseen' has {} errors for {} names", name,
                                     point.errors.size(), record.unseen->names.size()));
  record.reason = beginning(record.reason, kMostOfAReason);  // those of older builds are whole
  record.work = work.work;
  record.flops_per_value = work.flops_per_value;
  constexpr std::int64_t kMostAttempts = 1'000'000'000;  // the next one is counted on
  if (record.attempt < 1 || record.attempt > kMostAttempts)
    throw InputError(fmt::format("{}: not a trial's record: 'attempt' is {}", name, record.attempt));
  return record;
}

}  // namespace nodal
