// SPDX-License-Identifier: GPL-3.0-or-later
#include "validate.h"

#include <algorithm>
#include <map>
#include <regex>
#include <stdexcept>

namespace nodal::editing {

namespace {

using Faults = std::vector<std::string>;

class Validator {
 public:
  explicit Validator(const Value& root) : root_(root) {}

  Faults check(const Value& schema, const Value& value, const std::string& place) const {
    Faults faults;
    for (const auto& [keyword, argument] : schema.table()) {
      const Faults found = check_keyword(keyword, argument, schema, value, place);
      faults.insert(faults.end(), found.begin(), found.end());
    }
    return faults;
  }

 private:
  static Faults fault_unless(bool holds, const std::string& place, const std::string& what) {
    return holds ? Faults{} : Faults{place + ": " + what};
  }

  Faults check_keyword(const std::string& keyword, const Value& argument, const Value& schema, const Value& value,
                       const std::string& place) const {
    static const std::vector<std::string> said = {"$schema", "title", "description", "default", "definitions"};
    if (std::ranges::find(said, keyword) != said.end()) return {};
    if (keyword == "$ref") return check(target_of(argument.text()), value, place);
    if (keyword == "anyOf") return any_of(argument, value, place);
    if (keyword == "if") return branch(schema, check(argument, value, place).empty() ? "then" : "else", value, place);
    if (keyword == "then" || keyword == "else") return {};  // by "if"
    if (keyword == "not") return fault_unless(!check(argument, value, place).empty(), place, "is what it must not be");
    if (keyword == "type") return fault_unless(has_type(argument.text(), value), place, "is no " + argument.text());
    if (keyword == "const") return fault_unless(value == argument, place, "is not " + to_json(argument));
    if (keyword == "enum")
      return fault_unless(std::ranges::find(argument.list(), value) != argument.list().end(), place, "is no choice");
    if (keyword == "pattern")
      return fault_unless(!value.is_text() || std::regex_search(value.text(), std::regex(argument.text())), place,
                          "is not like " + argument.text());
    if (keyword.find("inimum") != std::string::npos || keyword.find("aximum") != std::string::npos)
      return check_number(keyword, argument.number(), value, place);
    if (keyword == "items" || keyword == "minItems" || keyword == "maxItems")
      return check_list(keyword, argument, value, place);
    return check_table(keyword, argument, schema, value, place);
  }

  const Value& target_of(const std::string& reference) const {
    const std::string begin = "#/definitions/";
    if (!reference.starts_with(begin)) throw std::logic_error("a reference to elsewhere: " + reference);
    if (reference.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-#/") !=
        std::string::npos)
      throw std::logic_error("a reference that is no URI: " + reference);
    return root_.at("definitions").at(reference.substr(begin.size()));
  }

  Faults branch(const Value& schema, const char* keyword, const Value& value, const std::string& place) const {
    const Value* taken = schema.find(keyword);
    return taken ? check(*taken, value, place) : Faults{};
  }

  Faults any_of(const Value& schemas, const Value& value, const std::string& place) const {
    std::string why;
    for (const Value& one : schemas.list()) {
      const Faults faults = check(one, value, place);
      if (faults.empty()) return {};
      why += "\n  " + faults.front();
    }
    return {place + ": is nothing of" + why};
  }

  static bool has_type(const std::string& type, const Value& value) {
    if (type == "object") return value.is_table();
    if (type == "array") return value.is_list();
    if (type == "string") return value.is_text();
    if (type == "boolean") return value.is_boolean();
    if (type == "integer") return value.is_integer();
    if (type == "number") return value.is_number();
    throw std::logic_error("an unknown type: " + type);
  }

  static Faults check_number(const std::string& keyword, double limit, const Value& value, const std::string& place) {
    if (!value.is_number()) return {};
    const double number = value.number();
    if (keyword == "minimum") return fault_unless(number >= limit, place, "is too small");
    if (keyword == "maximum") return fault_unless(number <= limit, place, "is too large");
    if (keyword == "exclusiveMinimum") return fault_unless(number > limit, place, "is too small");
    if (keyword == "exclusiveMaximum") return fault_unless(number < limit, place, "is too large");
    throw std::logic_error("an unknown keyword: " + keyword);
  }

  Faults check_list(const std::string& keyword, const Value& argument, const Value& value,
                    const std::string& place) const {
    if (!value.is_list()) return {};
    const std::size_t size = value.list().size();
    if (keyword == "minItems")
      return fault_unless(size >= static_cast<std::size_t>(argument.integer()), place, "is too short");
    if (keyword == "maxItems")
      return fault_unless(size <= static_cast<std::size_t>(argument.integer()), place, "is too long");
    Faults faults;
    for (std::size_t i = 0; i < size; ++i)
      for (const std::string& fault : check(argument, value.list()[i], place + "/" + std::to_string(i)))
        faults.push_back(fault);
    return faults;
  }

  Faults check_table(const std::string& keyword, const Value& argument, const Value& schema, const Value& value,
                     const std::string& place) const {
    if (keyword != "properties" && keyword != "required" && keyword != "additionalProperties")
      throw std::logic_error("an unknown keyword: " + keyword);
    Faults faults;
    if (!value.is_table()) return faults;
    if (keyword == "required") {
      for (const Value& key : argument.list())
        if (!value.find(key.text())) faults.push_back(place + ": lacks " + key.text());
    } else if (keyword == "properties") {
      for (const auto& [key, entry] : value.table())
        if (const Value* own = argument.find(key))
          for (const std::string& fault : check(*own, entry, place + "/" + key)) faults.push_back(fault);
    } else {
      if (argument.boolean()) throw std::logic_error("additionalProperties is false where it stands");
      for (const auto& [key, entry] : value.table())
        if (!schema.at("properties").find(key)) faults.push_back(place + ": unknown key " + key);
    }
    return faults;
  }

  const Value& root_;
};

}  // namespace

std::vector<std::string> validate(const Value& schema, const Value& value) {
  return Validator(schema).check(schema, value, "");
}

}  // namespace nodal::editing
