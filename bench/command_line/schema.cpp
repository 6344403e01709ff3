// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "commands.h"
#include "editing/json_schema.h"

namespace nodal {

int schema_command(const SchemaArguments&, const Registry& registry) {
  std::cout << editing::study_json_schema(registry) << '\n';
  return 0;
}

}  // namespace nodal
