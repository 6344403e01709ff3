// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The block of the tests: the elastic problem in space, by a few options.

#include <memory>
#include <string>

#include "plate.h"

namespace nodal::elastic {

/// Options of a block; 3 × 3 × 3 nodes of unit cubes unless said otherwise.
struct BlockOptions {
  double poisson = 0.3;
  std::string size = "[2, 2, 2]";
  std::string counts = "[3, 3, 3]";
  std::string topology = "crossed";
  std::string parameters = "each";
  std::string initial = "\"paper\"";
  std::string supports = "face";
  std::string bounds = "[1e-4, 1e2]";
  double young = 1.0;
  double stress = 1.0;
  std::string solver = "auto";
  std::string moves = "auto";
  std::string instructions = "auto";
  std::string more = "";  ///< lines after those of [problem]
};

inline std::string block_toml(const BlockOptions& o) {
  const auto number = [](double x) { return to_json(Value(x)); };
  return "[problem]\nkind = \"elastic\"\nbody = { shape = \"box\", size = " + o.size +
         " }\nmaterial = { young = " + number(o.young) + ", poisson = " + number(o.poisson) +
         " }\npoints = { counts = " + o.counts + " }\nsprings = { topology = \"" + o.topology + "\", parameters = \"" +
         o.parameters + "\", initial = " + o.initial + ", bounds = " + o.bounds +
         " }\nloads = { stress = " + number(o.stress) + ", supports = \"" + o.supports +
         "\" }\nequilibrium = { method = \"" + o.solver + "\" }\nmoves = { form = \"" + o.moves +
         "\", instructions = \"" + o.instructions + "\" }\n" + o.more;
}

inline std::shared_ptr<const ElasticProblem> make_block(const BlockOptions& options = {}) {
  return as_elastic(parse_study(block_toml(options), "block.toml", components()));
}

}  // namespace nodal::elastic
