// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/options.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <nodal/shown.h>

namespace nodal {

namespace {

std::string with_article(OptionType type) {
  switch (type) {
    case OptionType::boolean:
      return "a boolean (true or false)";
    case OptionType::integer:
      return "an integer";
    case OptionType::number:
      return "a number";
    case OptionType::text:
      return "a text";
    case OptionType::number_list:
      return "a list of numbers";
    case OptionType::integer_list:
      return "a list of integers";
    case OptionType::text_list:
      return "a text or a list of texts";
    case OptionType::vector_list:
      return "a list of vectors";
    case OptionType::vector_lists:
      return "a list of lists of vectors";
    case OptionType::table:
      return "a table";
    case OptionType::table_list:
      return "a list of tables";
  }
  return "a value";
}

// Checks one value against one option; messages name the option and whom it belongs to.
class Check {
 public:
  Check(const Option& option, const Value& value, const std::string& owner)
      : option_(option), value_(value), name_(fmt::format("'{}' of {}", option.name, owner)) {}

  Value resolved() const {
    if (value_.is_table() && (option_.type == OptionType::table || option_.or_table)) {
      Value table = resolve_options(option_.fields, value_, name_).values();
      table.is_default = value_.is_default;
      return table;
    }
    Value result = value_;
    switch (option_.type) {
      case OptionType::boolean:
        if (!value_.is_boolean()) wrong_type(option_.type);
        break;
      case OptionType::integer:
        result = integer();
        break;
      case OptionType::number:
        result = number();
        break;
      case OptionType::text:
        result = text();
        break;
      case OptionType::number_list:
      case OptionType::integer_list:
        result = list();
        break;
      case OptionType::text_list:
        result = texts();
        break;
      case OptionType::vector_list:
        result = vectors();
        break;
      case OptionType::vector_lists:
        result = vector_lists();
        break;
      case OptionType::table:
        wrong_type(option_.type);
      case OptionType::table_list:
        result = tables();
        break;
    }
    result.source = value_.source;
    result.is_default = value_.is_default;
    return result;
  }

 private:
  // An entry of a list: held to the range of its option.
  Check(std::string name, const Option& option, const Value& value)
      : option_(option), value_(value), name_(std::move(name)) {}

  [[noreturn]] void refuse(const std::string& what) const { throw InputError(value_.source, name_ + " " + what); }
  [[noreturn]] void wrong_type(OptionType wanted) const {
    refuse(fmt::format("must be {}{}, not {}", with_article(wanted), option_.or_table ? " or a table" : "",
                       value_.type_name()));
  }

  void check_range(double number) const {
    if (!std::isfinite(number)) refuse(fmt::format("must be finite, not {}", number));
    const bool low = option_.minimum_excluded ? number <= option_.minimum : number < option_.minimum;
    const bool high = option_.maximum_excluded ? number >= option_.maximum : number > option_.maximum;
    if (low || high) refuse(fmt::format("is {}; allowed: {}", number, range_text(option_)));
  }

  Value integer() const {
    if (!value_.is_integer()) wrong_type(OptionType::integer);
    check_range(value_.number());
    return value_;
  }

  // Kept as a double, so that 1 and 1.0 make the same trial.
  Value number() const {
    if (!value_.is_number()) wrong_type(OptionType::number);
    check_range(value_.number());
    Value result(value_.number());
    result.source = value_.source;
    return result;
  }

  // Each entry checked by `check`, which is called on a Check of its own.
  template <class CheckEntry>
  Value list(CheckEntry check) const {
    if (!value_.is_list()) wrong_type(option_.type);
    const Value::List& given = value_.list();
    const std::size_t longest = std::max(option_.length, option_.longest);
    if (option_.length > 0 && (given.size() < option_.length || given.size() > longest))
      refuse(fmt::format("has {} entries; it must have {}", given.size(), length_text(option_)));
    Value::List items;
    for (std::size_t i = 0; i < given.size(); ++i)
      items.push_back(check(Check(fmt::format("entry {} of {}", i + 1, name_), option_, given[i])));
    Value result(std::move(items));
    result.source = value_.source;
    return result;
  }

  Value list() const {
    return list([this](const Check& entry) {
      return option_.type == OptionType::integer_list ? entry.integer() : entry.number();
    });
  }

  // Kept as a list, so that "a" and ["a"] make the same trial.
  Value texts() const {
    if (!value_.is_text()) return list([](const Check& entry) { return entry.text(); });
    Value one(Value::List{text()});
    one.source = value_.source;
    return one;
  }

  // "2 numbers", "2 to 3 numbers".
  std::string entries_text() const {
    const auto [least, most] = option_.entries;
    return least == most ? fmt::format("{} numbers", least) : fmt::format("{} to {} numbers", least, most);
  }

