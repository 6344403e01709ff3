// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// docs/config_reference.md, made from the option schemas of everything that is registered.
///
/// What the schemas can't say (how a study is put together, rules between keys) stands here as text; every table comes
/// from the code that reads the key.

#include <string>
#include <string_view>
#include <vector>

#include <nodal/registry.h>

namespace nodal::docs {

/// The whole page. It is complete only where nothing optional is missing from the build.
[[nodiscard]] std::string config_reference(const Registry& registry);

/// The parts of the page that any build must agree on: the study's own tables, and one section per registered problem
/// and optimizer.
[[nodiscard]] std::vector<std::string> config_reference_sections(const Registry& registry);

/// False where the registry says that a whole library is missing.
[[nodiscard]] bool is_complete(const Registry& registry);

/// The study that the page begins with; it needs no optional library.
[[nodiscard]] std::string_view example_study();

}  // namespace nodal::docs
