// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nodal/elastic/account.h>

#include "displacements/elastic_model.h"

namespace nodal::elastic {

/// How many coordinates there are, how equilibria will be solved, and how single changes will be priced.
void tell_of(const ElasticModel& model, Account& account);

}  // namespace nodal::elastic
