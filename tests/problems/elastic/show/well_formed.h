// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Checks XML as far as pictures use it: one root, elements that close in order, attributes that are quoted and stand
/// once, entities that exist, no character that XML can't hold. Not a validator.

#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace nodal::elastic::show::fixture {

class WellFormed {
 public:
  explicit WellFormed(std::string_view text) : rest_(text) {
    if (rest_.starts_with("<?xml ")) skip_past("?>");
    while (error_.empty() && !rest_.empty()) rest_.front() == '<' ? tag() : characters();
    if (error_.empty() && (!open_.empty() || roots_ != 1)) fail("not one closed root");
  }
  /// Empty when the text is well-formed.
  [[nodiscard]] const std::string& error() const noexcept { return error_; }

 private:
  void fail(const std::string& what) {
    if (error_.empty()) error_ = what + " before: " + std::string(rest_.substr(0, 60));
  }
  void skip_past(std::string_view end) {
    const std::size_t at = rest_.find(end);
    if (at == std::string_view::npos) return fail("missing " + std::string(end));
    rest_.remove_prefix(at + end.size());
  }
  std::string name() {
    std::size_t n = 0;
    while (n < rest_.size() && (std::isalnum(static_cast<unsigned char>(rest_[n])) != 0 || rest_[n] == '-')) ++n;
    if (n == 0) fail("no name");
    std::string word(rest_.substr(0, n));
    rest_.remove_prefix(n);
    return word;
  }
  void spaces() {
    while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_.front())) != 0) rest_.remove_prefix(1);
  }
  bool take(std::string_view part) {
    if (!rest_.starts_with(part)) return false;
    rest_.remove_prefix(part.size());
    return true;
  }
  void check_text(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      const auto c = static_cast<unsigned char>(text[i]);
      if (c < 0x20 && c != '\n' && c != '\t' && c != '\r') fail("a control character");
      if (text[i] == '<') fail("a bare <");
      if (text[i] != '&') continue;
      bool known = false;
      for (const char* entity : {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"})
        known = known || text.substr(i).starts_with(entity);
      if (!known) fail("an unknown entity");
    }
  }
  void characters() {
    const std::string_view text = rest_.substr(0, rest_.find('<'));
    check_text(text);
    rest_.remove_prefix(text.size());
    if (open_.empty() && text.find_first_not_of(" \n") != std::string_view::npos) fail("text outside the root");
  }
  void attributes() {
    std::set<std::string> seen;
    for (spaces(); error_.empty() && !rest_.empty() && rest_.front() != '>' && rest_.front() != '/'; spaces()) {
      if (!seen.insert(name()).second) fail("a doubled attribute");
      if (!take("=\"")) return fail("an attribute without a quoted value");
      check_text(rest_.substr(0, rest_.find('"')));
      skip_past("\"");
    }
  }
  void tag() {
    if (take("</")) {
      if (open_.empty() || name() != open_.back()) return fail("an element closed that isn't open");
      open_.pop_back();
      if (!take(">")) fail("no >");
      return;
    }
    rest_.remove_prefix(1);
    const std::string element = name();
    attributes();
    roots_ += open_.empty() ? 1 : 0;
    if (take("/>")) return;
    if (!take(">")) return fail("no >");
    open_.push_back(element);
  }

  std::string_view rest_;
  std::vector<std::string> open_;
  int roots_ = 0;
  std::string error_;
};

}  // namespace nodal::elastic::show::fixture
