// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Two archives of a record's tables: the Writer makes JSON of what a `describe` names, the Reader checks and fills it.

#include <algorithm>
#include <concepts>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <nodal/record.h>

namespace nodal {

// A finding stands among the entries of "health" under its own name, which is none of these.
inline constexpr std::string_view kHealthNames[] = {"error_estimate", "cost_error", "residual", "drift", "refused"};

// What no finding of a problem's own may be called: the unseen error is found by trials, whatever the problem.
inline bool is_reserved_finding(std::string_view name) {
  return name == kUnseenFinding || std::ranges::find(kHealthNames, name) != std::end(kHealthNames);
}

inline constexpr std::string_view kEndNames[] = {"budget", "target", "finished", "failed", "timeout", "crashed"};

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
  // Left out where it is what a record without it means.
  template <class T>
  void unusual(const char* key, const T& value, const T& usual) {
    if (value != usual) field(key, value);
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
  void findings(const std::vector<Finding>& findings) {
    for (const Finding& finding : findings) result.set(finding.name, finding.value);
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
  static Value pack(const std::vector<std::string>& texts) { return Value(Value::List(texts.begin(), texts.end())); }
  static Value pack(const std::vector<UnseenPoint>& points) {
    Value::List list;
    for (const UnseenPoint& p : points) {
      Value::List entry{Value(p.at.evaluation), Value(p.at.seconds), Value(p.at.factorizations), Value(p.at.quality)};
      entry.insert(entry.end(), p.errors.begin(), p.errors.end());
      list.emplace_back(std::move(entry));
    }
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
  void unusual(const char* key, T& value, const T& usual) {
    value = usual;
    if (const Value* found = table_.find(key)) unpack(key, *found, value);
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
  void findings(std::vector<Finding>& findings) {
    for (const auto& [name, value] : table_.table()) {
      if (std::ranges::find(kHealthNames, name) != std::end(kHealthNames)) continue;
      if (!value.is_number()) fail(name, "is not a number");
      findings.push_back({name, value.number()});
    }
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
      if (!std::in_range<T>(found.integer())) fail(key, "is out of its range");
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
  void unpack(const char* key, const Value& found, std::vector<std::string>& value) const {
    if (!found.is_list()) fail(key, "is not a list");
    for (const Value& item : found.list()) {
      if (!item.is_text()) fail(key, "holds something else than texts");
      value.push_back(item.text());
    }
  }
  // The first entries of a list.
  std::optional<TracePoint> trace_point(const Value& item) const {
    if (!item.is_list() || item.list().size() < 4) return std::nullopt;
    const Value::List& p = item.list();
    if (!p[0].is_integer() || !p[1].is_number() || !p[2].is_integer() || !p[3].is_number()) return std::nullopt;
    return TracePoint{p[0].integer(), p[1].number(), p[2].integer(), p[3].number()};
  }
  void unpack(const char* key, const Value& found, std::vector<TracePoint>& value) const {
    if (!found.is_list()) fail(key, "is not a list");
    for (const Value& item : found.list()) {
      const std::optional<TracePoint> point = trace_point(item);
      if (!point || item.list().size() != 4)
        fail(key, "holds something else than [evaluation, seconds, factorizations, quality]");
      value.push_back(*point);
    }
  }
  void unpack(const char* key, const Value& found, std::vector<UnseenPoint>& value) const {
    if (!found.is_list()) fail(key, "is not a list");
    for (const Value& item : found.list()) {
      const std::optional<TracePoint> point = trace_point(item);
      if (!point) fail(key, "holds something else than [evaluation, seconds, factorizations, quality, errors …]");
      UnseenPoint& read = value.emplace_back(UnseenPoint{*point, {}});
      for (std::size_t i = 4; i < item.list().size(); ++i) {
        if (!item.list()[i].is_number()) fail(key, "holds an error that is not a number");
        read.errors.push_back(item.list()[i].number());
      }
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

}  // namespace nodal
