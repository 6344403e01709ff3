// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What holds a load case of a study's own: entries of `supports`.
///
/// Units    m.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <nodal/options.h>

#include "loads/placed_load.h"

namespace nodal::elastic {

struct Held {
  double value = 0.0;
  bool measured = false;
  Source source;
};

/// By freedom.
using HeldFreedoms = std::map<std::size_t, Held>;

/// Adds one entry to what is held and to what the body sees of it; returns what was selected, for people. InputError
/// for a freedom that is held already, elsewhere.
std::string add_supports(const Options& table, const Net& net, HeldFreedoms& held, BodyLoad& body);

/// What is held without a piece of the border beside it.
[[nodiscard]] std::vector<Support> points_of(const BodyLoad& body, const std::vector<Support>& supports,
                                             const Net& net);

}  // namespace nodal::elastic
