// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/outline_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "../../../support/messages.h"
#include "../../../support/temporary_directory.h"
#include "read/body_options.h"

namespace nodal::elastic {
namespace {

using toy::message_of;

const std::vector<plane::Ring> kSquareWithHole = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}},
                                                  {{1, 1}, {1, 2}, {2, 1}, {1, 1}}};

// ── WKT
// ────────────────────────────────────────────────────────────────────────────────────────────────────────────────

std::string wkt_refusal(std::string_view text) {
  return message_of([&] { (void)parse_wkt(text, "a.wkt"); });
}

TEST(Wkt, IsReadWithItsHoles) {
  EXPECT_EQ(parse_wkt("POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 2,2 1,1 1))", "a").rings, kSquareWithHole);
  const FileOutline spread = parse_wkt(
      "\xEF\xBB\xBF\r\n  polygon (\r\n(0 0.0,\n4e0\t0 , +4 40e-1,\n 0 4,-0 0 ) ,\n(1 1,1 2,2 1,1 1)\n)\n\n", "a.wkt");
  EXPECT_EQ(spread.rings, kSquareWithHole);
  EXPECT_EQ(spread.source.text(), "a.wkt:2");
}

TEST(Wkt, OfAnotherTypeIsRefused) {
  const std::string wanted = "; an outline is POLYGON ((x y, x y, …, x y), …), with the first point again at the end";
  EXPECT_EQ(wkt_refusal(""), "a.wkt:1: the file is empty" + wanted);
  EXPECT_EQ(wkt_refusal("\n\nMULTIPOINT(0 0,1 0)"), "a.wkt:3: 'MULTIPOINT' is no POLYGON" + wanted);
  EXPECT_EQ(wkt_refusal("CURVEPOLYGON(CIRCULARSTRING(0 0,4 0,4 4,0 4,0 0))"),
            "a.wkt:1: 'CURVEPOLYGON' is no POLYGON" + wanted);
  EXPECT_EQ(wkt_refusal(std::string(1'000'000, '0')),
            "a.wkt:1: '" + std::string(60, '0') + "…' is no POLYGON" + wanted);
  EXPECT_EQ(wkt_refusal("POLYGON empty"), "a.wkt:1: the polygon is EMPTY" + wanted);
  EXPECT_EQ(wkt_refusal("POLYGON ZM ((0 0 1 2,1 0 1 2,1 1 1 2,0 0 1 2))"),
            "a.wkt:1: the polygon has measures, 'ZM', beside its coordinates; a plane body has x and y only");
}

TEST(Wkt, IsReadInTheWrappingsOfOtherPrograms) {
  const std::string rings = "((0 0,4 0,4 4,0 4,0 0),(1 1,1 2,2 1,1 1))";
  for (const std::string& text : {"POLYGON" + rings + ";", "\"POLYGON" + rings + "\"", "\n'POLYGON" + rings + ";'\n",
                                  "MULTIPOLYGON(" + rings + ")", "GeometryCollection (Polygon " + rings + ")",
                                  "GEOMETRYCOLLECTION(MULTIPOLYGON(" + rings + "));"}) {
    const FileOutline outline = parse_wkt(text, "a.wkt");
    EXPECT_EQ(outline.rings, kSquareWithHole) << text;
    EXPECT_TRUE(outline.remarks.empty()) << text;
  }
  for (const std::string& text : {"SRID=4326;POLYGON" + rings, "srid=4326; MULTIPOLYGON (" + rings + ")"}) {
    const FileOutline outline = parse_wkt(text, "a.wkt");
    EXPECT_EQ(outline.rings, kSquareWithHole) << text;
    EXPECT_EQ(outline.remarks,
              (std::vector<std::string>{"a.wkt: SRID 4326 is left out, coordinates are taken for metres"}));
  }
  EXPECT_EQ(wkt_refusal("MULTIPOLYGON(((0 0,1 0,1 1,0 0)),\n((2 0,3 0,3 1,2 0)))"),
            "a.wkt:1: there is more than one polygon; a body is one: give each a file of its own");
  EXPECT_EQ(wkt_refusal("SRID=4326 POLYGON((0 0,1 0,1 1,0 0))"),
            "a.wkt:1: 'SRID=4326' must end with a semicolon: SRID=4326;POLYGON…");
  for (const char* text : {"SRID=1;", "SRID=1; \n", "\"SRID=1;\""})
    EXPECT_EQ(wkt_refusal(text),
              "a.wkt:1: nothing follows 'SRID=1;'; an outline is POLYGON ((x y, x y, …, x y), …), with the first point "
              "again at the end");
}

