// SPDX-License-Identifier: GPL-3.0-or-later
#include "battery/check.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include <nodal/elastic/extended_equilibrium.h>

#include "battery/case.h"

namespace nodal::elastic::battery {

namespace {

struct Row {
  std::string got, message;
  std::optional<double> estimate, error;
  double milliseconds = 0.0;
  std::string differs;  ///< what is not as expected; empty when all is
};

// The error of displacements, and whether the cost is as near to the exact one as health says.
void compare_with_exact(const ElasticProblem& problem, const std::vector<double>& stiffness, const State& state,
                        const StabilityCase& wanted, Row& row) {
  const std::optional<ExtendedState> exact = solve_extended(problem.scene(), stiffness);
  if (!exact) {
    row.differs = "there is no equilibrium in extended precision";
    return;
  }
  row.error = displacement_error(state, *exact);
  const double cost = 0.5 * state.relative_error * state.relative_error;
  // The cost came through a square root and back: a few roundings of its own.
  const double allowed = state.health.cost_error.value_or(0.0) + 1e-15 * cost;
  if (!(*row.error <= wanted.error))
    row.differs = fmt::format("error {:.1e}, at most {:.0e} wanted", *row.error, wanted.error);
  else if (!(std::abs(cost - exact->cost) <= allowed))
    row.differs = fmt::format("the cost is off by {:.1e}, which it states to be at most {:.1e}",
                              std::abs(cost - exact->cost), allowed);
}

Row run_case(const StabilityCase& wanted) {
  Row row;
  try {
    std::vector<double> stiffness;
    const auto problem = wanted.make(stiffness);
    const auto began = std::chrono::steady_clock::now();
    const State state = problem->solve(stiffness);
    row.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count();
    row.got = to_string(state.status);
    row.message = state.message;
    row.estimate = state.health.error_estimate;
    if (state.status == Status::ok && wanted.expect == "ok")
      compare_with_exact(*problem, stiffness, state, wanted, row);
  } catch (const InputError& error) {
    row.got = "refused";
    row.message = error.what();
  }
  if (row.got != wanted.expect)
    row.differs = "another status than expected";
  else if (row.message.find(wanted.names) == std::string::npos)
    row.differs = fmt::format("the message should name {}", wanted.names);
  else if (wanted.no_alarm && row.estimate.value_or(0.0) > *wanted.no_alarm)
    row.differs = fmt::format("a false alarm: at most {:.0e} was wanted", *wanted.no_alarm);
  return row;
}

std::string number(const std::optional<double>& value) { return value ? fmt::format("{:.1e}", *value) : "–"; }

std::string as_text(const StabilityCase& wanted, const Row& row) {
  const std::string text = fmt::format("{:<44} {:<22} {:<22} {:>9} {:>9} {:>9.2f}  {}\n", wanted.name, wanted.expect,
                                       row.got, number(row.estimate), number(row.error), row.milliseconds,
                                       row.differs.empty() ? "as expected" : "DIFFERS: " + row.differs);
  return row.message.empty() ? text : text + "  " + row.message + "\n";
}

Value as_value(const StabilityCase& wanted, const Row& row) {
  Value entry;
  entry.set("case", wanted.name);
  entry.set("expected", wanted.expect);
  entry.set("got", row.got);
  if (!row.message.empty()) entry.set("message", row.message);
  if (row.estimate && std::isfinite(*row.estimate)) entry.set("error_estimate", *row.estimate);
  if (row.error && std::isfinite(*row.error)) entry.set("error", *row.error);
  entry.set("milliseconds", row.milliseconds);
  entry.set("as_expected", row.differs.empty());
  if (!row.differs.empty()) entry.set("differs", row.differs);
  return entry;
}

}  // namespace

namespace {

int run(const Options& options, const CommandContext& context) {
  const std::filesystem::path file = options.has("battery") ? std::filesystem::path(options.text("battery"))
                                                            : context.scenes / "stability" / "battery.toml";
  const std::vector<StabilityCase> battery = read_battery(file, context.registry);
  const bool json = options.boolean("json");
  if (!json)
    context.out << fmt::format("{:<44} {:<22} {:<22} {:>9} {:>9} {:>9}\n", "case", "expected", "got", "estimate",
                               "error", "time [ms]");
  Value::List rows;
  std::size_t differing = 0;
  for (const StabilityCase& wanted : battery) {
    const Row row = run_case(wanted);
    differing += row.differs.empty() ? 0 : 1;
    if (json)
      rows.push_back(as_value(wanted, row));
    else
      context.out << as_text(wanted, row);
  }
  if (json)
    context.out << to_json(Value(std::move(rows))) << '\n';
  else
    context.out << fmt::format("\n{} cases, {} not as expected\n", battery.size(), differing);
  return differing == 0 ? 0 : 1;
}

}  // namespace

Command check_command() {
  return {
      .name = "check",
      .summary = "The stability battery: systems that are hard or impossible to solve",
      .positional = "battery",
      .options = {{.name = "battery", .type = OptionType::text, .unit = "FILE", .help = "A file of cases of your own"},
                  {.name = "json", .type = OptionType::boolean, .default_value = false, .help = "Every row as JSON"}},
      .run = run};
}

}  // namespace nodal::elastic::battery
