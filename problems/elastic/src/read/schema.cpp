// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/scene.h>

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "import/table_options.h"
#include "moves/pricing_forms.h"
#include "read/body_options.h"
#include "read/material_options.h"
#include "read/read_masses.h"
#include "read/read_parameters.h"
#include "read/read_points.h"
#include "read/read_topology.h"
#include "read/study_loads.h"
#include "read/study_reference.h"
#include "starts/start_rule.h"
#include "starts/stiffness_bounds.h"

namespace nodal::elastic {

namespace {

OptionSchema initial_fields() {
  return {
      {.name = "rule", .type = OptionType::text, .choices = names_of(start_rules()), .help = "one of the rules"},
      {.name = "scale",
       .type = OptionType::text,
       .choices = {"best"},
       .help = "best: times the single factor that makes the error least"},
      {.name = "file",
       .type = OptionType::text,
       .help = "a stiffness file, relative to the study; outside the bounds it can be evaluated, but not fitted"},
  };
}

OptionSchema bounds_fields() {
  return {
      {.name = "around",
       .type = OptionType::text,
       .required = true,
       .choices = {"start"},
       .help = "start: the stiffness that each spring, or group of tied ones, starts from"},
      {.name = "factor",
       .type = OptionType::number,
       .required = true,
       .minimum = 1.0,
       .minimum_excluded = true,
       .help = "from the start's stiffness over this to the start's times this"},
  };
}

// What is free, and where it starts.
OptionSchema stiffness_fields() {
  return {
      parameters_option(),
      {.name = "initial",
       .type = OptionType::text,
       .default_text = "a file of springs' stiffnesses; else paper, off the paper's own plate (cells of 1 m × 1 m) "
                       "times its best factor",
       .choices = names_of(start_rules()),
       .help = fmt::format("rule of the start: {}; or a table with 'rule' and 'scale', or with 'file'",
                           fmt::join(summaries_of(start_rules()), "; ")),
       .fields = initial_fields(),
       .or_table = true},
      {.name = "bounds",
       .type = OptionType::number_list,
       .default_text =
           fmt::format("[{}, {}]; with a file of springs those of the file, or that times the geometric mean "
                       "of its stiffnesses, or of the start at its best factor [N/m]",
                       kDefaultBounds[0], kDefaultBounds[1]),
       .unit = "young × thickness, in space young × mean rest length",
       .minimum = 0.0,
       .minimum_excluded = true,
       .length = 2,
       .help = "lowest and highest stiffness of a spring; or a table with 'around' and 'factor'",
       .fields = bounds_fields(),
       .or_table = true},
  };
}

OptionSchema springs_fields() {
  OptionSchema fields = {
      {.name = "file",
       .type = OptionType::text,
       .help = "springs of your own, in the plane: CSV with columns first, second (the nodes) and if you like "
               "stiffness, group; or a system file"},
      columns_option({"first", "second", "stiffness", "length", "group"}),
  };
  std::ranges::move(topology_options(), std::back_inserter(fields));
  std::ranges::move(stiffness_fields(), std::back_inserter(fields));
  return fields;
}

OptionSchema moves_fields() {
  std::vector<std::string> forms = {"auto"}, told;
  for (const PricingFormDescription* form : pricing_forms()) {
    forms.emplace_back(form->name);
    told.push_back(fmt::format("{} {}", form->name, form->summary));
  }
  return {
      {.name = "form",
       .type = OptionType::text,
       .default_value = "auto",
       .choices = std::move(forms),
       .help = fmt::format("auto chooses by size and by how much is accepted, and changes its mind; {}",
                           fmt::join(told, ", "))},
      {.name = "instructions",
       .type = OptionType::text,
       .default_value = "auto",
       .choices = {"auto", "generic", "sse2", "avx2", "avx512"},
       .help = "of the vector kernels; auto takes the widest that the processor has"},
  };
}

OptionSchema weight_fields() {
  const auto weight = [](const char* name, double value, const char* help) {
    return Option{.name = name, .type = OptionType::number, .default_value = value, .minimum = 0.0, .help = help};
  };
  return {weight("inner", 1.0, "of inner nodes"), weight("border", 3.0, "of nodes on the border, corners apart"),
          weight("corner", 15.0, "of corners")};
}

Option prior_option() {
  return {.name = "prior",
          .type = OptionType::table,
          .default_text = "none: fits answer to the data alone",
          .help = "a wish beside the data: stiffnesses near those of the start, which decides what the data leave open",
          .fields = {
              {.name = "weight",
               .type = OptionType::number,
               .required = true,
               .minimum = 0.0,
               .minimum_excluded = true,
               .help = "w of cost = ½ [(relative error)² + w · mean over springs of ln²(k/k_start)]; a best_known and "
                       "gaps are then of the cost with it"}}};
}

Option table(const char* name, const char* help, OptionSchema fields) {
  return {.name = name, .type = OptionType::table, .default_value = Value(), .help = help, .fields = std::move(fields)};
}

}  // namespace

OptionSchema elastic_schema() {
  return {
      table("body", "what is approximated", body_fields()),
      table("material", "linear elastic: isotropic or orthotropic, the same everywhere but in regions",
            material_fields()),
      table("points", "where the nodes are", points_fields()),
      table("masses", "how heavy the nodes are", masses_fields()),
      table("springs", "which nodes are joined, what is free, where it starts", springs_fields()),
      table("loads", "forces and supports", loads_fields()),
      table("reference", "the displacements to be matched", reference_fields()),
      table("quality", "how displacements are compared: G of eq. (12)",
            {table("weights", "of squared differences", weight_fields())}),
      prior_option(),
      table("equilibrium", "how equilibria are solved",
            {{.name = "method",
              .type = OptionType::text,
              .default_value = "auto",
              .choices = {"auto", "lanes", "simplicial", "supernodal"},
              .help = "what races see: lanes factors all support groups at once in vector registers, simplicial and "
                      "supernodal "
                      "are CHOLMOD's, one group at a time; auto takes the lanes. What is reported "
                      "always comes from CHOLMOD"}}),
      table("moves", "how single changes are priced, as annealing makes them", moves_fields()),
  };
}

}  // namespace nodal::elastic
