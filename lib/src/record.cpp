// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/record.h>

#include <cmath>
#include <concepts>

#include <fmt/format.h>

namespace nodal {

namespace {

constexpr std::string_view kEndNames[] = {"budget", "target", "finished", "failed", "timeout", "crashed"};

// One description of each table serves both directions: `describe(archive, table)` names every field once, the Writer
// archive makes JSON of it and the Reader archive checks and fills it.

class Writer {
 public:
  Value result;

  template <class T>
  void field(const char* key, const T& value) {
    result.set(key, pack(value));
  }
  template <class T>
  void field(const char* key, const std::optional<T>& value) {
    if (value) result.set(key, pack(*value));
  }
  template <class T>
  void table(const char* key, const T& value) {
    Writer part;
    describe(part, value);
    result.set(key, std::move(part.result));
  }
  template <class T>
  void optional_table(const char* key, const std::optional<T>& value) {
    if (value) table(key, *value);
  }

 private:
  template <class T>
  static Value pack(const T& value) {
    return Value(value);
  }
  static Value pack(End end) { return Value(to_string(end)); }
  static Value pack(const std::vector<double>& numbers) { return Value(Value::List(numbers.begin(), numbers.end())); }
  static Value pack(const std::vector<TracePoint>& trace) {
    Value::List list;
    list.reserve(trace.size());
    for (const TracePoint& p : trace)
      list.emplace_back(Value::List{Value(p.evaluation), Value(p.seconds), Value(p.factorizations), Value(p.quality)});
    return Value(std::move(list));
  }
  static Value pack(const std::vector<MovesChoice>& choices) {
    Value::List list;
    for (const MovesChoice& c : choices)
      list.emplace_back(Value::List{Value(c.proposal), Value(c.form), Value(c.reason)});
    return Value(std::move(list));
  }
};

class Reader {
 public:
  Reader(const Value& table, std::string path, const std::string& name)
      : table_(table), path_(std::move(path)), name_(name) {}

  template <class T>
  void field(const char* key, T& value) {
    const Value* found = table_.find(key);
    if (!found) fail(key, "is missing");
    unpack(key, *found, value);
  }
  template <class T>
  void field(const char* key, std::optional<T>& value) {
    if (const Value* found = table_.find(key)) unpack(key, *found, value.emplace());
  }
  template <class T>
  void table(const char* key, T& value) {
    const Value* found = table_.find(key);
    if (!found) fail(key, "is missing");
    if (!found->is_table()) fail(key, "is not a table");
    Reader part(*found, path_ + key + ".", name_);
    describe(part, value);
  }
  template <class T>
  void optional_table(const char* key, std::optional<T>& value) {
    if (table_.find(key)) table(key, value.emplace());
  }

 private:
  [[noreturn]] void fail(const std::string& key, const std::string& what) const {
    throw InputError(fmt::format("{}: not a trial's record: '{}{}' {}", name_, path_, key, what));
  }

  template <std::integral T>
  void unpack(const char* key, const Value& found, T& value) const {
    if constexpr (std::same_as<T, bool>) {
      if (!found.is_boolean()) fail(key, "is not a boolean");
      value = found.boolean();
    } else {
      if (!found.is_integer()) fail(key, "is not an integer");
      value = static_cast<T>(found.integer());
    }
  }
  void unpack(const char* key, const Value& found, double& value) const {
    if (!found.is_number()) fail(key, "is not a number");
    value = found.number();
  }
  void unpack(const char* key, const Value& found, std::string& value) const {
    if (!found.is_text()) fail(key, "is not a text");
    value = found.text();
  }
  void unpack(const char* key, const Value& found, Value& value) const {
    if (!found.is_table()) fail(key, "is not a table");
    value = found;
  }
  void unpack(const char* key, const Value& found, End& value) const {
    for (int i = 0; i <= static_cast<int>(End::crashed); ++i)
      if (found.is_text() && found.text() == kEndNames[i]) {
        value = static_cast<End>(i);
        return;
      }
    fail(key, "is not the name of an end");
  }
  void unpack(const char* key, const Value& found, std::vector<double>& value) const {
    if (!found.is_list()) fail(key, "is not a list");
    for (const Value& item : found.list())
      if (!item.is_number()) fail(key, "holds something else than numbers");
    value = found.numbers();
  }
  void unpack(const char* key, const Value& found, std::vector<TracePoint>& value) const {
    if (!found.is_list()) fail(key, "is not a list");
    for (const Value& item : found.list()) {
      const bool four = item.is_list() && item.list().size() == 4;
      if (!four || !item.list()[0].is_integer() || !item.list()[1].is_number() || !item.list()[2].is_integer() ||
          !item.list()[3].is_number())
        fail(key, "holds something else than [evaluation, seconds, factorizations, quality]");
      const Value::List& p = item.list();
      value.push_back({p[0].integer(), p[1].number(), p[2].integer(), p[3].number()});
    }
  }