TEST(Wkt, LeavesOutAHeightThatIsTheSameEverywhere) {
  for (const char* type : {"POLYGON Z ", "POLYGONZ", "polygon z", "POLYGON"}) {
    const FileOutline outline =
        parse_wkt(std::string(type) + "((0 0 5,4 0 5,4 4 5.0,0 4 5,0 0 5),(1 1 5,1 2 5,2 1 5,1 1 5))", "folder/a.wkt");
    EXPECT_EQ(outline.rings, kSquareWithHole) << type;
    EXPECT_EQ(outline.remarks, (std::vector<std::string>{"a.wkt: z, 5 everywhere, is left out"})) << type;
  }
  EXPECT_EQ(wkt_refusal("POLYGON Z ((0 0 1,1 0 1,\n1 1 2,0 0 1))"),
            "a.wkt:2: z is 2 here and 1 before: a plane system has one z; give x and y in its plane");
  EXPECT_EQ(wkt_refusal("POLYGON Z ((0 0,1 0,1 1,0 0))"),
            "a.wkt:1: ',' is no finite number; a point is x and y, points are separated by commas");
}

// Each of these but the last two Boost 1.74 reads as another polygon.
TEST(Wkt, ThatIsMalformedIsRefusedWithTheLine) {
  const std::string wanted = "; an outline is POLYGON ((x y, x y, …, x y), …), with the first point again at the end";
  const std::string points = "; a point is x and y, points are separated by commas";
  EXPECT_EQ(wkt_refusal("POLYGON((0 0,1 0,\n1 1 5,0 0))"), "a.wkt:2: '5' follows the point (1, 1)" + points);
  EXPECT_EQ(wkt_refusal("POLYGON((0 0,1,1 1,0 0))"), "a.wkt:1: ',' is no finite number" + points);
  EXPECT_EQ(wkt_refusal("POLYGON((0 0,1 0,,1 1,0 0))"), "a.wkt:1: ',' is no finite number" + points);
  EXPECT_EQ(wkt_refusal("POLYGON((0 0,1 0,1 1,0 0),)"), "a.wkt:1: ')' stands where '(' is missing" + wanted);
  EXPECT_EQ(wkt_refusal("POLYGON((0 0,1 0,1 1,0 0)(0 0,1 0,1 1,0 0))"),
            "a.wkt:1: '(' stands where ')' is missing" + wanted);
  EXPECT_EQ(wkt_refusal("POLYGON(())"), "a.wkt:1: the outline has no points; leave it out or give at least 3");
  EXPECT_EQ(wkt_refusal("POLYGON((0 0,1 0,1 1,0 0)\n"), "a.wkt:1: the text ends where ')' is missing" + wanted);
  EXPECT_EQ(wkt_refusal("POLYGON((0 0,1 0,1 1,0 0))\nPOLYGON((0 0,1 0,1 1,0 0))"),
            "a.wkt:2: 'POLYGON' follows the polygon; one polygon is all that may stand here");
}

TEST(Wkt, TakesFiniteNumbersOnly) {
  const std::string points = "; a point is x and y, points are separated by commas";
  for (const char* word : {"nan", "inf", "-inf", "x", "1x", "0x10", "++1", "+-1", "-", "1..2"})
    EXPECT_EQ(wkt_refusal(std::string("POLYGON((0 ") + word + ",1 0,1 1,0 0))"),
              std::string("a.wkt:1: '") + word + "' is no finite number" + points);
  EXPECT_EQ(wkt_refusal("POLYGON((0 1e400,1 0,1 1,0 0))"), "a.wkt:1: '1e400' is out of the range of double precision");
}

