// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/registry.h>

#include <algorithm>
#include <stdexcept>

#include "record_archive.h"

namespace nodal {

namespace {

template <class Descriptions, class Member>
auto find_by(const Descriptions& all, Member member, std::string_view name) -> const
    typename Descriptions::value_type* {
  const auto found = std::ranges::find(all, name, member);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

void Registry::add(OptimizerDescription description) {
  if (find_optimizer(description.name))
    throw std::logic_error("optimizer '" + description.name + "' is registered twice");
  optimizers_.push_back(std::move(description));
}

void Registry::add(ProblemDescription description) {
  if (find_problem(description.kind)) throw std::logic_error("problem '" + description.kind + "' is registered twice");
  for (const FindingDescription& finding : description.findings)
    if (is_reserved_finding(finding.name))
      throw std::logic_error("problem '" + description.kind + "' has a finding called '" + finding.name +
                             "': records have an entry of that name whatever the problem; call it otherwise");
  problems_.push_back(std::move(description));
}

void Registry::add(AbsentDescription description) { absent_.push_back(std::move(description)); }

const OptimizerDescription* Registry::find_optimizer(std::string_view name) const {
  return find_by(optimizers_, &OptimizerDescription::name, name);
}

const ProblemDescription* Registry::find_problem(std::string_view kind) const {
  return find_by(problems_, &ProblemDescription::kind, kind);
}

const AbsentDescription* Registry::find_absent(std::string_view name) const {
  const auto matches = [name](const AbsentDescription& absent) {
    const std::string_view pattern = absent.name;
    if (!pattern.empty() && pattern.back() == '*') return name.starts_with(pattern.substr(0, pattern.size() - 1));
    return name == pattern;
  };
  const auto found = std::ranges::find_if(absent_, matches);
  return found == absent_.end() ? nullptr : &*found;
}

}  // namespace nodal
