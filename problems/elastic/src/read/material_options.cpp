// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/material_options.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>

#include "import/table_options.h"

namespace nodal::elastic {

namespace {

Option modulus(const char* name, const char* help) {
  return {.name = name, .unit = "Pa", .minimum = 0.0, .minimum_excluded = true, .help = help};
}

Option poisson_option() {
  return {.name = "poisson",
          .minimum = -1.0,
          .maximum = 0.5,
          .minimum_excluded = true,
          .maximum_excluded = true,
          .help = "Poisson's ratio ν; at most 0.4999 in plane strain and in space"};
}

// Of a region: what it leaves out is the body's.
Option of_body(Option option) {
  option.default_value.reset();
  option.default_text = "the body's";
  return option;
}

OptionSchema orthotropic_fields() {
  constexpr const char *kAlways = "needed", *kAcross = "needed in plane strain and in space",
                       *kSpace = "needed in space";
  const auto needed = [](Option option, const char* when) {
    option.default_text = when;
    return option;
  };
  const auto number = [](const char* name, const char* help) { return Option{.name = name, .help = help}; };
  return {
      needed(modulus("young_x", "E along the material's own x axis"), kAlways),
      needed(modulus("young_y", "along its y axis"), kAlways),
      needed(modulus("young_z", "along its z axis"), kAcross),
      needed(number("poisson_xy", "ν_xy = −ε_y/ε_x under a pull along x; ν_yx = ν_xy E_y/E_x"), kAlways),
      needed(number("poisson_xz", "ν_xz"), kAcross),
      needed(number("poisson_yz", "ν_yz"), kAcross),
      needed(modulus("shear_xy", "G between x and y"), kAlways),
      needed(modulus("shear_xz", "G between x and z"), kSpace),
      needed(modulus("shear_yz", "G between y and z"), kSpace),
      {.name = "angle",
       .default_text = "0",
       .unit = "°",
       .minimum = -360.0,
       .maximum = 360.0,
       .help = "by which the material's axes are turned from the body's, counterclockwise"},
      {.name = "axis",
       .type = OptionType::number_list,
       .default_text = "[0, 0, 1]",
       .length = 3,
       .help = "in space: about which they are turned, the right-handed way"},
  };
}

Option orthotropic_option() {
  return {.name = "orthotropic",
          .type = OptionType::table,
          .default_text = "isotropic",
          .help = "instead of young and poisson: constants along three axes at right angles, and how these are turned",
          .fields = orthotropic_fields()};
}

// A region of an orthotropic body may say only what differs.
Option region_orthotropic_option() {
  Option option = of_body(orthotropic_option());
  for (Option& field : option.fields) field.default_text = "the body's; of an isotropic one " + field.default_text;
  return option;
}

OptionSchema region_fields() {
  return {
      {.name = "name",
       .type = OptionType::text,
       .default_text = "the feature's, or region 1, …",
       .help = "of the region"},
      {.name = "half_plane",
       .type = OptionType::table,
       .default_text = "none",
       .help = "a shape: all beyond a line, in the plane",
       .fields = {{.name = "point",
                   .type = OptionType::number_list,
                   .required = true,
                   .unit = "m",
                   .length = 2,
                   .help = "on the line"},
                  {.name = "towards",
                   .type = OptionType::number_list,
                   .required = true,
                   .length = 2,
                   .help = "the direction, at right angles to the line, in which the region lies"}}},
      {.name = "box",
       .type = OptionType::number_list,
       .default_text = "none",
       .unit = "m",
       .length = 4,
       .longest = 6,
       .help = "a shape: [x0, y0, x1, y1], in space [x0, y0, z0, x1, y1, z1]"},
      {.name = "polygon",
       .type = OptionType::vector_list,
       .default_text = "none",
       .unit = "m",
       .help = "a shape: its vertices"},
      {.name = "feature",
       .type = OptionType::text,
       .default_text = "none",
       .help = "a shape: the feature of that name in 'file', or in the body's own GeoJSON"},
      {.name = "file",
       .type = OptionType::text,
       .default_text = "none",
       .help = "a shape: the polygon of a file, as that of a body; relative to the study"},
      scale_option("coordinates of 'polygon' or 'file'"),
      of_body(modulus("young", "E of the region")),
      of_body(poisson_option()),
      region_orthotropic_option(),
      of_body({.name = "density", .unit = "kg/m³", .minimum = 0.0, .minimum_excluded = true, .help = "for masses"}),
      of_body({.name = "thickness", .unit = "m", .minimum = 0.0, .minimum_excluded = true, .help = "in the plane"}),
  };
}

// Keys of an orthotropic table that a body asks for, and those it has nothing to do with.
struct OrthotropicKeys {
  std::vector<const char*> needed, foreign;
  const char* body;
};

OrthotropicKeys keys_of(const Material& material, std::size_t dimension) {
  if (dimension == 3)
    return {
        {"young_x", "young_y", "young_z", "poisson_xy", "poisson_xz", "poisson_yz", "shear_xy", "shear_xz", "shear_yz"},
        {},
        "a body in space"};
  if (material.plane == Plane::strain)
    return {{"young_x", "young_y", "young_z", "poisson_xy", "poisson_xz", "poisson_yz", "shear_xy"},
            {"shear_xz", "shear_yz", "axis"},
            "plane strain"};
  return {{"young_x", "young_y", "poisson_xy", "shear_xy"},
          {"young_z", "poisson_xz", "poisson_yz", "shear_xz", "shear_yz", "axis"},
          "plane stress"};
}

// Where a constant stands in Orthotropic.
double& constant(Orthotropic& m, std::string_view key) {
  constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"}, kPairs = {"xy", "xz", "yz"};
  const std::size_t at = key.find('_');
  const std::string_view what = key.substr(0, at), which = key.substr(at + 1);
  const auto index = [&](const auto& names) {
    return static_cast<std::size_t>(std::ranges::find(names, which) - names.begin());
  };
  return what == "young" ? m.young[index(kAxes)] : (what == "poisson" ? m.poisson : m.shear)[index(kPairs)];
}

Orthotropic read_orthotropic(const Constants& constants, const Material& otherwise) {
  const Options table = constants.table.table("orthotropic");
  const OrthotropicKeys keys = keys_of(otherwise, constants.dimension);
  for (const char* key : keys.foreign)
    if (table.has(key))
      throw InputError(table.at(key).source, fmt::format("'{}' of {} is nothing that {} asks for; leave it out", key,
                                                         constants.owner, keys.body));
  Orthotropic read = otherwise.orthotropic.value_or(Orthotropic{});
  for (const char* key : keys.needed)
    if (table.has(key))
      constant(read, key) = table.number(key);
    else if (!otherwise.orthotropic)
      throw InputError(table.values().source,
                       fmt::format("'orthotropic' of {} lacks '{}'; in {} it has {}", constants.owner, key, keys.body,
                                   fmt::join(keys.needed, ", ")));
  if (table.has("angle")) read.angle = table.number("angle");
  if (!table.has("axis")) return read;
  std::ranges::copy(table.numbers("axis"), read.axis.begin());
  if (!(norm(read.axis) > 0.0))
    throw InputError(table.at("axis").source, "'axis' is [0, 0, 0], which has no direction; give one, as [0, 0, 1]");
  return read;
}

void refuse_both_kinds(const Constants& constants) {
  for (const char* key : {"young", "poisson"})
    if (constants.table.given(key))
      throw InputError(constants.table.at(key).source,
                       fmt::format("'{}' and 'orthotropic' of {} exclude each other: an isotropic material has 'young' "
                                   "and 'poisson', an orthotropic one 'orthotropic'",
                                   key, constants.owner));
}

// Isotropic ones, of which a region may say either where the body has the other.
void read_isotropic(const Constants& constants, Material& material) {
  const bool young = constants.table.has("young"), poisson = constants.table.has("poisson");
  if (!young && !poisson) return;
  if (material.orthotropic && !(young && poisson))
    throw InputError(constants.table.at(young ? "young" : "poisson").source,
                     fmt::format("{} is isotropic beside an orthotropic body, so it needs both 'young' and 'poisson'",
                                 constants.owner));
  material.orthotropic.reset();
  if (young) material.young = constants.table.number("young");
  if (poisson) material.poisson = constants.table.number("poisson");
}

}  // namespace

Material read_constants(const Constants& constants, const Material& otherwise) {
  Material material = otherwise;
  const Options& table = constants.table;
  const bool orthotropic = table.has("orthotropic");
  if (orthotropic) {
    refuse_both_kinds(constants);
    material.orthotropic = read_orthotropic(constants, otherwise);
  } else {
    read_isotropic(constants, material);
  }
  if (const std::string flaw = material.flaw(constants.dimension); !flaw.empty()) {
    const char* key = orthotropic ? "orthotropic" : "poisson";
    throw InputError(table.has(key) ? table.at(key).source : table.values().source,
                     orthotropic ? fmt::format("'orthotropic' of {}: {}", constants.owner, flaw) : flaw);
  }
  return material;
}

OptionSchema material_fields() {
  Option young = modulus("young", "Young's modulus E"), poisson = poisson_option();
  young.default_value = 1.0;
  poisson.default_value = 0.3;
  return {
      young,
      poisson,
      {.name = "plane",
       .type = OptionType::text,
       .default_value = "stress",
       .choices = {"stress", "strain"},
       .help = "plane stress or plane strain, of bodies in the plane"},
      orthotropic_option(),
      {.name = "regions",
       .type = OptionType::table_list,
       .default_text = "none: the same everywhere",
       .help =
           "parts of another material, in order: where several overlap the last counts. Each has one shape and what "
           "differs from the body",
       .fields = region_fields()},
  };
}

}  // namespace nodal::elastic