  void unpack(const char* key, const Value& found, std::vector<MovesChoice>& value) const {
    if (!found.is_list()) fail(key, "is not a list");
    for (const Value& item : found.list()) {
      const bool three = item.is_list() && item.list().size() == 3;
      if (!three || !item.list()[0].is_integer() || !item.list()[1].is_text() || !item.list()[2].is_text())
        fail(key, "holds something else than [proposal, form, reason]");
      value.push_back({item.list()[0].integer(), item.list()[1].text(), item.list()[2].text()});
    }
  }

  const Value& table_;
  std::string path_;
  const std::string& name_;
};

// `T` is the table, const when it is written.

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, PointSummary>
void describe(Archive& archive, T& point) {
  archive.field("cost", point.cost);
  archive.field("quality", point.quality);
  archive.field("relative_error", point.relative_error);
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
  archive.field("spread", health.spread);
  archive.field("refused", health.refused);
}

template <class Archive, class T>
requires std::same_as<std::remove_const_t<T>, TrialRecord>
void describe(Archive& archive, T& record,
              std::conditional_t<std::is_const_v<T>, const WorkAndUnit, WorkAndUnit>& work) {
  archive.field("schema", record.schema);
  archive.field("key", record.key);
  archive.field("problem", record.problem);
  archive.field("optimizer", record.optimizer);
  archive.field("use", record.use);
  archive.field("repeat", record.repeat);
  archive.field("seed", record.seed);
  archive.field("end", record.end);
  archive.field("reason", record.reason);
  archive.field("options", record.options);
  archive.table("start", record.start);
  archive.optional_table("best", record.best);
  archive.table("counts", record.counts);
  archive.table("work", work);
  archive.table("seconds", record.seconds);
  archive.field("trace", record.trace);
  archive.optional_table("claimed", record.claimed);
  archive.optional_table("moves", record.moves);
  archive.table("health", record.health);
}

}  // namespace

std::string_view to_string(End end) noexcept { return kEndNames[static_cast<int>(end)]; }

std::string to_json_line(const TrialRecord& record) {
  const WorkAndUnit work{record.work, record.flops_per_value};
  Writer writer;
  describe(writer, record, work);
  return to_json(writer.result);
}

TrialRecord parse_record(std::string_view line, const std::string& name) {
  const Value value = parse_json(line, name);
  if (!value.is_table()) throw InputError(name + ": not a trial's record: it is no table");
  const Value* schema = value.find("schema");
  if (schema && schema->is_integer() && schema->integer() > kRecordSchema)
    throw NewerSchemaError(
        fmt::format("{}: the record has schema {}, this build reads up to {}; use a newer nodal or "
                    "another directory",
                    name, schema->integer(), kRecordSchema));
  TrialRecord record;
  WorkAndUnit work;
  Reader reader(value, "", name);
  describe(reader, record, work);
  record.work = work.work;
  record.flops_per_value = work.flops_per_value;
  return record;
}

}  // namespace nodal
