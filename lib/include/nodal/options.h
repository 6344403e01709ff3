// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Options as data. Every component declares what can be set on it; reading a study, `nodal list`, the config
/// reference and the effective options in a record all come from these declarations.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/value.h>

namespace nodal {

enum class OptionType {
  boolean,
  integer,
  number,
  text,
  number_list,
  integer_list,
  text_list,     ///< a text alone is a list of one
  vector_list,   ///< [[x, y], …]: lists of `entries` numbers each
  vector_lists,  ///< [[[x, y], …], …]
  table,
  table_list,  ///< tables with the same fields
};

[[nodiscard]] std::string_view to_string(OptionType type) noexcept;

/// One option of a component. Written with designated initializers, fields in this order.
struct Option {
  std::string name;  ///< kebab_or_snake key as it stands in the study
  OptionType type = OptionType::number;
  std::optional<Value> default_value = {};  ///< taken when the study says nothing
  std::string default_text = {};            ///< how a default is derived when it is no constant, e.g. "2 × parameters"
  bool required = false;                    ///< neither default nor "leave it out"
  std::string unit = {};                    ///< "" for dimensionless
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool minimum_excluded = false;                ///< the range is open at its lower end
  bool maximum_excluded = false;                ///< the range is open at its upper end
  std::size_t length = 0;                       ///< of a list of numbers; 0 is any
  std::size_t longest = 0;                      ///< where it may be longer than `length`: up to this
  std::array<std::size_t, 2> entries = {2, 2};  ///< the least and the most numbers of each vector of a list
  std::vector<std::string> choices = {};        ///< of a text, or of each of a list; empty is any text
  std::string help = {};                        ///< one line: what it means and why this default
  std::vector<Option> fields = {};              ///< of a table, or of each of a list
  bool or_table = false;                        ///< it may be a table with `fields` instead
};

using OptionSchema = std::vector<Option>;

/// The options of one component, complete: what the study said, defaults for the rest.
/// Getters throw std::logic_error for a key or type that the schema doesn't have.
class Options {
 public:
  Options() = default;
  explicit Options(Value table) : table_(std::move(table)) {}

  [[nodiscard]] bool has(std::string_view key) const { return table_.find(key) != nullptr; }
  /// It is there, and not by default.
  [[nodiscard]] bool given(std::string_view key) const { return has(key) && !table_.at(key).is_default; }
  [[nodiscard]] bool boolean(std::string_view key) const { return table_.at(key).boolean(); }
  [[nodiscard]] std::int64_t integer(std::string_view key) const { return table_.at(key).integer(); }
  [[nodiscard]] double number(std::string_view key) const { return table_.at(key).number(); }
  [[nodiscard]] const std::string& text(std::string_view key) const { return table_.at(key).text(); }
  [[nodiscard]] std::vector<double> numbers(std::string_view key) const { return table_.at(key).numbers(); }
  [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;
  [[nodiscard]] Options table(std::string_view key) const { return Options(table_.at(key)); }
  [[nodiscard]] std::vector<Options> tables(std::string_view key) const;
  [[nodiscard]] std::vector<std::vector<double>> vectors(std::string_view key) const;
  [[nodiscard]] std::vector<std::vector<std::vector<double>>> vector_lists(std::string_view key) const;
  [[nodiscard]] const Value& at(std::string_view key) const { return table_.at(key); }
  /// As one table, in the schema's order; sources are kept for messages.
  [[nodiscard]] const Value& values() const noexcept { return table_; }

 private:
  Value table_;
};

/// Checks a table against a schema and fills in defaults, nested tables too.
/// `owner` names the component in messages: "optimizer 'annealing'". InputError with file:line for an unknown key (the
/// nearest valid ones offered), a wrong type, a number that is not finite or out of range, a list of the wrong length,
/// a text that is none of the choices, a required key left out.
[[nodiscard]] Options resolve_options(const OptionSchema& schema, const Value& given, const std::string& owner);

/// "2" or "2 or 3": how many entries a list must have; "" when any.
[[nodiscard]] std::string length_text(const Option& option);

/// "0 < x ≤ 1" or "" when unbounded: a range as people write it.
[[nodiscard]] std::string range_text(const Option& option);

}  // namespace nodal
