// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/read_material.h"

#include <algorithm>

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/shown.h>

#include "geometry/plane/outline_check.h"
#include "import/outline_file.h"
#include "material/region_parts.h"
#include "read/material_options.h"

namespace nodal::elastic {

namespace {

constexpr const char* kShapes = "half_plane, box, polygon, feature or file";

// What a region is read with.
struct RegionReader {
  const Options& problem;
  const ProblemContext& context;
  const Body& body;

  [[nodiscard]] bool in_space() const { return body.box.has_value(); }
};

std::vector<const char*> shapes_in(const Options& region) {
  std::vector<const char*> shapes;
  for (const char* key : {"half_plane", "box", "polygon", "feature", "file"})
    if (region.has(key)) shapes.push_back(key);
  if (region.has("feature") && region.has("file"))
    std::erase(shapes, std::string_view("file"));  // one shape by two keys
  return shapes;
}

// The one shape, of a kind that the body's regions have.
const char* shape_of(const Options& region, const std::string& name, bool in_space) {
  const std::vector<const char*> shapes = shapes_in(region);
  if (shapes.empty())
    throw InputError(region.values().source,
                     fmt::format("region '{}' has no shape; give it {}", name, in_space ? "a box" : kShapes));
  if (shapes.size() > 1)
    throw InputError(region.at(shapes[1]).source,
                     fmt::format("region '{}' has two shapes, '{}' and '{}'; give it one", name, shapes[0], shapes[1]));
  if (in_space && shapes[0] != std::string_view("box"))
    throw InputError(
        region.at(shapes[0]).source,
        fmt::format("region '{}': '{}' is a shape in the plane; in space regions are boxes, box = [x0, y0, "
                    "z0, x1, y1, z1]",
                    name, shapes[0]));
  return shapes[0];
}

HalfPlane read_half_plane(const Options& half, const std::string& name) {
  const std::vector<double> point = half.numbers("point"), towards = half.numbers("towards");
  if (towards[0] == 0.0 && towards[1] == 0.0)
    throw InputError(
        half.at("towards").source,
        fmt::format("region '{}': 'towards' is [0, 0], which has no direction; [1, 0] is to the right", name));
  return {{point[0], point[1]}, {towards[0], towards[1]}};
}

Extent read_box(const Value& option, const std::string& name, bool in_space) {
  const std::size_t dimension = in_space ? 3 : 2;
  const std::vector<double> numbers = option.numbers();
  if (numbers.size() != 2 * dimension)
    throw InputError(option.source, fmt::format("region '{}': 'box' has {} numbers; in {}", name, numbers.size(),
                                                in_space ? "space it has six, [x0, y0, z0, x1, y1, z1]"
                                                         : "the plane it has four, [x0, y0, x1, y1]"));
  Extent box;
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    box.low[axis] = numbers[axis];
    box.high[axis] = numbers[dimension + axis];
    if (!(box.low[axis] < box.high[axis]))
      throw InputError(option.source,
                       fmt::format("region '{}': 'box' reaches from {} to {} along {}; the lower corner comes first",
                                   name, box.low[axis], box.high[axis], kAxisNames[axis]));
  }
  return box;
}

PolygonShape checked_polygon(std::vector<plane::Ring> rings, double scale, const std::string& name,
                             const Source& source) {
  for (plane::Ring& ring : rings)
    for (plane::Point& p : ring) p = {p[0] * scale, p[1] * scale};
  return PolygonShape(plane::checked_body(std::move(rings), name, 1.0, kDefaultCornerTurn, source).rings);
}

double scale_in(const Options& table) { return table.has("scale") ? table.number("scale") : 1.0; }

PolygonShape read_polygon(const Options& region, const std::string& name) {
  plane::Ring ring;
  for (const std::vector<double>& vertex : region.vectors("polygon")) ring.push_back({vertex[0], vertex[1]});
  return checked_polygon({std::move(ring)}, scale_in(region), name, region.at("polygon").source);
}

// Of the region's own file, or of the body's.
PolygonShape read_feature(const RegionReader& reader, const Options& region, const std::string& name) {
  const Options body = reader.problem.table("body");
  const bool own = region.has("file");
  if (!own && !body.has("file"))
    throw InputError(
        region.at("feature").source,
        fmt::format("region '{}': the body has no file in which there could be a feature '{}'; name one by "
                    "'file'",
                    name, shown(region.text("feature"))));
  const FileOutline outline = read_named_outline(reader.context.files, own ? region.at("file") : body.at("file"),
                                                 region.has("feature") ? &region.at("feature") : nullptr);
  return checked_polygon(outline.rings, scale_in(own ? region : body), name, outline.source);
}

RegionShape read_shape(const RegionReader& reader, const Options& region, const std::string& name) {
  const std::string_view shape = shape_of(region, name, reader.in_space());
  if (region.has("scale") && shape != "polygon" && !region.has("file"))
    throw InputError(region.at("scale").source,
                     fmt::format("region '{}': 'scale' belongs to 'polygon' and 'file'; what is of the body's file has "
                                 "the body's",
                                 name));
  if (shape == "half_plane") return read_half_plane(region.table("half_plane"), name);
  if (shape == "box") return read_box(region.at("box"), name, reader.in_space());
  if (shape == "polygon") return read_polygon(region, name);
  return read_feature(reader, region, name);
}

// The body's name is taken, since explanations call what no region covers so.
std::string name_of(const Options& region, std::size_t number, const MaterialField& before) {
  const bool given = region.has("name");
  std::string name = given                   ? region.text("name")
                     : region.has("feature") ? region.text("feature")
                                             : fmt::format("region {}", number);
  const bool taken = name == before.name_of(kBodyRegion) || std::ranges::count(before.regions, name, &Region::name) > 0;
  if (name.empty() || taken)
    throw InputError(region.at(given                   ? "name"
                               : region.has("feature") ? "feature"
                                                       : "box")
                         .source,
                     name.empty() ? "a region's name is empty; leave it out, or give one"
                                  : fmt::format("there is a '{}' already; give this region another name", shown(name)));
  return name;
}

Region read_region(const RegionReader& reader, const Options& table, const MaterialField& before) {
  const std::string name = name_of(table, before.regions.size() + 1, before), quoted = shown(name);
  Region region{name, read_shape(reader, table, quoted),
                read_constants({table, fmt::format("region '{}'", quoted), reader.body.dimension()}, before.base)};
  if (table.has("density")) {
    if (reader.problem.table("masses").text("form") == "none")
      throw InputError(
          table.at("density").source,
          fmt::format("region '{}': 'density' belongs to masses, and this study has none; take masses = {{ "
                      "form = \"least-norm\" }}, or leave it out",
                      quoted));
    region.density = table.number("density");
  }
  if (!table.has("thickness")) return region;
  if (reader.in_space())
    throw InputError(table.at("thickness").source,
                     fmt::format("region '{}': 'thickness' belongs to bodies in the plane, not to a box", quoted));
  if (table.number("thickness") != reader.body.thickness) region.thickness = table.number("thickness");
  return region;
}

// A region that changes nothing was meant to.
void require_part(const MaterialField& field, std::size_t region, const Options& table, const Body& body) {
  if (field.counts(region)) return;
  MaterialField alone = field;
  alone.regions = {field.regions[region - 1]};
  const bool covers = region_shares(alone, body)[1] > 0.0;
  const std::string name = shown(field.regions[region - 1].name);
  throw InputError(table.values().source,
                   covers ? fmt::format("region '{}' is hidden by later ones, and so changes nothing; of regions that "
                                        "overlap the last counts: list it behind them, or leave it out",
                                        name)
                          : fmt::format("region '{}' covers nothing of the body ({}); mend its shape, or leave it out",
                                        name, body.name));
}

void read_regions(const RegionReader& reader, const Options& material, MaterialField& field) {
  if (!reader.body.box && !reader.body.has_outline())
    throw InputError(material.at("regions").source,
                     "regions need a body with an outline, and this one has none; describe it, as by body = { size = "
                     "[4, 4] }");
  const std::vector<Options> tables = material.tables("regions");
  for (const Options& table : tables) field.regions.push_back(read_region(reader, table, field));
  field.shares = region_shares(field, reader.body);
  for (std::size_t k = 0; k < tables.size(); ++k) require_part(field, k + 1, tables[k], reader.body);
}

}  // namespace

MaterialField read_material(const Options& problem, const ProblemContext& context, const Body& body, Account& account) {
  const Options table = problem.table("material");
  if (body.box && table.given("plane"))
    throw InputError(table.at("plane").source, "'plane' belongs to bodies in the plane, not to a box");
  Material base;
  base.plane = table.text("plane") == "stress" ? Plane::stress : Plane::strain;
  MaterialField field = read_constants({table, "the body", body.dimension()}, base);
  field.tolerance = kPlaceRounding * extent_of(body).size();
  if (table.has("regions")) read_regions({problem, context, body}, table, field);
  if (body.box || body.has_outline() || problem.given("material")) tell_of_material(field, body, account);
  return field;
}

}  // namespace nodal::elastic