TEST(Wkt, ThatIsOpenIsRefusedWithItsEnds) {
  EXPECT_EQ(wkt_refusal("POLYGON((0 0,1 0,\n1 1))"),
            "a.wkt:1: the outline is open: it begins at (0, 0) and ends at (1, 1); repeat the first point at the end");
  EXPECT_EQ(wkt_refusal("POLYGON((0 0,4 0,4 4,0 0),\n(1 1,2 1,2 2))"),
            "a.wkt:2: hole 1 is open: it begins at (1, 1) and ends at (2, 2); repeat the first point at the end");
}

// ── GeoJSON
// ────────────────────────────────────────────────────────────────────────────────────────────────────────────

std::string geojson_refusal(std::string_view text) {
  return message_of([&] { (void)parse_geojson(text, "a.json"); });
}

const std::string kPolygon =
    R"({"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4.0, 4], [0, 4], [0, 0]], [[1, 1], [1, 2], [2, 1], [1, 1]]]})";

TEST(GeoJson, IsReadBareOrAsAFeature) {
  EXPECT_EQ(parse_geojson(kPolygon, "a").rings, kSquareWithHole);
  const std::string feature = R"({"type": "Feature", "id": 1, "properties": null, "geometry": )" + kPolygon + "}";
  EXPECT_EQ(parse_geojson(feature, "a").rings, kSquareWithHole);
  const FileOutline collected = parse_geojson(
      "{\"type\": \"FeatureCollection\", \"name\": \"gear\",\n\"features\": [" + feature + "]}", "a.json");
  EXPECT_EQ(collected.rings, kSquareWithHole);
  EXPECT_EQ(collected.source.text(), "a.json:2");
}

TEST(GeoJson, OfAnotherTypeIsRefused) {
  const std::string wanted =
      "; an outline must be a Polygon, a Feature with one, or a FeatureCollection with one such "
      "Feature";
  EXPECT_EQ(geojson_refusal(R"({"type": "LineString", "coordinates": []})"),
            "a.json:1: the type is 'LineString'" + wanted);
  EXPECT_EQ(geojson_refusal("{\"type\": \"Feature\",\n\"geometry\":\n{\"type\": \"Point\", \"coordinates\": [1, 2]}}"),
            "a.json:3: the type is 'Point'" + wanted);
  EXPECT_EQ(geojson_refusal(R"({"type": "Feature", "geometry": null})"),
            "a.json:1: the Feature has no geometry; it must have a Polygon");
  EXPECT_EQ(geojson_refusal(R"({"type": "Feature", "geometry": {"type": "Feature"}})"),
            "a.json:1: the geometry of a Feature must be a Polygon, not another Feature");
  EXPECT_EQ(geojson_refusal(R"({"type": "FeatureCollection", "features": []})"),
            "a.json:1: the FeatureCollection has 0 features; it must have exactly one, with a Polygon");
  EXPECT_EQ(geojson_refusal(R"({"type": "FeatureCollection", "features": [)" + kPolygon + "]}"),
            "a.json:1: the entry of 'features' must be a Feature with a Polygon");
  for (const char* text : {"[1, 2]", "7", "{}", R"({"type": 3})"})
    EXPECT_EQ(geojson_refusal(text),
              "a.json:1: no GeoJSON: an object with a 'type' is missing; give a Polygon, a Feature with one, or a "
              "FeatureCollection with one such Feature");
}

TEST(GeoJson, ThatIsMalformedIsRefusedWithTheLine) {
  const auto polygon = [](const std::string& coordinates) {
    return geojson_refusal("{\"type\": \"Polygon\",\n\"coordinates\": " + coordinates + "}");
  };
  EXPECT_EQ(polygon("[[[0, 0], [1, 0],\n[1], [0, 0]]]"), "a.json:3: a position must be [x, y]");
  EXPECT_EQ(polygon("[[[0, 0], [1, 0],\n[1, \"1\"], [0, 0]]]"), "a.json:3: a position must be [x, y]");
  EXPECT_EQ(polygon("[[[0, 0, 5, 1], [1, 0, 5, 1], [1, 1, 5, 1], [0, 0, 5, 1]]]"),
            "a.json:2: a position has more than three coordinates; a plane body has x and y only");
  EXPECT_EQ(polygon("[3]"), "a.json:2: a Polygon's coordinates must be rings: [[[x, y], …], …]");
  EXPECT_EQ(polygon("3"), "a.json:1: a Polygon must have a list 'coordinates'");
  EXPECT_EQ(polygon("[]"), "a.json:2: the Polygon has no rings; it must have an outline");
  EXPECT_EQ(polygon("[[]]"), "a.json:2: the outline has no points; leave it out or give at least 3");
  EXPECT_EQ(polygon("[[[0, 0], [1, 0],\n[1, null], [0, 0]]]"),
            "a.json:3: null is not a value in a list; leave it out or give one");
}

