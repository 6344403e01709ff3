// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/shown.h>

#include "read/read_material.h"

namespace nodal::elastic {

namespace {

std::string orthotropic_text(const Orthotropic& m, std::size_t axes) {
  const std::size_t pairs = axes == 2 ? 1 : 3;
  const auto first = [](const auto& numbers, std::size_t count) {
    return fmt::format("{:.6g}",
                       fmt::join(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count), ", "));
  };
  std::string text = fmt::format("orthotropic, E {}, ν {}, G {}", first(m.young, axes), first(m.poisson, pairs),
                                 first(m.shear, pairs));
  if (m.angle == 0.0) return text;
  text += fmt::format(", turned by {:g}°", m.angle);
  if (axes == 3) text += fmt::format(" about [{:g}]", fmt::join(m.axis, ", "));
  return text;
}

std::string constants_text(const Material& m, std::size_t dimension) {
  if (!m.orthotropic) return fmt::format("E {:.6g}, ν {:.6g}", m.young, m.poisson);
  return orthotropic_text(*m.orthotropic, m.plane == Plane::strain ? 3 : dimension);
}

std::string region_text(const Region& region, const Material& base, std::size_t dimension) {
  std::string text = region.material == base ? "the body's constants" : constants_text(region.material, dimension);
  if (region.density) text += fmt::format(", density {:g}", *region.density);
  if (region.thickness) text += fmt::format(", thickness {:g}", *region.thickness);
  return text;
}

// ν, and where the plane changes it what a net in the plane is asked to show.
std::string ratio_text(const Material& material, double in_the_body) {
  if (material.poisson == in_the_body) return fmt::format("{:.4g}", in_the_body);
  return fmt::format("ν = {:.4g}, which is ν/(1 − ν) = {:.4g} in plane strain", material.poisson, in_the_body);
}

}  // namespace

void tell_of_material(const MaterialField& material, const Body& body, Account& account) {
  const std::size_t dimension = body.dimension();
  std::string text = constants_text(material.base, dimension);
  if (!body.box) text += material.base.plane == Plane::stress ? ", plane stress" : ", plane strain";
  if (material.regions.empty()) return account.used("material", std::move(text));
  const char* of = body.box ? "volume" : "area";
  account.used("material", fmt::format("{}, on {:.3g} % of the {}; {} region{}", text, 100.0 * material.shares[0], of,
                                       material.regions.size(), material.regions.size() == 1 ? "" : "s"));
  Value::List regions;
  for (std::size_t k = 1; k <= material.regions.size(); ++k) {
    const Region& region = material.regions[k - 1];
    const std::string line = region_text(region, material.base, dimension);
    account.remark(
        fmt::format("region '{}', {:.3g} % of the {}: {}", shown(region.name), 100.0 * material.shares[k], of, line));
    Value one;
    one.set("name", region.name);
    one.set("share", material.shares[k]);
    one.set("material", line);
    regions.push_back(std::move(one));
  }
  if (!material.counts(kBodyRegion)) account.remark("regions cover all of the body: its own constants count nowhere");
  account.data.set("regions", Value(std::move(regions)));
}

void tell_of_poisson(const MaterialField& material, std::size_t dimension, bool tied, Account& account) {
  const bool space = dimension == 3;
  std::vector<double> told;
  for (std::size_t region = 0; region <= material.regions.size(); ++region) {
    if (!material.counts(region)) continue;
    const std::optional<Moduli> isotropic = material.material_of(region).elasticity(dimension).isotropic();
    if (!isotropic || std::abs(isotropic->poisson - (space ? 0.25 : 1.0 / 3.0)) <= 0.02) continue;
    if (std::ranges::count(told, isotropic->poisson) > 0) continue;
    told.push_back(isotropic->poisson);
    account.remark(fmt::format(
        "springs alone make a Cauchy-elastic net: even, isotropic ones have Poisson's ratio {}, {} has {}; {}",
        space ? "1/4 in space" : "1/3 in the plane",
        region == kBodyRegion ? "the material" : fmt::format("region '{}'", shown(material.regions[region - 1].name)),
        ratio_text(material.material_of(region), isotropic->poisson),
        tied ? "tied springs can't make up for that, so expect a remaining error"
             : "free, uneven springs reach it at the price of a spread in stiffness and of local noise"));
  }
}

}  // namespace nodal::elastic
