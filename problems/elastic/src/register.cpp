// SPDX-License-Identifier: GPL-3.0-or-later
// What the program is told of the elastic problem.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/elastic/elastic_problem.h>
#include <nodal/provenance.h>

#include "battery/check.h"
#include "displacements/findings.h"
#include "show/details.h"
#include "show/drawing_cost.h"
#include "springs/connection.h"
#include "system/factor/cholesky.h"
#include "triangulation/triangulation.h"

namespace nodal {

namespace elastic {

namespace {

Listing topology_list() {
  Listing list{"topologies", {}};
  for (const Connection* connection : connections()) {
    const std::string lacks = connection->lacking();
    std::vector<std::string> remarks;
    if (const std::string_view where = connection->where(); !where.empty()) remarks.emplace_back(where);
    if (connection->mechanism) remarks.emplace_back("a mechanism: refused");
    list.lines.push_back(fmt::format("{}: {}{}", connection->name,
                                     lacks.empty() ? std::string(connection->summary) : "not here: it needs " + lacks,
                                     remarks.empty() ? "" : fmt::format(" ({})", fmt::join(remarks, ", "))));
  }
  return list;
}

ProblemDescription describe_elastic() {
  return {.kind = "elastic",
          .summary = "spring stiffnesses with which a net deforms like an elastic body",
          .reference =
              "O. Deussen, L. Kobbelt, P. Tücke, Using Simulated Annealing to Obtain Good Nodal "
              "Approximations of Deformable Bodies, 1995",
          .options = elastic_schema(),
          .make = [](const Options& options, const ProblemContext& context) -> std::shared_ptr<const Problem> {
            return std::make_shared<ElasticProblem>(make_scene(options, context));
          },
          .quality_name = "G",
          .quality_help = "the paper's quality measure: smaller is better",
          .findings = {{.name = std::string(kSpread),
                        .title = "k_max/k_min",
                        .help = "the stiffest spring of the best point over the softest"},
                       {.name = std::string(kStableStep),
                        .title = "stable step",
                        .unit = "s",
                        .help = "explicit integration of the best point in time is stable below it, whatever holds"},
                       {.name = std::string(kReferenceError),
                        .title = "reference error",
                        .help = "how far off the reference displacements may be by the estimate of finite elements, as "
                                "a relative error: one below it is no result",
                        .floor = true}},
          .show_details = show::details_part,
          .too_costly_to_draw = show::drawing_refusal,
          .commands = {battery::check_command()},
          .listings = {topology_list()},
          .samples = {{},
                      {"small", "points = { layout = \"grid\", counts = [4, 3] }\n"},
                      {"tied", "springs = { parameters = \"by-direction\" }\nloads = { supports = \"minimal\" }\n"},
                      {"cube", "body = { size = [2, 2, 2] }\npoints = { counts = [3, 3, 3] }\n"}}};
}

}  // namespace

}  // namespace elastic

void register_elastic(Registry& registry) {
  add_library_version("BLAS", elastic::blas_library());
  add_library_version("CHOLMOD", elastic::cholmod_version());
  if (elastic::triangulation_available()) add_library_version("CGAL", elastic::triangulation_library());
  registry.add(elastic::describe_elastic());
}

}  // namespace nodal
