// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/displacement_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include <nodal/shown.h>

#include "geometry/plane/segment.h"
#include "import/csv.h"
#include "import/node_names.h"
#include "import/same_height.h"

namespace nodal::elastic {

namespace {

// A position that was written with six digits must still find its node.
constexpr double kSamePlace = 1e-6;

// Nodes by place, found among those of nearly the same x.
class NodePlaces {
 public:
  explicit NodePlaces(const Net& net)
      : net_(net), order_(net.nodes.size()), slack_(kSamePlace * extent_of(net.nodes).size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::sort(order_, {}, [&](std::size_t i) { return net.nodes[i]; });
  }

  std::size_t find(const Vector& p, const Source& source) const {
    const auto x = [&](std::size_t i) { return net_.nodes[i][0]; };
    for (auto at = std::ranges::lower_bound(order_, p[0] - slack_, {}, x);
         at != order_.end() && x(*at) <= p[0] + slack_; ++at)
      if (distance(net_.nodes[*at], p) <= slack_) return *at;
    const std::size_t nearest =
        *std::ranges::min_element(order_, {}, [&](std::size_t i) { return distance(net_.nodes[i], p); });
    const double away = distance(net_.nodes[nearest], p);
    const bool far = away * kSamePlace > slack_;
    throw InputError(
        source, fmt::format("there is no node at ({}, {}); the nearest is node {} at ({}, {}), {:.3g} m away{}", p[0],
                            p[1], net_.id(nearest), net_.nodes[nearest][0], net_.nodes[nearest][1], away,
                            far ? "; 'scale' says what the table's unit of length is" : ""));
  }

 private:
  const Net& net_;
  std::vector<std::size_t> order_;
  double slack_;
};

std::size_t load_of(const CsvRow& row, bool named, const std::vector<std::string>& loads) {
  if (!named) {
    if (loads.size() == 1) return 0;
    throw InputError(row.source(), fmt::format("a column 'load' must say which load a row is for; the study has {}",
                                               fmt::join(loads, ", ")));
  }
  const auto found = std::ranges::find(loads, row.text("load"));
  if (found == loads.end())
    throw InputError(row.source(), fmt::format("the study has no load '{}'{}", shown(row.text("load")),
                                               name_hint(row.text("load"), loads)));
  return static_cast<std::size_t>(found - loads.begin());
}

void take(const CsvRow& row, double scale, const Freedoms& freedoms, std::size_t node, MeasuredLoad& load) {
  const double weight = row.number("weight").value_or(1.0);
  if (!(weight >= 0.0)) throw InputError(row.source(), fmt::format("'weight' is {}; it must be ≥ 0", weight));
  const char* axes[] = {"ux", "uy", "uz"};
  for (std::size_t axis = 0; axis < freedoms.dimension; ++axis) {
    const std::optional<double> u = row.measured(axes[axis]);
    if (!u) continue;
    const double metres = *u * scale;
    if (!std::isfinite(metres))
      throw InputError(row.source(),
                       fmt::format("'{}' times 'scale' leaves the range of double precision", axes[axis]));
    load.displacement[freedoms.at(node, axis)] = metres;
    load.weights[freedoms.at(node, axis)] = weight;
  }
}

void refuse_motion_in_space(const CsvRow& row) {
  const std::optional<double> uz = row.measured("uz");
  if (uz && *uz != 0.0)
    throw InputError(row.source(), fmt::format("'uz' is {}: a plane system moves in x and y only; name the columns to "
                                               "be read with 'columns', and it is left out",
                                               *uz));
}

}  // namespace

std::vector<MeasuredLoad> read_displacement_file(InputFiles& files, const std::filesystem::path& path, const Net& net,
                                                 const std::vector<std::string>& loads, Account& account,
                                                 const TableOptions& options) {
  const CsvTable table(files.read(path, "displacement file"), path.string(),
                       {{"load"}, {"node"}, {"x"}, {"y"}, {"z"}, {"ux", true}, {"uy", true}, {"uz"}, {"weight"}},
                       options.columns);
  const bool by_name = table.has("node");
  if (by_name == (table.has("x") && table.has("y")))
    throw InputError({path.string(), 1}, "the columns must have either 'node', or both 'x' and 'y'");
  const NodeNames names(net);
  const NodePlaces places(net);
  const std::size_t freedoms = net.freedoms().size();
  std::vector<MeasuredLoad> measured(loads.size(),
                                     {std::vector<double>(freedoms, 0.0), std::vector<double>(freedoms, 0.0)});
  std::vector<std::vector<bool>> seen(loads.size(), std::vector<bool>(net.nodes.size(), false));
  SameHeight heights;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const CsvRow row = table.row(i);
    const std::size_t load = load_of(row, table.has("load"), loads);
    const auto place = [&](const char* axis) { return row.required_number(axis) * options.scale; };
    const std::size_t node = by_name ? names.find(row.required_integer("node"), row.source())
                                     : places.find({place("x"), place("y"), 0.0}, row.source());
    if (seen[load][node])
      throw InputError(row.source(),
                       fmt::format("node {} stands twice in load '{}'", net.id(node), shown(loads[load])));
    seen[load][node] = true;
    heights.add(row.number("z"), row.source());
    refuse_motion_in_space(row);
    take(row, options.scale, net.freedoms(), node, measured[load]);
  }
  for (std::size_t l = 0; l < loads.size(); ++l)
    if (std::ranges::none_of(measured[l].weights, [](double w) { return w > 0.0; }))
      throw InputError(
          {path.string(), 0},
          fmt::format("no displacement is measured for load '{}': all are empty, or have the weight 0; to solve "
                      "without comparing, leave 'reference' out",
                      shown(loads[l])));
  for (const std::string& remark : {table.left_out(), heights.left_out(path.string())})
    if (!remark.empty()) account.remark(remark);
  return measured;
}

}  // namespace nodal::elastic
