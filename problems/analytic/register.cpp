// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/registry.h>

#include "analytic_problem.h"

namespace nodal {

namespace {

void register_function(Registry& registry, const analytic::Function& function) {
  registry.add(ProblemDescription{
      .kind = function.kind,
      .summary = function.summary,
      .reference = function.reference,
      .options = analytic::function_schema(function),
      .make = [&function](const Options& options, const ProblemContext&) -> std::shared_ptr<const Problem> {
        return std::make_shared<analytic::AnalyticProblem>(function, options);
      }});
}

}  // namespace

void register_analytic(Registry& registry) {
  for (const analytic::Function& function : analytic::least_squares_functions()) register_function(registry, function);
  for (const analytic::Function& function : analytic::smooth_functions()) register_function(registry, function);
}

}  // namespace nodal
