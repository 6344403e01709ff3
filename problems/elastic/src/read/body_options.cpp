// SPDX-License-Identifier: GPL-3.0-or-later
#include "read/body_options.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>

#include "geometry/plane/outline_check.h"
#include "import/named_file.h"
#include "import/outline_file.h"
#include "import/table_options.h"

namespace nodal::elastic {

namespace {

constexpr std::int64_t kDefaultSides = 64, kMostSides = 100000;

// Which keys belong to which shapes; `shape` belongs to all, `thickness`, `corner_turn` and
// `on_outline` to those in the plane.
struct ShapeKey {
  const char* name;
  std::vector<std::string> shapes;
  std::vector<std::string> needed_by;
};

const std::vector<ShapeKey>& shape_keys() {
  static const std::vector<ShapeKey> keys = {
      {"size", {"rectangle", "box"}, {"box"}},
      {"corner", {"rectangle", "box"}, {}},
      {"radius", {"disc", "ring", "regular"}, {"disc", "ring", "regular"}},
      {"inner_radius", {"ring"}, {"ring"}},
      {"sides", {"disc", "ring", "regular"}, {"regular"}},
      {"turn", {"regular"}, {}},
      {"centre", {"disc", "ring", "regular"}, {}},
      {"outline", {"polygon"}, {"polygon"}},
      {"holes", {"polygon"}, {}},
      {"file", {"file"}, {"file"}},
      {"feature", {"file"}, {}},
      {"scale", {"polygon", "file"}, {}},
  };
  return keys;
}

bool among(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

std::string keys_of(const std::string& shape) {
  std::vector<std::string> keys;
  for (const ShapeKey& key : shape_keys())
    if (among(key.shapes, shape)) keys.push_back(fmt::format("'{}'", key.name));
  return keys.empty() ? fmt::format("'{}' has no keys of its own", shape)
                      : fmt::format("'{}' has {}", shape, fmt::join(keys, ", "));
}

void check_keys(const Options& body, const std::string& shape) {
  for (const ShapeKey& key : shape_keys()) {
    if (body.has(key.name) && !among(key.shapes, shape))
      throw InputError(body.at(key.name).source,
                       fmt::format("'{}' in 'body' belongs to shape '{}', not to '{}'; {}", key.name,
                                   fmt::join(key.shapes, "', '"), shape, keys_of(shape)));
    if (!body.has(key.name) && among(key.needed_by, shape))
      throw InputError(body.values().source,
                       fmt::format("shape '{}' in 'body' needs '{}'; {}", shape, key.name, keys_of(shape)));
  }
}

// The numbers of a place or a size, as many as the shape has axes.
std::vector<double> numbers_of(const Options& body, const char* key, std::size_t count, const std::string& shape) {
  const std::vector<double> numbers = body.numbers(key);
  if (numbers.size() != count)
    throw InputError(body.at(key).source,
                     fmt::format("'{}' has {} entries; shape '{}' needs {}", key, numbers.size(), shape, count));
  return numbers;
}

plane::Point point_or(const Options& body, const char* key, const plane::Point& otherwise) {
  if (!body.has(key)) return otherwise;
  const std::vector<double> numbers = numbers_of(body, key, 2, "rectangle");
  return {numbers[0], numbers[1]};
}

Vector vector_or(const Options& body, const char* key, const Vector& otherwise) {
  if (!body.has(key)) return otherwise;
  const std::vector<double> numbers = numbers_of(body, key, 3, "box");
  return {numbers[0], numbers[1], numbers[2]};
}

double number_or(const Options& body, const char* key, double otherwise) {
  return body.has(key) ? body.number(key) : otherwise;
}

void scale_rings(const Options& body, std::vector<plane::Ring>& rings) {
  const double scale = number_or(body, "scale", 1.0);
  for (plane::Ring& ring : rings)
    for (plane::Point& p : ring) p = {p[0] * scale, p[1] * scale};
}

double radians(double degrees) { return degrees / 180.0 * std::numbers::pi; }

// The shapes that sizes alone define. Refusal for sizes that make none.
Body sized_body(const Options& body, const std::string& shape) {
  if (shape == "rectangle")
    return plane::rectangle_body(point_or(body, "corner", {0.0, 0.0}), point_or(body, "size", {4.0, 4.0}));
  const plane::Point centre = point_or(body, "centre", {0.0, 0.0});
  const double radius = body.number("radius");
  const auto sides = static_cast<std::size_t>(body.has("sides") ? body.integer("sides") : kDefaultSides);
  if (shape == "disc") return plane::disc_body(centre, radius, sides);
  if (shape == "ring") return plane::ring_body(centre, radius, body.number("inner_radius"), sides);
  return plane::regular_body(centre, radius, sides, radians(number_or(body, "turn", 0.0)));
}

// The key that a size which makes no shape is blamed on.
Source source_of_sizes(const Options& body, const std::string& shape) {
  const char* key = shape == "rectangle" ? "size" : shape == "ring" ? "inner_radius" : "radius";
  return body.has(key) ? body.at(key).source : body.values().source;
}

// Each key of some shapes with these in front of its help, and those that need it behind its default.
OptionSchema with_shapes(OptionSchema fields) {
  for (Option& field : fields)
    for (const ShapeKey& key : shape_keys()) {
      if (field.name != key.name) continue;
      field.help = fmt::format("{}: {}", fmt::join(key.shapes, ", "), field.help);
      if (!key.needed_by.empty())
        field.default_text = fmt::format("{}; needed by {}", field.default_text, fmt::join(key.needed_by, ", "));
    }
  return fields;
}

}  // namespace

OptionSchema body_fields() {
  const auto point = [](const char* name, const char* otherwise, const char* help) {
    return Option{.name = name,
                  .type = OptionType::number_list,
                  .default_text = otherwise,
                  .unit = "m",
                  .length = 2,
                  .help = help};
  };
  const auto length = [](const char* name, const char* help) {
    return Option{.name = name,
                  .type = OptionType::number,
                  .default_text = "none",
                  .unit = "m",
                  .minimum = 0.0,
                  .minimum_excluded = true,
                  .help = help};
  };
  Option size = point("size", "[4, 4]", "width and height; of a box also depth: [x, y, z]");
  size.longest = 3;
  Option corner = point("corner", "at the origin", "the lower left; of a box the lowest corner");
  corner.longest = 3;
  size.minimum = 0.0;
  size.minimum_excluded = true;
  Option thickness = length("thickness", "of a body in the plane");
  thickness.default_text = "";
  thickness.default_value = 1.0;
  return with_shapes({
      {.name = "shape",
       .type = OptionType::text,
       .default_text = "by the keys: size makes a rectangle, of three numbers a box, outline a polygon, file a file; "
                       "without any rectangle, or none where "
                       "points come from a file",
       .choices = {"rectangle", "disc", "ring", "regular", "polygon", "file", "none", "box"},
       .help =
           "outline of the body; regular is a regular polygon, none says that only nodes are known; box is a body in "
           "space"},
      size,
      corner,
      length("radius", "from the centre to the vertices; of a ring to the outer ones"),
      length("inner_radius", "of its hole"),
      {.name = "sides",
       .type = OptionType::integer,
       .default_text = std::to_string(kDefaultSides),
       .minimum = 3,
       .maximum = static_cast<double>(kMostSides),
       .help = "of the polygon; of a disc or a ring, of the inscribed ones that its circles are made of"},
      {.name = "turn",
       .type = OptionType::number,
       .default_text = "0",
       .unit = "°",
       .minimum = -360.0,
       .maximum = 360.0,
       .help = "the direction of the first vertex"},
      point("centre", "[0, 0]", "where its middle is"),
      {.name = "outline", .type = OptionType::vector_list, .default_text = "none", .unit = "m", .help = "its vertices"},
      {.name = "holes",
       .type = OptionType::vector_lists,
       .default_text = "none",
       .unit = "m",
       .help = "the vertices of each hole"},
      {.name = "file",
       .type = OptionType::text,
       .default_text = "none",
       .help = "relative to the study: a POLYGON in WKT (.wkt), or a Polygon in GeoJSON (.geojson, .json); metres, "
               "unless 'scale' says otherwise"},
      {.name = "feature",
       .type = OptionType::text,
       .default_text = "the only one",
       .help = "of a GeoJSON collection of several features: 'name' of its properties, or its 'id'"},
      scale_option("its coordinates"),
      thickness,
      {.name = "corner_turn",
       .type = OptionType::number,
       .default_value = 30.0,
       .unit = "°",
       .minimum = 0.0,
       .maximum = 180.0,
       .help = "in the plane: an outline's vertex is a corner where the outline turns by more than this"},
      {.name = "on_outline",
       .type = OptionType::number,
       .default_text = "1e-6; of nodes in a file as much as their digits leave open, up to 1e-5",
       .minimum = kPlaceRounding,
       .maximum = 1e-2,
       .help = "in the plane: a node is on a side, or at a corner, within this share of the body's size"},
  });
}

namespace {

// What is said, or what a key says that belongs to one shape alone: an outline makes a polygon.
std::string shape_of(const Options& body, const std::string& default_shape) {
  if (body.has("shape")) return body.text("shape");
  for (const char* key : {"size", "corner"})  // two numbers or three
    if (body.has(key)) return body.numbers(key).size() == 3 ? "box" : "rectangle";
  for (const ShapeKey& key : shape_keys())
    if (body.has(key.name) && key.shapes.size() == 1) return key.shapes.front();
  return default_shape;
}

plane::Ring ring_of(const std::vector<std::vector<double>>& vertices) {
  plane::Ring ring;
  for (const std::vector<double>& vertex : vertices) ring.push_back({vertex[0], vertex[1]});
  return ring;
}

Body read_rings(const Options& body, const ProblemContext& context, const std::string& shape) {
  check_keys(body, shape);
  if (shape == "box") {
    for (const char* key : {"thickness", "corner_turn", "on_outline"})
      if (body.given(key))
        throw InputError(body.at(key).source, fmt::format("'{}' belongs to bodies in the plane, not to a box", key));
    return at(body.at("size").source,
              [&] { return space::box_body(vector_or(body, "corner", {}), vector_or(body, "size", {})); });
  }
  const double thickness = body.number("thickness"), corner_turn = radians(body.number("corner_turn"));
  if (shape == "none" && body.given("corner_turn"))
    throw InputError(body.at("corner_turn").source,
                     "'corner_turn' belongs to bodies with an outline, and shape 'none' has none");
  if (shape == "none") return {.name = "none", .rings = {}, .thickness = thickness, .corner_turn = corner_turn};
  if (shape == "file") {
    const std::filesystem::path file = body.text("file");
    FileOutline outline =
        read_named_outline(context.files, body.at("file"), body.has("feature") ? &body.at("feature") : nullptr);
    scale_rings(body, outline.rings);
    Body read =
        plane::checked_body(std::move(outline.rings), file.filename().string(), thickness, corner_turn, outline.source);
    read.remarks.insert(read.remarks.begin(), outline.remarks.begin(), outline.remarks.end());
    return read;
  }
  if (shape == "polygon") {
    std::vector<plane::Ring> rings = {ring_of(body.vectors("outline"))};
    if (body.has("holes"))
      for (const auto& hole : body.vector_lists("holes")) rings.push_back(ring_of(hole));
    scale_rings(body, rings);
    const std::size_t holes = rings.size() - 1;
    Body polygon = plane::checked_body(std::move(rings), "polygon", thickness, corner_turn, body.at("outline").source);
    polygon.name = fmt::format("polygon of {} sides", polygon.rings[0].size());
    if (holes > 0) polygon.name += fmt::format(" with {} hole{}", holes, holes == 1 ? "" : "s");
    return polygon;
  }
  const Source source = source_of_sizes(body, shape);
  return at(source, [&] {
    Body sized = sized_body(body, shape);
    return plane::checked_body(std::move(sized.rings), std::move(sized.name), thickness, corner_turn, source);
  });
}

}  // namespace

Body read_body(const Options& body, const ProblemContext& context, const std::string& default_shape) {
  Body read = read_rings(body, context, shape_of(body, default_shape));
  read.on_outline = number_or(body, "on_outline", kOnOutline);
  return read;
}

}  // namespace nodal::elastic
