// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/outline_file.h"

#include <algorithm>

#include <fmt/format.h>

#include <nodal/file.h>

#include "import/named_file.h"
#include "import/ring_closing.h"

namespace nodal::elastic {

void require_closed(const plane::Ring& ring, std::size_t number, const Source& source) {
  const std::string name = number == 0 ? "the outline" : fmt::format("hole {}", number);
  if (ring.empty()) throw InputError(source, name + " has no points; leave it out or give at least 3");
  const plane::Point &first = ring.front(), &last = ring.back();
  if (first != last)
    throw InputError(source, fmt::format("{} is open: it begins at ({}, {}) and ends at ({}, {}); repeat the first "
                                         "point at the end",
                                         name, first[0], first[1], last[0], last[1]));
}

FileOutline read_outline_file(InputFiles& files, const std::filesystem::path& path,
                              const std::optional<std::string>& feature) {
  const std::string extension = extension_of(path);
  const bool wkt = extension == ".wkt";
  if (!wkt && extension != ".geojson" && extension != ".json")
    throw InputError({path.string(), 0}, fmt::format("an outline file must end in .wkt, .geojson or .json, not in '{}'",
                                                     path.extension().string()));
  if (wkt && feature)
    throw Refusal(fmt::format("{} is WKT, whose polygons have no names; features are of GeoJSON", path.string()));
  const std::string& text = files.read(path, "outline file");
  return wkt ? parse_wkt(text, path.string()) : parse_geojson(text, path.string(), feature);
}

FileOutline read_named_outline(InputFiles& files, const Value& file, const Value* feature) {
  const std::filesystem::path path = named_file(files, file);
  if (!feature) return read_outline_file(files, path);
  return at(feature->source, [&] { return read_outline_file(files, path, feature->text()); });
}

}  // namespace nodal::elastic
