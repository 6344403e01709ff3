// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/instances.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>
#include <nodal/shown.h>

namespace nodal {

namespace {

constexpr std::array<std::string_view, 6> kOfOne = {"label", "use", "kind", "best_known", "baseline", "multi_start"};

// A place in an entry: keys of tables, indices of lists.
struct Step {
  std::string key;
  std::size_t index = 0;
};

struct Range {
  std::vector<Step> path;
  std::vector<Value> values;
};

bool is_range(const Value& value) { return value.is_table() && (value.find("grid") || value.find("count")); }

void refuse_others(const Value& range, std::initializer_list<std::string_view> known) {
  for (const auto& [key, value] : range.table())
    if (std::ranges::find(known, key) == known.end())
      throw InputError(value.source, fmt::format("'{}' stands beside a range; a range has {} only", shown(key),
                                                 fmt::join(known, ", ")));
}

std::int64_t whole_number(const Value& range, std::string_view key, std::int64_t otherwise, std::int64_t least) {
  const Value* value = range.find(key);
  if (!value) return otherwise;
  constexpr std::int64_t kMost = std::int64_t{1} << 53;
  if (!value->is_integer() || value->integer() < least || value->integer() > kMost)
    throw InputError(value->source,
                     fmt::format("'{}' of a range must be a whole number from {} to {}", key, least, kMost));
  return value->integer();
}

std::vector<Value> values_of(const Value& range) {
  if (const Value* grid = range.find("grid")) {
    refuse_others(range, {"grid"});
    if (!grid->is_list() || grid->list().empty())
      throw InputError(grid->source, "'grid' must list the values, as grid = [0.2, 0.3, 0.45]");
    return grid->list();
  }
  refuse_others(range, {"count", "from"});
  const std::int64_t count = whole_number(range, "count", 0, 1), from = whole_number(range, "from", 1, 0);
  if (count > static_cast<std::int64_t>(kMostInstances))
    throw InputError(range.source, fmt::format("a range of {} is too long; at most {}", count, kMostInstances));
  std::vector<Value> values;
  for (std::int64_t k = 0; k < count; ++k) {
    values.emplace_back(from + k);
    values.back().source = range.source;
  }
  return values;
}

void find_ranges(const Value& value, std::vector<Step>& path, std::vector<Range>& found) {
  if (!path.empty() && is_range(value)) {
    if (path.size() == 1 && std::ranges::find(kOfOne, path[0].key) != kOfOne.end())
      throw InputError(value.source, fmt::format("'{}' can't be a range", path[0].key));
    if (path[0].key == "best_known")
      throw InputError(value.source, "'best_known' is of one problem; of several, give each a [[problem]] of its own");
    found.push_back({path, values_of(value)});
    return;
  }
  if (value.is_table())
    for (const auto& [key, inner] : value.table()) {
      path.push_back({key});
      find_ranges(inner, path, found);
      path.pop_back();
    }
  if (value.is_list())
    for (std::size_t i = 0; i < value.list().size(); ++i) {
      path.push_back({"", i});
      find_ranges(value.list()[i], path, found);
      path.pop_back();
    }
}

Value& at(Value& entry, const std::vector<Step>& path) {
  Value* place = &entry;
  for (const Step& step : path)
    place = place->is_list() ? &place->list()[step.index]
                             : &std::ranges::find(place->table(), step.key, &Value::Table::value_type::first)->second;
  return *place;
}

// The last key, or all of them where two ranges would be called alike.
std::vector<std::string> names_of(const std::vector<Range>& ranges) {
  const auto last = [](const Range& range) {
    return std::ranges::find_if(range.path.rbegin(), range.path.rend(), [](const Step& s) { return !s.key.empty(); })
        ->key;
  };
  const auto whole = [](const Range& range) {
    std::string name;
    for (const Step& step : range.path)
      name += step.key.empty() ? fmt::format("[{}]", step.index) : (name.empty() ? "" : ".") + step.key;
    return name;
  };
  std::vector<std::string> names;
  for (const Range& range : ranges) {
    const auto alike = std::ranges::count_if(ranges, [&](const Range& other) { return last(other) == last(range); });
    names.push_back(alike > 1 ? whole(range) : last(range));
  }
  return names;
}

// Values that are no short word are counted.
std::string text_of(const Range& range, std::size_t k) {
  constexpr std::size_t kLongWord = 24;
  const Value& value = range.values[k];
  if (value.is_text() && value.text().size() <= kLongWord) return value.text();
  return value.is_text() || value.is_table() || value.is_list() ? fmt::format("#{}", k + 1) : to_json(value);
}

}  // namespace

std::vector<Value> instances(const Value& entry, const std::string& name) {
  std::vector<Range> ranges;
  std::vector<Step> path;
  find_ranges(entry, path, ranges);
  if (ranges.empty()) return {entry};
  if (const Value* known = entry.find("best_known"))
    throw InputError(known->source,
                     "'best_known' is of one problem, and the ranges beside it make several; leave it out, "
                     "or give each a [[problem]] of its own");
  std::size_t count = 1;
  for (const Range& range : ranges) {
    count *= range.values.size();
    if (count > kMostInstances)
      throw InputError(entry.source,
                       fmt::format("the ranges of '{}' have more than {} combinations", shown(name), kMostInstances));
  }
  const std::vector<std::string> names = names_of(ranges);
  std::vector<Value> made;
  for (std::size_t i = 0; i < count; ++i) {
    Value one = entry;
    std::string label;
    std::size_t rest = i;
    for (std::size_t r = ranges.size(); r-- > 0; rest /= ranges[r].values.size()) {
      const std::size_t k = rest % ranges[r].values.size();
      at(one, ranges[r].path) = ranges[r].values[k];
      label.insert(0, fmt::format(" {}={}", names[r], text_of(ranges[r], k)));
    }
    Value text(entry.text_or("label", name) + label);
    text.source = entry.source;
    one.set("label", std::move(text));
    made.push_back(std::move(one));
  }
  return made;
}

}  // namespace nodal
