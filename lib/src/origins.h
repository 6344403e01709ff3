// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Which build, and which processor, the records of a store come from.

#include <span>
#include <string>
#include <vector>

#include <nodal/record.h>
#include <nodal/value.h>

namespace nodal {

/// The provenance of the manifest's last run; an empty table where there is none.
[[nodiscard]] Value last_provenance(const Value& manifest);

/// Sentences for people about the trials that the manifest's study asks for (all, where it has no keys) and that
/// another build or processor ran than the one of `here`, a provenance that `whose` names: "present one", "last run's".
/// A record without conditions is of the manifest's first run.
[[nodiscard]] std::vector<std::string> origin_warnings(const std::string& store, const Value& manifest,
                                                       std::span<const TrialRecord> records, const Value& here,
                                                       const std::string& whose);

}  // namespace nodal
