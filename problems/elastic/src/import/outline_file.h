// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Outlines in files: a POLYGON in WKT (OGC 06-103r4, 7.2) and a Polygon in GeoJSON (RFC 7946).
///
/// Both list rings, the outline first, and each ring ends with its first point again: a ring that doesn't is refused as
/// open. Coordinates are metres. A multi-polygon, or a collection, of a single polygon is that polygon; several, and
/// what else these formats can hold, are refused; of a GeoJSON collection of several features one is taken by its name,
/// which is `name` of its properties or its `id`. A z that is the same for all points is left out, as is the SRID in
/// front of a WKT, which FileOutline::remarks tells; several z, and measures (M), are refused.
///
/// WKT is read here and not by Boost.Geometry's read_wkt, because 1.74 refuses a line break between numbers, takes
/// "1 0 6" for the two points (1, 0) and (6, 0) and "1" for (1, 0), and knows no lines. GeoJSON is JSON as parse_json
/// reads it.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/elastic/point.h>
#include <nodal/error.h>
#include <nodal/input_files.h>
#include <nodal/value.h>

namespace nodal::elastic {

/// Rings as they stand in a file, the closing point included, and where they begin; checked_body takes them.
struct FileOutline {
  std::vector<plane::Ring> rings;
  Source source;
  std::vector<std::string> remarks = {};  ///< what was left out
};

/// InputError with `name` and the line for anything but one POLYGON with closed rings, alone, in a MULTIPOLYGON or in a
/// GEOMETRYCOLLECTION. Keywords in any case; "SRID=n;" in front, a semicolon behind and quotes around it are skipped.
[[nodiscard]] FileOutline parse_wkt(std::string_view text, const std::string& name);

/// InputError with `name` and the line for anything but a Polygon or a MultiPolygon of one, a Feature with such, or a
/// collection that holds exactly one of these, or one of that name, where a feature is asked for. Refusal where there
/// is no feature of that name, or several.
[[nodiscard]] FileOutline parse_geojson(std::string_view text, const std::string& name,
                                        const std::optional<std::string>& feature = {});

/// By its extension: .wkt, or .geojson and .json. InputError with the path for another, or for a file that can't be
/// read. Refusal as parse_geojson, and for a feature of a .wkt, which has none.
[[nodiscard]] FileOutline read_outline_file(InputFiles& files, const std::filesystem::path& path,
                                            const std::optional<std::string>& feature = {});

/// Of the file that an option names, and the feature that another does, if there is one. InputError at the options'
/// places, too.
[[nodiscard]] FileOutline read_named_outline(InputFiles& files, const Value& file, const Value* feature);

}  // namespace nodal::elastic