  Value vector() const {
    const auto [least, most] = option_.entries;
    if (!value_.is_list() || value_.list().size() < least || value_.list().size() > most)
      refuse("must be a list of " + entries_text());
    return list([](const Check& entry) { return entry.number(); });
  }

  Value vectors() const {
    if (!value_.is_list()) refuse("must be a list of vectors of " + entries_text());
    return list([](const Check& entry) { return entry.vector(); });
  }

  Value vector_lists() const {
    return list([](const Check& entry) { return entry.vectors(); });
  }

  Value tables() const {
    return list(
        [](const Check& entry) { return resolve_options(entry.option_.fields, entry.value_, entry.name_).values(); });
  }

  Value text() const {
    if (!value_.is_text()) wrong_type(OptionType::text);
    if (option_.choices.empty() || std::ranges::find(option_.choices, value_.text()) != option_.choices.end())
      return value_;
    refuse(fmt::format("is '{}'{}", shown(value_.text()), name_hint(value_.text(), option_.choices)));
  }

  const Option& option_;
  const Value& value_;
  std::string name_;
};

std::vector<std::vector<double>> vectors_of(const Value& list) {
  std::vector<std::vector<double>> vectors;
  for (const Value& vector : list.list()) vectors.push_back(vector.numbers());
  return vectors;
}

void refuse_unknown_keys(const OptionSchema& schema, const Value& given, const std::string& owner) {
  std::vector<std::string> known;
  for (const Option& option : schema) known.push_back(option.name);
  for (const auto& [key, value] : given.table())
    if (std::ranges::find(known, key) == known.end())
      throw InputError(value.source, fmt::format("unknown key '{}' in {}{}", shown(key), owner,
                                                 known.empty() ? "; it has no options" : name_hint(key, known)));
}

}  // namespace

std::string_view to_string(OptionType type) noexcept {
  switch (type) {
    case OptionType::boolean:
      return "boolean";
    case OptionType::integer:
      return "integer";
    case OptionType::number:
      return "number";
    case OptionType::text:
      return "text";
    case OptionType::number_list:
      return "list of numbers";
    case OptionType::integer_list:
      return "list of integers";
    case OptionType::text_list:
      return "text or list of texts";
    case OptionType::vector_list:
      return "list of vectors";
    case OptionType::vector_lists:
      return "list of lists of vectors";
    case OptionType::table:
      return "table";
    case OptionType::table_list:
      return "list of tables";
  }
  return "value";
}

std::string length_text(const Option& option) {
  if (option.length == 0) return {};
  return option.longest > option.length ? fmt::format("{} or {}", option.length, option.longest)
                                        : fmt::format("{}", option.length);
}

std::string range_text(const Option& option) {
  const bool below = std::isfinite(option.minimum), above = std::isfinite(option.maximum);
  const char* least = option.minimum_excluded ? "<" : "≤";
  const char* most = option.maximum_excluded ? "<" : "≤";
  if (below && above) return fmt::format("{} {} {} {} {}", option.minimum, least, option.name, most, option.maximum);
  if (below) return fmt::format("{} {} {}", option.name, option.minimum_excluded ? ">" : "≥", option.minimum);
  if (above) return fmt::format("{} {} {}", option.name, most, option.maximum);
  return {};
}

std::vector<std::string> Options::texts(std::string_view key) const {
  std::vector<std::string> texts;
  for (const Value& entry : at(key).list()) texts.push_back(entry.text());
  return texts;
}

std::vector<Options> Options::tables(std::string_view key) const {
  std::vector<Options> tables;
  for (const Value& table : at(key).list()) tables.emplace_back(table);
  return tables;
}

std::vector<std::vector<double>> Options::vectors(std::string_view key) const { return vectors_of(at(key)); }

std::vector<std::vector<std::vector<double>>> Options::vector_lists(std::string_view key) const {
  std::vector<std::vector<std::vector<double>>> lists;
  for (const Value& list : at(key).list()) lists.push_back(vectors_of(list));
  return lists;
}

Options resolve_options(const OptionSchema& schema, const Value& given, const std::string& owner) {
  if (!given.is_table())
    throw InputError(given.source, fmt::format("{} must be a table, not {}", owner, given.type_name()));
  refuse_unknown_keys(schema, given, owner);
  Value resolved;
  resolved.source = given.source;
  for (const Option& option : schema) {
    const Value* value = given.find(option.name);
    if (!value && option.required)
      throw InputError(given.source, fmt::format("{} lacks '{}'{}", owner, option.name,
                                                 option.help.empty() ? "" : ": " + option.help));
    if (!value && !option.default_value) continue;
    Value default_value;
    if (!value) {
      // A default has no place of its own in the file: what goes wrong with it is blamed on its table.
      default_value = *option.default_value;
      default_value.source = given.source;
      default_value.is_default = true;
      value = &default_value;
    }
    resolved.set(option.name, Check(option, *value, owner).resolved());
  }
  return Options(std::move(resolved));
}

}  // namespace nodal
