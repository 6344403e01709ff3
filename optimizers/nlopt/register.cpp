// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/provenance.h>
#include <nodal/registry.h>

#include "methods.h"
#include "nlopt_optimizer.h"
#include "settings.h"

namespace nodal {

namespace nlopt_methods {

namespace {

std::optional<Suitability> suits(const Method& method) {
  if (method.algorithm != NLOPT_LD_LBFGS) return std::nullopt;
  return Suitability{30, "gradients cost little, and the memory needed grows with the coordinates only"};
}

OptimizerDescription describe(const Method& method) {
  return {
      .name = std::string(method.name),
      .summary = std::string(method.summary),
      .reference = std::string(method.reference),
      .needs = {.gradient = method.needs_gradient},
      .deterministic = method.deterministic,
      .uses_start = method.uses_start,
      .local = method.local,
      .dense_matrix = method.dense_model || method.population.per_freedom > 0 ? DenseMatrix::square : DenseMatrix::none,
      .options = make_schema(method),
      .make = [&method](
                  const Options& options) { return std::make_unique<NloptOptimizer>(method, read_settings(options)); },
      .suits = [&method](const Problem&) { return suits(method); }};
}

std::string library_version() {
  int major = 0, minor = 0, fix = 0;
  nlopt_version(&major, &minor, &fix);
  return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(fix);
}

}  // namespace

}  // namespace nlopt_methods

void register_nlopt(Registry& registry) {
  using namespace nlopt_methods;
  add_library_version("NLopt", library_version());
  for (const Method& method : all_methods()) registry.add(describe(method));
  for (const LeftOutMethod& method : left_out_methods())
    registry.add(AbsentDescription{std::string(method.name), std::string(method.reason)});
}

}  // namespace nodal
