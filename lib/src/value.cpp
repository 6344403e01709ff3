// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/value.h>

#include <algorithm>
#include <stdexcept>

namespace nodal {

namespace {

constexpr std::string_view kNames[] = {"a boolean", "an integer", "a number", "a text", "a list", "a table"};

template <class T, class Data>
auto& held(Data& data, std::string_view wanted) {
  if (auto* value = std::get_if<T>(&data)) return *value;
  throw std::logic_error("a value was read as " + std::string(wanted) + ", but is " +
                         std::string(kNames[data.index()]));
}

}  // namespace

std::string_view Value::type_name() const noexcept { return kNames[data_.index()]; }

bool Value::boolean() const { return held<bool>(data_, "a boolean"); }
std::int64_t Value::integer() const { return held<std::int64_t>(data_, "an integer"); }
double Value::number() const {
  if (is_integer()) return static_cast<double>(integer());
  return held<double>(data_, "a number");
}
const std::string& Value::text() const { return held<std::string>(data_, "a text"); }
const Value::List& Value::list() const { return held<List>(data_, "a list"); }
const Value::Table& Value::table() const { return held<Table>(data_, "a table"); }
Value::List& Value::list() { return held<List>(data_, "a list"); }
Value::Table& Value::table() { return held<Table>(data_, "a table"); }

std::vector<double> Value::numbers() const {
  std::vector<double> numbers;
  for (const Value& item : list()) numbers.push_back(item.number());
  return numbers;
}

const Value* Value::find(std::string_view key) const {
  const Table& entries = table();
  const auto found = std::ranges::find(entries, key, &Table::value_type::first);
  return found == entries.end() ? nullptr : &found->second;
}

const Value& Value::at(std::string_view key) const {
  if (const Value* value = find(key)) return *value;
  throw std::logic_error("a table has no entry '" + std::string(key) + "'");
}

std::string Value::text_or(std::string_view key, std::string_view otherwise) const {
  const Value* value = find(key);
  return value && value->is_text() ? value->text() : std::string(otherwise);
}

double Value::number_or(std::string_view key, double otherwise) const {
  const Value* value = find(key);
  return value && value->is_number() ? value->number() : otherwise;
}

bool Value::flag_or(std::string_view key, bool otherwise) const {
  const Value* value = find(key);
  return value && value->is_boolean() ? value->boolean() : otherwise;
}

void Value::set(std::string_view key, Value value) {
  Table& entries = table();
  const auto found = std::ranges::find(entries, key, &Table::value_type::first);
  if (found == entries.end()) {
    entries.emplace_back(std::string(key), std::move(value));
  } else {
    found->second = std::move(value);
  }
}

bool operator==(const Value& a, const Value& b) {
  if (a.is_number() && b.is_number()) {
    return a.is_integer() && b.is_integer() ? a.integer() == b.integer() : a.number() == b.number();
  }
  if (a.is_table() && b.is_table()) {
    const Value::Table &left = a.table(), &right = b.table();
    if (left.size() != right.size()) return false;
    for (std::size_t i = 0; i < left.size(); ++i) {
      // Mostly both have their keys in one order.
      const Value* other = left[i].first == right[i].first ? &right[i].second : b.find(left[i].first);
      if (!other || left[i].second != *other) return false;
    }
    return true;
  }
  return a.data_ == b.data_;
}

}  // namespace nodal
