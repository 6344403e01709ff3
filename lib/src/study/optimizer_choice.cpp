// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/optimizer_choice.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/shown.h>

namespace nodal {

namespace {

std::vector<std::string> labels_of(const std::vector<StudyOptimizer>& optimizers) {
  std::vector<std::string> labels;
  for (const StudyOptimizer& optimizer : optimizers) labels.push_back(optimizer.label);
  return labels;
}

}  // namespace

std::vector<std::string> split_choice(const Study& study, const std::vector<std::string>& words) {
  std::vector<std::string> parts;
  for (const std::string& word : words) {
    if (std::ranges::find(study.optimizers, word, &StudyOptimizer::label) != study.optimizers.end()) {
      parts.push_back(word);
      continue;
    }
    if (word.empty()) parts.emplace_back();  // an empty variable of a script: refused as no label, not taken for none
    std::istringstream rest(word);
    for (std::string part; std::getline(rest, part, ',');) parts.push_back(part);
  }
  return parts;
}

std::size_t chosen_optimizer(const Study& study, const std::string& word, const std::string& option) {
  const std::vector<StudyOptimizer>& all = study.optimizers;
  const auto index = [&all](auto entry) { return static_cast<std::size_t>(entry - all.begin()); };
  if (const auto entry = std::ranges::find(all, word, &StudyOptimizer::label); entry != all.end()) return index(entry);
  std::vector<StudyOptimizer> same_use;
  std::ranges::copy_if(all, std::back_inserter(same_use), [&](const auto& entry) { return entry.use == word; });
  if (same_use.size() == 1) return index(std::ranges::find(all, word, &StudyOptimizer::use));
  if (same_use.size() > 1)
    throw InputError(Source{option, 0}, fmt::format("several entries of the study use '{}': '{}'; give their labels",
                                                    shown(word), fmt::join(labels_of(same_use), "', '")));
  const auto left_out = std::ranges::find_if(
      study.left_out, [&](const LeftOut& entry) { return entry.label == word || entry.use == word; });
  if (left_out != study.left_out.end())
    throw InputError(Source{option, 0},
                     fmt::format("optimizer '{}' is not in this build: {}", shown(word), left_out->reason));
  throw InputError(Source{option, 0}, fmt::format("no optimizer of the study is labelled '{}'{}", shown(word),
                                                  name_hint(word, labels_of(all))));
}

}  // namespace nodal
