// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/value.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <unordered_set>

#include <nlohmann/json.hpp>

#include <nodal/shown.h>

#include "json_without_places.h"

namespace nodal {

namespace {

// ── reading
// ────────────────────────────────────────────────────────────────────────────────────────────────────────────

// Knows the line of each character that the parser has consumed.
class LineCounter {
 public:
  explicit LineCounter(std::string_view text) : text_(text) {}
  int line_at(std::size_t position) {
    position = std::min(position, text_.size());
    for (; counted_ < position; ++counted_) line_ += text_[counted_] == '\n';
    return line_;
  }

 private:
  std::string_view text_;
  std::size_t counted_ = 0;
  int line_ = 1;
};

// An input iterator that tells how far it has come, so that values get the line they stand on.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::size_t* position) : at_(at), position_(position) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    ++*position_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator old = *this;
    ++*this;
    return old;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  std::size_t* position_;
};

// Builds a Value from nlohmann's events; it, unlike the document model, sees doubled keys and positions.
class ValueBuilder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  ValueBuilder(std::string_view text, const std::string& name, const std::size_t& position, JsonNull null, bool places)
      : name_(name), position_(position), lines_(text), null_(null), places_(places) {}

  bool null() override {
    if (null_ == JsonNull::left_out && !open_.empty() && open_.back().is_table()) return true;
    if (open_.empty()) refuse("null is not a value here");
    refuse(open_.back().is_table() ? "null is not a value here; leave the key out instead"
                                   : "null is not a value in a list; leave it out or give one");
  }
  bool boolean(bool value) override { return add(Value(value)); }
  bool number_integer(number_integer_t value) override { return add(Value(static_cast<std::int64_t>(value))); }
  bool number_unsigned(number_unsigned_t value) override {
    if (value > static_cast<number_unsigned_t>(std::numeric_limits<std::int64_t>::max()))
      return add(Value(static_cast<double>(value)));
    return add(Value(static_cast<std::int64_t>(value)));
  }
  bool number_float(number_float_t value, const string_t&) override { return add(Value(static_cast<double>(value))); }
  bool string(string_t& value) override { return add(Value(value)); }
  bool binary(binary_t&) override { refuse("binary data"); }
  bool start_object(std::size_t) override { return open(Value(Value::Table{})); }
  bool start_array(std::size_t) override { return open(Value(Value::List{})); }
  bool key(string_t& key) override {
    if (stands(key)) refuse("key '" + shown(key) + "' stands twice");
    keys_.back() = key;
    return true;
  }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t, const std::string& token, const nlohmann::detail::exception& error) override {
    constexpr int kNumberOverflow = 406;  // nlohmann reports 1e999 here, not as a number
    if (error.id == kNumberOverflow) refuse("number '" + shown(token) + "' is too large");
    // nlohmann's text is "[json.exception…] parse error at line…: what"; only the last part says something new.
    const std::string text = error.what();
    const std::size_t colon = text.find(": ");
    refuse("not valid JSON: " + shown(colon == std::string::npos ? text : text.substr(colon + 2), kMostOfParseError));
  }

  Value result() && { return std::move(root_); }

 private:
  static constexpr std::size_t kDeepest = 200;            // brackets; more is an attack on the stack, not data
  static constexpr std::size_t kMostValues = 20'000'000;  // of some hundred bytes each
  static constexpr std::size_t kMostOfParseError = 240;
  static constexpr std::size_t kFewKeys = 16;  // so many are compared one by one

  [[noreturn]] void refuse(const std::string& message) { throw InputError(here(), message); }
  Source here() { return {name_, lines_.line_at(position_ > 0 ? position_ - 1 : 0)}; }

  // Whether the open table has the key already.
  bool stands(const std::string& key) {
    const Value::Table& entries = open_.back().table();
    if (entries.size() < kFewKeys) return open_.back().find(key) != nullptr;
    std::unordered_set<std::string>& known = known_.back();
    if (known.empty())
      for (const auto& entry : entries) known.insert(entry.first);
    return !known.insert(key).second;
  }

  bool add(Value value) {
    if (++values_ > kMostValues) refuse("more than 20 million values; this is more than can be held");
    if (places_ && value.source.file.empty()) value.source = here();
    if (open_.empty()) {
      root_ = std::move(value);
    } else if (open_.back().is_list()) {
      open_.back().list().push_back(std::move(value));
    } else {
      open_.back().table().emplace_back(keys_.back(), std::move(value));
    }
    return true;
  }
  bool open(Value value) {
    if (open_.size() >= kDeepest) refuse("more than 200 nested brackets");
    if (places_) value.source = here();
    open_.push_back(std::move(value));
    keys_.emplace_back();
    known_.emplace_back();
    return true;
  }
  bool close() {
    Value value = std::move(open_.back());
    open_.pop_back();
    keys_.pop_back();
    known_.pop_back();
    return add(std::move(value));
  }

  const std::string& name_;
  const std::size_t& position_;
  LineCounter lines_;
  JsonNull null_;
  bool places_;
  Value root_;
  std::vector<Value> open_;
  std::vector<std::string> keys_;
  std::vector<std::unordered_set<std::string>> known_;  // the keys of large open tables
  std::size_t values_ = 0;
};

