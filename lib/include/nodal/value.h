// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A value as studies, options and records hold it: boolean, integer, number, text, list or table, with where it was
/// said.
///
/// TOML is read into it, JSON is read into it and written from it, so no other part knows either format's library.
/// Tables keep the order in which their keys were written.
///
/// Errors   asking for another type than is held throws std::logic_error: validate with an OptionSchema first.
/// Threads  a plain value.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <nodal/error.h>

namespace nodal {

class Value {
 public:
  using List = std::vector<Value>;
  using Table = std::vector<std::pair<std::string, Value>>;

  Value() : data_(Table{}) {}
  Value(bool value) : data_(value) {}
  Value(int value) : data_(std::int64_t{value}) {}
  Value(std::int64_t value) : data_(value) {}
  Value(std::uint64_t value) : data_(static_cast<std::int64_t>(value)) {}
  Value(double value) : data_(value) {}
  Value(const char* value) : data_(std::string(value)) {}
  Value(std::string_view value) : data_(std::string(value)) {}
  Value(std::string value) : data_(std::move(value)) {}
  Value(List value) : data_(std::move(value)) {}
  Value(Table value) : data_(std::move(value)) {}

  [[nodiscard]] bool is_boolean() const noexcept { return std::holds_alternative<bool>(data_); }
  [[nodiscard]] bool is_integer() const noexcept { return std::holds_alternative<std::int64_t>(data_); }
  /// True for integers too: 1 is a number.
  [[nodiscard]] bool is_number() const noexcept { return is_integer() || std::holds_alternative<double>(data_); }
  [[nodiscard]] bool is_text() const noexcept { return std::holds_alternative<std::string>(data_); }
  [[nodiscard]] bool is_list() const noexcept { return std::holds_alternative<List>(data_); }
  [[nodiscard]] bool is_table() const noexcept { return std::holds_alternative<Table>(data_); }
  /// "a boolean", "an integer", "a number", "a text", "a list", "a table": for messages.
  [[nodiscard]] std::string_view type_name() const noexcept;

  [[nodiscard]] bool boolean() const;
  [[nodiscard]] std::int64_t integer() const;
  [[nodiscard]] double number() const;
  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] const List& list() const;
  [[nodiscard]] const Table& table() const;
  [[nodiscard]] List& list();
  [[nodiscard]] Table& table();
  /// A list of numbers as a plain vector.
  [[nodiscard]] std::vector<double> numbers() const;

  /// The entry of a table, or nullptr.
  [[nodiscard]] const Value* find(std::string_view key) const;
  /// The entry of a table; std::logic_error when it isn't there.
  [[nodiscard]] const Value& at(std::string_view key) const;
  /// The entry of a table where it is there and of that type; else what is given. For what others have written.
  [[nodiscard]] std::string text_or(std::string_view key, std::string_view otherwise) const;
  [[nodiscard]] double number_or(std::string_view key, double otherwise) const;
  [[nodiscard]] bool flag_or(std::string_view key, bool otherwise) const;
  /// Sets or replaces an entry of a table.
  void set(std::string_view key, Value value);

  Source source;            ///< where it was said; empty when made by a program
  bool is_default = false;  ///< nobody said it: an option's default (resolve_options)

  /// Equal in content; where it comes from doesn't count, and 1 equals 1.0.
  friend bool operator==(const Value& a, const Value& b);

 private:
  std::variant<bool, std::int64_t, double, std::string, List, Table> data_;
};

/// What becomes of a null. Our own files say "not there" by leaving the key out; other people's formats say it by null.
enum class JsonNull {
  refused,
  left_out  ///< as the value of a key: as if the key weren't there; elsewhere refused
};

/// Reads one JSON text. InputError (with `name` and the line) for anything malformed, a key that stands twice in one
/// table, or a null that isn't left out.
[[nodiscard]] Value parse_json(std::string_view text, const std::string& name, JsonNull null = JsonNull::refused);

/// Writes JSON on one line; numbers in the fewest digits that read back to the same double. Bytes of a text that are no
/// UTF-8 become U+FFFD.
/// std::logic_error for NaN and infinity: they never reach JSON.
[[nodiscard]] std::string to_json(const Value& value);

/// The same with every table's keys sorted: equal contents give equal texts. Hashes are taken of it.
[[nodiscard]] std::string to_canonical_json(const Value& value);

}  // namespace nodal
