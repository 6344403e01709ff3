// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/read_masses.h"

#include <fmt/format.h>

#include <nodal/error.h>

#include "geometry/plane/voronoi_cells.h"
#include "masses/cell_integrals.h"
#include "masses/masses.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic {

namespace {

constexpr double kDensity = 1.0;  // [kg/m³]

// Mass of each node's Voronoi region; these regions are kept for pictures.
std::vector<double> voronoi_masses(double density, const MaterialField& material, const Net& net, Account& account) {
  const plane::Outline outline(net.body);
  plane::VoronoiCells cells(outline, {});
  cells.compute(in_plane(net.nodes));
  std::vector<double> masses = cell_integrals(cells, material, net.body, masses_per_area(material, density, net.body));
  if (account.regions.empty())
    for (std::size_t i = 0; i < net.nodes.size(); ++i) account.regions.push_back(cells.rings(i));
  return masses;
}

Value report(const std::string& form, const Masses& masses) {
  Value table;
  table.set("form", form);
  table.set("smallest", masses.smallest);
  table.set("rank", Value(static_cast<std::int64_t>(masses.rank)));
  Value errors;
  for (const MomentError& moment : masses.moments) errors.set(moment.name, moment.relative);
  table.set("moment_errors", std::move(errors));
  table.set("message", masses.message);
  return table;
}

// A key that the form doesn't use would be said in vain.
void refuse_foreign_keys(const Options& masses, const std::string& form) {
  const auto refuse = [&](const char* key, const char* forms) {
    throw InputError(masses.at(key).source,
                     fmt::format("'{}' in 'masses' belongs to form {}, and this one is '{}'", key, forms, form));
  };
  if (form == "none" && masses.given("density")) refuse("density", "'least-norm' or 'positive'");
  if (form != "positive" && masses.given("least_share")) refuse("least_share", "'positive'");
}

}  // namespace

OptionSchema masses_fields() {
  return {
      {.name = "form",
       .type = OptionType::text,
       .default_value = "none",
       .choices = {"none", "least-norm", "positive"},
       .help = "none: equilibria need no masses; in the plane, least-norm: the body's moments up to order two with the "
               "least Σ m², "
               "masses may be negative; positive: the masses nearest to those of the Voronoi regions that have the "
               "moments (needs CGAL)"},
      {.name = "density",
       .default_value = kDensity,
       .unit = "kg/m³",
       .minimum = 0.0,
       .minimum_excluded = true,
       .help = "of the body, where a region has none of its own"},
      {.name = "least_share",
       .default_value = kSmallestMassShare,
       .minimum = 0.0,
       .maximum = 1.0,
       .help = "positive: no mass is less than this share of its Voronoi region's"},
  };
}

void read_masses(const Options& masses, const MaterialField& material, Net& net, Account& account) {
  const std::string& form = masses.text("form");
  refuse_foreign_keys(masses, form);
  if (form == "none") {
    if (net.masses.empty()) return account.left_out("masses", "equilibria need none");
    return account.used("masses", "as the file of nodes says");
  }
  const Source& source = masses.at("form").source;
  if (net.dimension == 3)
    throw InputError(source, "masses are found in the plane only; equilibria need none: leave 'masses' out");
  if (!net.body.has_outline())
    throw InputError(
        source,
        "masses need a body with an outline, and this one has none; describe it, as by body = { size = [4, 4] }");
  if (form == "positive" && !triangulation_available())
    throw InputError(source, fmt::format("positive masses need {}", triangulation_library()));
  at(source, [&] {
    const double density = masses.number("density");
    const MassTarget target = mass_target(net.body, density, material);
    const Masses found = form == "least-norm" ? least_norm_masses(in_plane(net.nodes), target)
                                              : positive_masses(in_plane(net.nodes), target,
                                                                voronoi_masses(density, material, net, account),
                                                                masses.number("least_share"));
    if (form == "positive" && found.outcome == MassOutcome::infeasible)
      throw InputError(source,
                       fmt::format("{}; take masses = {{ form = \"least-norm\" }}, or other points", found.message));
    net.masses = found.masses;
    account.used("masses", fmt::format("{}: {}", form, found.message));
    account.data.set("masses", report(form, found));
  });
}

}  // namespace nodal::elastic
