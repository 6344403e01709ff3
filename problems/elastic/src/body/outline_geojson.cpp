// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/value.h>

#include <fmt/format.h>

#include "body/outline_file.h"
#include "body/ring_closing.h"

namespace nodal::elastic {

namespace {

// The text of `key`, or "" where there is none.
std::string text_of(const Value& object, std::string_view key) {
  const Value* value = object.is_table() ? object.find(key) : nullptr;
  return value && value->is_text() ? value->text() : "";
}

const Value& list_of(const Value& object, const char* key, const char* owner) {
  const Value* value = object.find(key);
  if (!value || !value->is_list())
    throw InputError(object.source, fmt::format("a {} must have a list '{}'", owner, key));
  return *value;
}

// The polygon's geometry object.
const Value& polygon_of(const Value& object) {
  const std::string type = text_of(object, "type");
  if (type == "Polygon") return object;
  if (type == "Feature") {
    const Value* geometry = object.find("geometry");
    if (!geometry) throw InputError(object.source, "the Feature has no geometry; it must have a Polygon");
    if (text_of(*geometry, "type") == "Feature" || text_of(*geometry, "type") == "FeatureCollection")
      throw InputError(geometry->source, "the geometry of a Feature must be a Polygon, not another Feature");
    return polygon_of(*geometry);
  }
  if (type == "FeatureCollection") {
    const Value::List& features = list_of(object, "features", "FeatureCollection").list();
    if (features.size() != 1)
      throw InputError(object.source, fmt::format("the FeatureCollection has {} features; it must have exactly one, "
                                                  "with a Polygon",
                                                  features.size()));
    if (text_of(features[0], "type") != "Feature")
      throw InputError(features[0].source, "the entry of 'features' must be a Feature with a Polygon");
    return polygon_of(features[0]);
  }
  if (type.empty())
    throw InputError(object.source,
                     "no GeoJSON: an object with a 'type' is missing; give a Polygon, a Feature with one, "
                     "or a FeatureCollection with one such Feature");
  throw InputError(object.source,
                   fmt::format("the type is '{}'; an outline must be a Polygon, a Feature with one, or a "
                               "FeatureCollection with one such Feature",
                               type));
}

Point point_of(const Value& position) {
  const bool pair = position.is_list() && position.list().size() == 2 && position.list()[0].is_number() &&
                    position.list()[1].is_number();
  if (!pair)
    throw InputError(position.source, position.is_list() && position.list().size() > 2
                                          ? "a position has more than two coordinates; a plane body has x and y only"
                                          : "a position must be [x, y]");
  return {position.list()[0].number(), position.list()[1].number()};
}

}  // namespace

FileOutline parse_geojson(std::string_view text, const std::string& name) {
  const Value file = parse_json(text, name, JsonNull::left_out);
  const Value& polygon = polygon_of(file);
  const Value& rings = list_of(polygon, "coordinates", "Polygon");
  FileOutline outline;
  outline.source = rings.source;
  for (const Value& positions : rings.list()) {
    if (!positions.is_list())
      throw InputError(positions.source, "a Polygon's coordinates must be rings: [[[x, y], …], …]");
    Ring ring;
    for (const Value& position : positions.list()) ring.push_back(point_of(position));
    require_closed(ring, outline.rings.size(), positions.source);
    outline.rings.push_back(std::move(ring));
  }
  if (outline.rings.empty()) throw InputError(outline.source, "the Polygon has no rings; it must have an outline");
  return outline;
}

}  // namespace nodal::elastic
