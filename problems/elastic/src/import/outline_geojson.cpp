// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include <nodal/error.h>
#include <nodal/shown.h>
#include <nodal/value.h>

#include "import/outline_file.h"
#include "import/ring_closing.h"
#include "import/same_height.h"

namespace nodal::elastic {

namespace {

// The text of `key`, or "" where there is none.
std::string text_of(const Value& object, std::string_view key) {
  return object.is_table() ? object.text_or(key, "") : "";
}

const Value& list_of(const Value& object, const char* key, const char* owner) {
  const Value* value = object.find(key);
  if (!value || !value->is_list())
    throw InputError(object.source, fmt::format("a {} must have a list '{}'", owner, key));
  return *value;
}

// The only entry of a collection.
const Value& single(const Value& object, const char* key, const char* owner) {
  const Value::List& entries = list_of(object, key, owner).list();
  if (entries.size() != 1)
    throw InputError(
        object.source,
        fmt::format(
            "the {} has {} {}; it must have exactly one, with a Polygon{}", owner, entries.size(), key,
            entries.size() > 1 && std::string_view(key) == "features" ? ", or 'feature' must name one of them" : ""));
  return entries[0];
}

// The list of the polygon's rings.
const Value& rings_of(const Value& object) {
  const std::string type = text_of(object, "type");
  if (type == "Polygon") return list_of(object, "coordinates", "Polygon");
  if (type == "MultiPolygon") {
    const Value& polygons = list_of(object, "coordinates", "MultiPolygon");
    if (polygons.list().size() != 1)
      throw InputError(polygons.source,
                       fmt::format("the MultiPolygon has {} polygons; a body is one: give each a file of "
                                   "its own",
                                   polygons.list().size()));
    if (!polygons.list()[0].is_list())
      throw InputError(polygons.source, "a MultiPolygon's coordinates must be polygons: [[[[x, y], …], …], …]");
    return polygons.list()[0];
  }
  if (type == "Feature") {
    const Value* geometry = object.find("geometry");
    if (!geometry) throw InputError(object.source, "the Feature has no geometry; it must have a Polygon");
    if (text_of(*geometry, "type") == "Feature" || text_of(*geometry, "type") == "FeatureCollection")
      throw InputError(geometry->source, "the geometry of a Feature must be a Polygon, not another Feature");
    return rings_of(*geometry);
  }
  if (type == "GeometryCollection") return rings_of(single(object, "geometries", "GeometryCollection"));
  if (type == "FeatureCollection") {
    const Value& feature = single(object, "features", "FeatureCollection");
    if (text_of(feature, "type") != "Feature")
      throw InputError(feature.source, "the entry of 'features' must be a Feature with a Polygon");
    return rings_of(feature);
  }
  if (type.empty())
    throw InputError(object.source,
                     "no GeoJSON: an object with a 'type' is missing; give a Polygon, a Feature with one, "
                     "or a FeatureCollection with one such Feature");
  throw InputError(object.source,
                   fmt::format("the type is '{}'; an outline must be a Polygon, a Feature with one, or a "
                               "FeatureCollection with one such Feature",
                               shown(type)));
}

// One position: x, y and perhaps z.
plane::Point point_of(const Value& position, SameHeight& heights) {
  const bool numbers =
      position.is_list() && std::ranges::all_of(position.list(), [](const Value& x) { return x.is_number(); });
  const std::size_t size = numbers ? position.list().size() : 0;
  if (size < 2) throw InputError(position.source, "a position must be [x, y]");
  if (size > 3)
    throw InputError(position.source, "a position has more than three coordinates; a plane body has x and y only");
  heights.add(size == 3 ? std::optional(position.list()[2].number()) : std::nullopt, position.source);
  return {position.list()[0].number(), position.list()[1].number()};
}

// What a feature is called: `name` of its properties, else its id.
std::string name_of(const Value& feature) {
  const Value* properties = feature.is_table() ? feature.find("properties") : nullptr;
  if (const std::string name = properties ? text_of(*properties, "name") : ""; !name.empty()) return name;
  const Value* id = feature.is_table() ? feature.find("id") : nullptr;
  return !id ? "" : id->is_text() ? id->text() : id->is_integer() ? std::to_string(id->integer()) : "";
}

const Value& feature_of(const Value& file, const std::string& name, const std::string& wanted) {
  static const Value::List kNone;
  const bool collection = text_of(file, "type") == "FeatureCollection";
  const Value::List& features = collection ? list_of(file, "features", "FeatureCollection").list() : kNone;
  std::vector<std::string> names;
  const Value* found = nullptr;
  for (const Value& feature : features) {
    names.push_back(name_of(feature));
    if (names.back() != wanted) continue;
    if (found) throw Refusal(fmt::format("'{}' has two features '{}'", shown(name), shown(wanted)));
    found = &feature;
  }
  if (found) return *found;
  std::erase(names, "");
  throw Refusal(fmt::format(
      "'{}' has no feature '{}'{}", shown(name), shown(wanted),
      names.empty() ? ", and none with a name: properties = {\"name\": …} gives one" : name_hint(wanted, names)));
}

}  // namespace

FileOutline parse_geojson(std::string_view text, const std::string& name, const std::optional<std::string>& feature) {
  const Value file = parse_json(text, name, JsonNull::left_out);
  const Value& rings = rings_of(feature ? feature_of(file, name, *feature) : file);
  FileOutline outline;
  outline.source = rings.source;
  SameHeight heights;
  for (const Value& positions : rings.list()) {
    if (!positions.is_list())
      throw InputError(positions.source, "a Polygon's coordinates must be rings: [[[x, y], …], …]");
    plane::Ring ring;
    for (const Value& position : positions.list()) ring.push_back(point_of(position, heights));
    require_closed(ring, outline.rings.size(), positions.source);
    outline.rings.push_back(std::move(ring));
  }
  if (outline.rings.empty()) throw InputError(outline.source, "the Polygon has no rings; it must have an outline");
  if (const std::string z = heights.left_out(name); !z.empty()) outline.remarks.push_back(z);
  return outline;
}

}  // namespace nodal::elastic