// ── writing
// ────────────────────────────────────────────────────────────────────────────────────────────────────────────

void write_ascii(char c, std::string& out) {
  switch (c) {
    case '"':
      out += "\\\"";
      break;
    case '\\':
      out += "\\\\";
      break;
    case '\n':
      out += "\\n";
      break;
    case '\r':
      out += "\\r";
      break;
    case '\t':
      out += "\\t";
      break;
    default:
      if (c < 0x20) {
        constexpr char kDigits[] = "0123456789abcdef";
        out += "\\u00";
        out += kDigits[c >> 4];
        out += kDigits[c & 15];
      } else {
        out += c;
      }
  }
}

// Bytes that are no UTF-8 (a library's message, a file's name) become U+FFFD: a record must stay readable.
void write_text(std::string_view text, std::string& out) {
  out += '"';
  while (!text.empty()) {
    const std::size_t size = utf8_character_size(text);
    if (size == 0) {
      out += "\uFFFD";
    } else if (size == 1) {
      write_ascii(text[0], out);
    } else {
      out += text.substr(0, size);
    }
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  out += '"';
}

void write_number(double number, std::string& out) {
  if (!std::isfinite(number)) throw std::logic_error("NaN and infinity can't be written as JSON");
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
  const std::string_view digits(buffer, static_cast<std::size_t>(end - buffer));
  out += digits;
  if (digits.find_first_of(".e") == std::string_view::npos) out += ".0";  // stays a number of its own type
}

void write(const Value& value, bool canonical, std::string& out) {
  if (value.is_boolean()) {
    out += value.boolean() ? "true" : "false";
  } else if (value.is_integer()) {
    out += std::to_string(value.integer());
  } else if (value.is_number()) {
    write_number(value.number(), out);
  } else if (value.is_text()) {
    write_text(value.text(), out);
  } else if (value.is_list()) {
    out += '[';
    for (std::size_t i = 0; i < value.list().size(); ++i) {
      if (i > 0) out += ',';
      write(value.list()[i], canonical, out);
    }
    out += ']';
  } else {
    std::vector<const Value::Table::value_type*> entries;
    for (const auto& entry : value.table()) entries.push_back(&entry);
    if (canonical) std::ranges::sort(entries, {}, [](const auto* entry) -> const std::string& { return entry->first; });
    out += '{';
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (i > 0) out += ',';
      write_text(entries[i]->first, out);
      out += ':';
      write(entries[i]->second, canonical, out);
    }
    out += '}';
  }
}

Value parse(std::string_view text, const std::string& name, JsonNull null, bool places) {
  std::size_t position = 0;
  ValueBuilder builder(text, name, position, null, places);
  const CountingIterator begin(text.data(), &position), end(text.data() + text.size(), &position);
  nlohmann::json::sax_parse(begin, end, &builder);
  return std::move(builder).result();
}

}  // namespace

Value parse_json(std::string_view text, const std::string& name, JsonNull null) {
  return parse(text, name, null, true);
}

Value parse_json_without_places(std::string_view text, const std::string& name) {
  return parse(text, name, JsonNull::refused, false);
}

std::string to_json(const Value& value) {
  std::string out;
  write(value, false, out);
  return out;
}

std::string to_canonical_json(const Value& value) {
  std::string out;
  write(value, true, out);
  return out;
}

}  // namespace nodal