TEST(GeoJson, OfASinglePolygonIsThatPolygon) {
  const std::string coordinates = kPolygon.substr(kPolygon.find("[[["), kPolygon.size() - 1 - kPolygon.find("[[["));
  const std::string multi = R"({"type": "MultiPolygon", "coordinates": [)" + coordinates + "]}";
  const auto collection = [](const std::string& part) {
    return R"({"type": "GeometryCollection", "geometries": [)" + part + "]}";
  };
  for (const std::string& text : {multi, collection(kPolygon), collection(multi),
                                  R"({"type": "Feature", "geometry": )" + collection(multi) + "}"})
    EXPECT_EQ(parse_geojson(text, "a.json").rings, kSquareWithHole) << text;
  EXPECT_EQ(
      geojson_refusal("{\"type\": \"MultiPolygon\",\n\"coordinates\": [" + coordinates + "," + coordinates + "]}"),
      "a.json:2: the MultiPolygon has 2 polygons; a body is one: give each a file of its own");
  EXPECT_EQ(geojson_refusal(collection(kPolygon + "," + kPolygon)),
            "a.json:1: the GeometryCollection has 2 geometries; it must have exactly one, with a Polygon");
  EXPECT_EQ(geojson_refusal(R"({"type": "MultiPolygon", "coordinates": [3]})"),
            "a.json:1: a MultiPolygon's coordinates must be polygons: [[[[x, y], …], …], …]");
  EXPECT_EQ(geojson_refusal("{\"type\": \"FeatureCollection\",\n\"features\": [null]}"),
            "a.json:2: null is not a value in a list; leave it out or give one");
}

TEST(GeoJson, LeavesOutAHeightThatIsTheSameEverywhere) {
  const auto with = [](const std::string& first, const std::string& others) {
    return "{\"type\": \"Polygon\", \"coordinates\": [[[0, 0" + first + "], [1, 0" + others + "],\n[1, 1" + others +
           "], [0, 0" + first + "]]]}";
  };
  EXPECT_EQ(parse_geojson(with(", 7.5", ", 7.5"), "a.json").remarks,
            (std::vector<std::string>{"a.json: z, 7.5 everywhere, is left out"}));
  EXPECT_EQ(geojson_refusal(with(", 1", ", 2")),
            "a.json:1: z is 2 here and 1 before: a plane system has one z; give x and y in its plane");
  EXPECT_EQ(geojson_refusal(with("", ", 0")),
            "a.json:1: some points have a z and others don't; give x and y only, the system is plane");
}

TEST(GeoJson, ThatIsOpenIsRefusedWithItsEnds) {
  EXPECT_EQ(geojson_refusal("{\"type\": \"Polygon\", \"coordinates\": [\n[[0, 0], [1, 0], [1, 1.5]]]}"),
            "a.json:2: the outline is open: it begins at (0, 0) and ends at (1, 1.5); repeat the first point at the "
            "end");
}

// ── files
// ──────────────────────────────────────────────────────────────────────────────────────────────────────────────

class OutlineFile : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(directory_.path() / name) << text;
    return (directory_.path() / name).string();
  }
  // The body of a study beside the file.
  Body body(const std::string& file) {
    Value options;
    options.set("shape", "file");
    options.set("file", file);
    InputFiles files(directory_.path());
    return read_body(resolve_options(body_fields(), options, "'body'"), {files, {}}, "rectangle");
  }
  std::string refusal(const std::string& file) {
    return message_of([&] { (void)body(file); });
  }

  toy::TemporaryDirectory directory_;
};

