// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include <nodal/show/html.h>

#include "page_parts.h"

namespace nodal::report {

namespace {

std::string value_text(const Value& value) {
  if (value.is_text()) return value.text();
  if (!value.is_table()) return to_json(value);
  std::string text;
  for (const auto& [key, entry] : value.table()) text += (text.empty() ? "" : ", ") + key + " " + value_text(entry);
  return text.empty() ? "–" : text;
}

std::string build_html(const Value& build) {
  std::string text = "<dl>\n";
  for (const auto& [key, entry] : build.table()) {
    std::string name = key;
    std::ranges::replace(name, '_', ' ');
    text += "<dt>" + escape_html(name) + "</dt><dd>" + escape_html(value_text(entry)) + "</dd>\n";
  }
  return text + "</dl>\n";
}

// One word for a shell, whatever is in it.
std::string shell_word(const std::string& text) {
  const std::string_view plain = "-_./=,";
  if (!text.empty() && std::ranges::all_of(text, [&](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               plain.find(c) != std::string_view::npos;
      }))
    return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string again_html(const RunAgain& again) {
  if (again.file.empty()) return {};
  std::string command = "nodal compare " + shell_word(again.file);
  for (const std::string& setting : again.settings) command += " --set " + shell_word(setting);
  return "<p>To run it again: save the study below as <code>" + escape_html(again.file) + "</code>" +
         (again.included.empty() ? "" : ", what it includes under the names given") +
         ", then</p>\n<pre class=\"command\">" + escape_html(command) + "</pre>\n";
}

std::string text_html(const std::string& summary, const std::string& text) {
  return "<details><summary>" + escape_html(summary) + "</summary>\n<pre tabindex=\"0\">" + escape_html(text) +
         "</pre></details>\n";
}

}  // namespace

std::string provenance_html(const ReportData& data) {
  std::string text = "<section id=\"provenance\"><h2>Where this comes from</h2>\n";
  for (const Value& build : data.builds) text += build_html(build);
  text += again_html(data.run_again);
  if (!data.study_text.empty()) text += text_html("The study, as it was read", data.study_text);
  for (const IncludedFile& file : data.run_again.included)
    text += text_html("It includes " + file.path.filename().string(), file.text);
  return text + "</section>\n";
}

}  // namespace nodal::report
