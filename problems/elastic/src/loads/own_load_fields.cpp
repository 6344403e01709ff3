// SPDX-License-Identifier: GPL-3.0-or-later
#include "loads/own_loads.h"
#include "loads/selection.h"

namespace nodal::elastic {

namespace {

OptionSchema with_selection(OptionSchema own) {
  OptionSchema fields = selection_fields();
  fields.insert(fields.end(), own.begin(), own.end());
  return fields;
}

OptionSchema support_fields() {
  return with_selection({
      {.name = "fix",
       .type = OptionType::text,
       .default_value = "xy",
       .choices = {"x", "y", "xy"},
       .help = "which displacements are held"},
      {.name = "displacement",
       .type = OptionType::number_list,
       .default_text = "[0, 0]",
       .unit = "m",
       .length = 2,
       .help = "where they are held; the one of an axis that isn't held counts for nothing"},
      {.name = "measured",
       .type = OptionType::boolean,
       .default_value = false,
       .help = "held where the reference says that the nodes went"},
  });
}

OptionSchema force_fields() {
  return with_selection({
      {.name = "force", .type = OptionType::number_list, .unit = "N", .length = 2, .help = "on each of the nodes"},
      {.name = "total",
       .type = OptionType::number_list,
       .unit = "N",
       .length = 2,
       .help = "instead of 'force': on all of them together, in equal shares"},
  });
}

OptionSchema traction_fields() {
  return with_selection({
      {.name = "traction",
       .type = OptionType::number_list,
       .unit = "Pa",
       .length = 2,
       .help = "force per area of the edge, in x and y"},
      {.name = "pressure", .type = OptionType::number, .unit = "Pa", .help = "instead: inwards, along the normal"},
      {.name = "stress",
       .type = OptionType::number_list,
       .unit = "Pa",
       .length = 3,
       .help = "instead: σ·n of the stress state σ_xx, σ_yy, σ_xy"},
  });
}

}  // namespace

OptionSchema case_fields() {
  return {
      {.name = "name", .type = OptionType::text, .required = true, .help = "what files and reports call it"},
      {.name = "supports",
       .type = OptionType::table_list,
       .default_value = Value(Value::List{}),
       .help = "what holds",
       .fields = support_fields()},
      {.name = "forces",
       .type = OptionType::table_list,
       .default_value = Value(Value::List{}),
       .help = "forces on nodes",
       .fields = force_fields()},
      {.name = "tractions",
       .type = OptionType::table_list,
       .default_value = Value(Value::List{}),
       .help = "what pulls at an edge: at every piece of an outline with both ends selected, by tributary length and "
               "thickness",
       .fields = traction_fields()},
      {.name = "body_force",
       .type = OptionType::number_list,
       .default_text = "none",
       .unit = "N/m³",
       .length = 2,
       .help =
           "on all of the body, in x and y, as its weight ρ g; a node gets it times its Voronoi cell's volume (needs "
           "CGAL)"},
  };
}

}  // namespace nodal::elastic
