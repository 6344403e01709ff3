// SPDX-License-Identifier: GPL-3.0-or-later
#include "ends.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/show/html.h>
#include <nodal/show/number_text.h>

namespace nodal::report {

namespace {

// A local method from sampled starts may end in hundreds.
constexpr std::size_t kMostShown = 12;
constexpr int kMinimumDigits = 7, kWidthDigits = 2;

TrialCounts count(const std::vector<const TrialRecord*>& trials) {
  TrialCounts counts;
  for (const TrialRecord* trial : trials) {
    const auto own = std::ranges::find(counts, trial->optimizer, &TrialCounts::value_type::first);
    if (own == counts.end())
      counts.emplace_back(trial->optimizer, 1);
    else
      ++own->second;
  }
  return counts;
}

std::size_t sum(const TrialCounts& counts) {
  std::size_t total = 0;
  for (const auto& [label, trials] : counts) total += trials;
  return total;
}

std::string list(const TrialCounts& counts) {
  std::vector<std::string> parts;
  for (const auto& [label, trials] : counts) parts.push_back(fmt::format("{} ({})", label, trials));
  return escape_html(fmt::format("{}", fmt::join(parts, ", ")));
}

std::string row(const std::string& where, const std::string& width, const TrialCounts& counts) {
  return fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n", where, sum(counts), width,
                     list(counts));
}

// Of those that the table has no room for.
TrialCounts joined(std::span<const EndsAtMinimum> minima) {
  TrialCounts all;
  for (const EndsAtMinimum& minimum : minima)
    for (const auto& [label, trials] : minimum.trials) {
      const auto own = std::ranges::find(all, label, &TrialCounts::value_type::first);
      if (own == all.end())
        all.emplace_back(label, trials);
      else
        own->second += trials;
    }
  return all;
}

}  // namespace

Ends ends_of(std::span<const TrialRecord* const> trials) {
  const Minima found = minima(trials);
  Ends ends;
  for (const Minimum& minimum : found.found)
    ends.minima.push_back({minimum.quality, minimum.width, count(minimum.trials)});
  ends.on_the_way = count(found.on_the_way);
  ends.unknown = found.unknown;
  return ends;
}

std::string ends_html(const Ends& ends, const std::string& quality_name) {
  if (ends.minima.empty() && ends.on_the_way.empty()) return {};
  std::string rows;
  const std::span<const EndsAtMinimum> all = ends.minima;
  for (const EndsAtMinimum& minimum : all.first(std::min(all.size(), kMostShown)))
    rows += row(fmt::format("{} = {}", escape_html(quality_name), figure_text(minimum.quality, kMinimumDigits)),
                figure_text(minimum.width, kWidthDigits), minimum.trials);
  if (all.size() > kMostShown)
    rows += row(fmt::format("{} worse minima", all.size() - kMostShown), "", joined(all.subspan(kMostShown)));
  if (!ends.on_the_way.empty()) rows += row("on the way", "", ends.on_the_way);
  std::string note = fmt::format(
      "Looked at by an evaluator that had no part in the race. At a minimum: the cost falls by less than {:g} of "
      "itself per unit of any coordinate that no bound holds; {} within {:g} of each other are one. Width: the largest "
      "difference in a coordinate between its trials, which the data leave open.",
      kArrived, escape_html(quality_name), kOneMinimum);
  if (ends.unknown > 0)
    note += fmt::format(" Of {} trial{} it can't be told.", ends.unknown, ends.unknown == 1 ? "" : "s");
  return "<details class=\"ends\"><summary>Where trials ended</summary>\n<div class=\"scroll\" tabindex=\"0\" "
         "role=\"region\" aria-label=\"Where trials ended\"><table class=\"plain\"><thead><tr><th "
         "scope=\"col\">minimum</th><th scope=\"col\">trials</th><th "
         "scope=\"col\">width</th><th scope=\"col\">whose</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n<p class=\"note\">" + note + "</p></details>\n";
}

}  // namespace nodal::report