TEST_F(OutlineFile, IsReadByItsExtension) {
  write("a.wkt", "POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 2,2 1,1 1))");
  write("A.WKT", "POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 2,2 1,1 1))");
  write("a.json", kPolygon);
  write("a.geojson", kPolygon);
  for (const char* file : {"a.wkt", "A.WKT", "a.json", "a.geojson"}) {
    const Body read = body(file);
    EXPECT_EQ(read.name, file);
    EXPECT_EQ(read.rings, (std::vector<plane::Ring>{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 2}, {2, 1}}}));
    EXPECT_TRUE(read.remarks.empty());
  }
}

TEST_F(OutlineFile, IsScaledAndSaysWhatItLeavesOut) {
  write("mm.wkt", "SRID=0;POLYGON((0 0 1,4000 0 1,4000 4000 1,0 4000 1,0 0 1))");
  Value options;
  options.set("file", "mm.wkt");
  options.set("scale", 0.001);
  InputFiles files(directory_.path());
  const Body read = read_body(resolve_options(body_fields(), options, "'body'"), {files, {}}, "rectangle");
  EXPECT_EQ(read.rings, (std::vector<plane::Ring>{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}));
  EXPECT_EQ(read.remarks, (std::vector<std::string>{"mm.wkt: SRID 0 is left out, coordinates are taken for metres",
                                                    "mm.wkt: z, 1 everywhere, is left out"}));
}

TEST(Polygon, IsScaledWithItsHoles) {
  const auto points = [](std::initializer_list<plane::Point> list) {
    Value::List all;
    for (const plane::Point& p : list) all.emplace_back(Value::List{Value(p[0]), Value(p[1])});
    return Value(all);
  };
  Value options;
  options.set("outline", points({{0, 0}, {4000, 0}, {4000, 3000}}));
  options.set("holes", Value::List{points({{2000, 500}, {2000, 1000}, {2500, 1000}})});
  options.set("scale", 0.001);
  InputFiles files;
  const Body read = read_body(resolve_options(body_fields(), options, "'body'"), {files, {}}, "rectangle");
  EXPECT_EQ(read.rings, (std::vector<plane::Ring>{{{0, 0}, {4, 0}, {4, 3}}, {{2, 0.5}, {2, 1}, {2.5, 1}}}));
  Value rectangle;
  rectangle.set("scale", 2.0);
  EXPECT_NE(message_of([&] {
              (void)read_body(resolve_options(body_fields(), rectangle, "'body'"), {files, {}}, "rectangle");
            }).find("'scale' in 'body' belongs to shape 'polygon', 'file', not to 'rectangle'"),
            std::string::npos);
}

// Six digits of coordinates as large as these would be 10 m.
TEST_F(OutlineFile, ThatCrossesFarFromTheOriginIsToldTheirPlaceWithEnoughDigits) {
  write("utm.wkt",
        "POLYGON((418098.85 4845444.82,418096.55 4845320.86,417939.80 4845319.21,417955.16 "
        "4845315.50,418098.85 4845444.82))");
  EXPECT_NE(refusal("utm.wkt").find("of the outline cross at (417959.513, 4845319.418);"), std::string::npos)
      << refusal("utm.wkt");
}

TEST_F(OutlineFile, OfAnotherKindIsRefused) {
  const std::string path = write("a.shp", "");
  EXPECT_EQ(refusal("a.shp"), path + ": an outline file must end in .wkt, .geojson or .json, not in '.shp'");
}

TEST_F(OutlineFile, ThatCannotBeReadIsRefused) {
  const std::string path = (directory_.path() / "b.wkt").string();
  EXPECT_EQ(refusal("b.wkt"), "cannot read '" + path + "': No such file or directory");
  std::filesystem::create_directory(path);
  EXPECT_TRUE(refusal("b.wkt").starts_with("cannot read outline file '" + path + "': "));
}

TEST_F(OutlineFile, ThatMakesNoBodyIsNamed) {
  const std::string path = write("bow.wkt", "\nPOLYGON((0 0,1 1,1 0,0 1,0 0))");
  EXPECT_EQ(refusal("bow.wkt"), path +
                                    ":2: side 0, (0, 0)–(1, 1), and side 2, (1, 0)–(0, 1), of the outline cross at "
                                    "(0.5, 0.5); the outline may not cross or touch itself");
}

}  // namespace
}  // namespace nodal::elastic
