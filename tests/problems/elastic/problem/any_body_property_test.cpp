// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a study says: it becomes a problem whose start has a value or is refused with a status, or it is refused
// with a message that names the place. Nothing else: no crash, no hang, no other exception, no cost that is no number.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/random.h>

#include "../../../support/temporary_directory.h"
#include "../bodies.h"
#include "../plate.h"
#include "triangulation/triangulation.h"

namespace nodal::elastic {
namespace {

// In each share: four of 2,500 where they take seconds; fewer in a slow build (CMakeLists.txt).
constexpr int kStudies = ANY_BODY_STUDIES;

// A study at random, in the words of a user who may be sensible or not.
class StudyMaker {
 public:
  StudyMaker(std::uint64_t key, const std::filesystem::path& directory) : random_(key), directory_(directory) {}

  std::string study() {
    scale_ = one_in(5) ? power(one_in(4) ? 80.0 : 9.0) : 1.0;
    const std::string body = make_body(), points = make_points();
    return "[study]\nname = \"any\"\n[problem]\nkind = \"elastic\"\n" + body + points + make_springs() + make_rest();
  }

 private:
  // ── draws

  bool one_in(std::size_t n) { return random_.index(n) == 0; }
  double power(double least, double most) { return std::pow(10.0, random_.uniform(least, most)); }
  double power(double most) { return power(-most, most); }
  std::size_t between(std::size_t least, std::size_t most) { return least + random_.index(most - least + 1); }
  double coordinate() { return random_.uniform(-1.0, 1.0); }
  std::string any_of(std::initializer_list<const char*> words) { return words.begin()[random_.index(words.size())]; }
  std::string quoted(std::initializer_list<const char*> words) { return "\"" + any_of(words) + "\""; }
  static std::string table(const std::string& name, const std::vector<std::string>& entries) {
    return fmt::format("{} = {{ {} }}\n", name, fmt::join(entries, ", "));
  }

  // ── bodies

  std::string make_body() {
    std::vector<std::string> body;
    size_ = scale_ * random_.uniform(0.5, 4.0);
    switch (random_.index(6)) {
      case 0:
        rectangle_ = true;
        if (one_in(20)) {
          size_ = 4.0;
          scale_ = 1.0;
          return "";
        }
        slender_ = one_in(3);
        body = {fmt::format("size = [{}, {}]", size_,
                            size_ * (slender_ ? 1.0 / power(0.0, 6.0) : random_.uniform(0.3, 1.0)))};
        break;
      case 1:
        body = {"shape = " + quoted({"disc", "regular"}), fmt::format("radius = {}", size_),
                fmt::format("sides = {}", one_in(4) ? 6 : between(3, 14))};
        if (one_in(3) && body[0].ends_with("r\"")) body.push_back(fmt::format("turn = {}", random_.uniform(-360, 360)));
        break;
      case 2:
        body = {"shape = \"ring\"", fmt::format("radius = {}", size_), fmt::format("sides = {}", between(3, 14)),
                fmt::format("inner_radius = {}",
                            size_ * (one_in(4) ? random_.uniform(0.5, 1.1) : random_.uniform(0.1, 0.5)))};
        break;
      case 3:
      case 4:
        body = star();
        break;
      default:
        body = one_in(8) ? std::vector<std::string>{"shape = \"none\""} : degenerate();
    }
    if (one_in(4)) body.push_back(fmt::format("thickness = {}", power(3.0)));
    if (one_in(5)) body.push_back(fmt::format("corner_turn = {}", random_.uniform(0, 180)));
    return table("body", body);
  }

  std::string text_of(const plane::Ring& ring) {
    std::vector<std::string> points;
    for (const plane::Point& p : ring) points.push_back(fmt::format("[{}, {}]", scale_ * p[0], scale_ * p[1]));
    return fmt::format("[{}]", fmt::join(points, ", "));
  }

  std::vector<std::string> polygon(const std::vector<plane::Ring>& rings) {
    rings_ = rings;
    size_ = scale_ * plane::bounding_box(rings[0]).size();
    std::vector<std::string> holes;
    for (std::size_t r = 1; r < rings.size(); ++r) holes.push_back(text_of(rings[r]));
    std::vector<std::string> body = {"outline = " + text_of(rings[0])};
    if (!holes.empty()) body.push_back(fmt::format("holes = [{}]", fmt::join(holes, ", ")));
    return body;
  }

  // Convex or spiky, slender or not, with and without a hole, one that may reach out of it.
  std::vector<std::string> star() {
    std::vector<plane::Ring> rings = random_star(random_).rings;
    slender_ = one_in(4);
    const double flat = slender_ ? power(5.0) : 1.0, away = one_in(10) ? power(8.0) : 0.0;
    const double reach = one_in(8) ? random_.uniform(0.5, 4.0) : 1.0;
    for (std::size_t r = 0; r < rings.size(); ++r)
      for (plane::Point& p : rings[r])
        p = {(r > 0 ? reach : 1.0) * p[0] + away, flat * (r > 0 ? reach : 1.0) * p[1] - away};
    return polygon(rings);
  }

  std::vector<std::string> degenerate() {
    plane::Ring ring;
    const std::size_t n = between(0, 9);
    const double height = one_in(2) ? 0.0 : power(12.0);
    switch (random_.index(6)) {
      case 0:  // any points
        for (std::size_t i = 0; i < n; ++i) ring.push_back({coordinate(), coordinate()});
        break;
      case 1:  // of a coarse lattice
        for (std::size_t i = 0; i < n; ++i) ring.push_back({double(random_.index(3)), double(random_.index(3))});
        break;
      case 2:  // on a line or nearly
        for (std::size_t i = 0; i < n; ++i) ring.push_back({coordinate(), height * coordinate()});
        break;
      case 3:  // a bow-tie
        ring = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
        break;
      case 4:  // two squares that share a corner, or nearly
        ring = {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1 - height, 1}, {0, 1}};
        break;
      default:  // one point, again and again
        ring.assign(n, {coordinate(), coordinate()});
    }
    if (ring.empty()) return {"outline = []"};
    if (one_in(3)) ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(random_.index(ring.size())), ring.front());
    std::vector<plane::Ring> rings = {ring};
    if (one_in(4)) rings.push_back(ring);
    return polygon(rings);
  }

  // ── points

  // And `layout_topology_`, which joins them.
  std::string make_points() {
    std::vector<std::string> points;
    const double spacing = size_ / random_.uniform(0.8, 5.0);
    switch (random_.index(6)) {
      case 0:
        if (!rectangle_ && !one_in(10)) {
          points = {fmt::format("spacing = {}", spacing)};
          break;
        }
        layout_topology_ = any_of({"single", "alternating", "crossed"});
        points = {fmt::format("counts = [{}, {}]", between(one_in(9) ? 0 : 2, 6), between(2, 6))};
        break;
      case 1:
        layout_topology_ = any_of({"single", "alternating", "crossed"});
        points = {one_in(2) ? fmt::format("spacing = {}", spacing)
                            : fmt::format("cell = [{}, {}]", spacing, spacing * random_.uniform(0.6, 2.0))};
        break;
      case 2:
        layout_topology_ = "triangular";
        points = {"layout = \"triangular\"",
                  fmt::format("spacing = {}", one_in(2) ? spacing : size_ / double(between(1, 5)))};
        break;
      case 3:
      case 4:
        points = scattered();
        break;
      default:
        write_points();
        points = {"file = \"nodes.csv\""};
    }
    return table("points", points);
  }

  std::vector<std::string> scattered() {
    std::vector<std::string> points;
    const bool voronoi = one_in(2);
    points.push_back(voronoi ? "layout = \"voronoi\"" : "layout = \"random\"");
    if (one_in(3)) {
      points.push_back(fmt::format("inner = {}", between(0, 15)));
      // Around a needle, as dense outside as inside are thousands.
      if (slender_ || one_in(2)) points.push_back(fmt::format("border = {}", between(3, 20)));
    } else {
      points.push_back(fmt::format("total = {}", between(3, 40)));
    }
    if (voronoi) points.push_back(fmt::format("iterations = {}", between(0, 4)));
    if (one_in(3)) points.push_back("border_spread = \"at-random\"");
    if (one_in(5))
      points.push_back(fmt::format("density = [{{ at = [{}, {}], radius = {}, factor = {} }}]", coordinate() * size_,
                                   coordinate() * size_, power(2.0) * size_, power(3.0)));
    points.push_back(fmt::format("seed = {}", random_.index(1000)));
    return points;
  }

  // Corners of the outline or none of them; spread, clustered, on a line, on a lattice, doubled.
  void write_points() {
    std::vector<plane::Point> points;
    for (const plane::Ring& ring : rings_)
      if (!one_in(4)) points.insert(points.end(), ring.begin(), ring.end());
    plane::Point low = {-1, -1}, high = {1, 1};
    if (!rings_.empty() && !rings_[0].empty())
      low = plane::bounding_box(rings_[0]).low, high = plane::bounding_box(rings_[0]).high;
    const auto at = [&](double x, double y) {
      return plane::Point{low[0] + x * (high[0] - low[0]), low[1] + y * (high[1] - low[1])};
    };
    const std::size_t n = between(0, 25), kind = random_.index(5);
    const double tiny = std::pow(10.0, random_.uniform(-16.0, -1.0)), x = random_.uniform(), y = random_.uniform();
    for (std::size_t i = 0; i < n; ++i) {
      const double s = random_.uniform(), t = random_.uniform();
      switch (kind) {
        case 0:
          points.push_back(at(s, t));
          break;
        case 1:
          points.push_back(at(x + tiny * s, y + tiny * t));
          break;
        case 2:
          points.push_back(at(s, y * s + (one_in(2) ? tiny * t : 0.0)));
          break;
        case 3:
          points.push_back(at(0.25 * double(i % 5), 0.25 * double(i / 5)));
          break;
        default:
          points.push_back(points.empty() || one_in(2) ? at(s, t) : points[random_.index(points.size())]);
      }
    }
    std::ofstream file(directory_ / "nodes.csv");
    file << "x,y\n";
    for (const plane::Point& p : points) file << fmt::format("{},{}\n", scale_ * p[0], scale_ * p[1]);
  }

  // ── springs and what else there is

  std::string make_springs() {
    std::vector<std::string> springs;
    if (!one_in(3)) {
      const std::string topology =
          any_of({layout_topology_.c_str(), layout_topology_.c_str(), layout_topology_.c_str(), "single", "alternating",
                  "grid", "triangular", "delaunay", "delaunay", "delaunay", "delaunay-flip", "delaunay-flip",
                  "delaunay-flip", "voronoi-neighbours", "voronoi-neighbours", "nearest", "nearest"});
      springs.push_back(fmt::format("topology = \"{}\"", topology));
      if (topology == "nearest") springs.push_back(fmt::format("nearest = {}", between(2, 9)));
    }
    if (one_in(2)) {
      const std::string rule = any_of({"each", "each", "by-direction", "by-direction", "by-length", "by-length",
                                       "symmetric", "symmetric", "uniform", "uniform", "groups"});
      std::string more = "";
      if (rule == "by-direction") more = fmt::format(", direction_tolerance = {}", random_.uniform(0, 90));
      if (rule == "by-length") more = fmt::format(", length_classes = {}", between(1, 9));
      springs.push_back(one_in(2) ? fmt::format("parameters = \"{}\"", rule)
                                  : fmt::format("parameters = {{ rule = \"{}\"{} }}", rule, more));
    }
    const std::string rule = any_of({"paper", "area", "lattice", "energy"});
    if (one_in(3)) {
      springs.push_back(fmt::format("initial = {{ rule = \"{}\", scale = \"best\" }}", rule));
    } else if (one_in(2)) {
      springs.push_back(fmt::format("initial = \"{}\"", rule));
    }
    if (one_in(5)) springs.push_back(fmt::format("bounds = [{}, {}]", power(-8.0, 1.0), power(-1.0, 8.0)));
    return table("springs", springs);
  }

  std::string make_rest() {
    std::string text;
    if (one_in(2))
      text += table("material", {fmt::format("young = {}", one_in(3) ? power(40.0) : power(6.0)),
                                 fmt::format("poisson = {}", random_.uniform(-0.99, 0.4999)),
                                 "plane = " + quoted({"stress", "strain"})});
    if (one_in(2)) {
      std::vector<std::string> masses = {"form = " + quoted({"none", "least-norm", "positive"})};
      if (one_in(2)) masses.push_back(fmt::format("density = {}", power(4.0)));
      if (one_in(4)) masses.push_back(fmt::format("least_share = {}", random_.uniform()));
      text += table("masses", masses);
    }
    text += table("loads", {"supports = " + std::string(one_in(rectangle_ ? 2 : 9) ? "\"edge\"" : "\"minimal\""),
                            fmt::format("stress = {}", one_in(3) ? power(40.0) : random_.uniform(-2.0, 2.0))});
    if (one_in(4))
      text += fmt::format("quality = {{ weights = {{ inner = {}, border = {}, corner = {} }} }}\n", random_.index(3),
                          random_.index(3), random_.index(3));
    if (one_in(3)) text += table("equilibrium", {"method = " + quoted({"auto", "lanes", "simplicial", "supernodal"})});
    return text;
  }

  RandomStream random_;
  const std::filesystem::path& directory_;
  double scale_ = 1.0, size_ = 1.0;  // [m]
  std::string layout_topology_ = "delaunay";
  bool rectangle_ = false, slender_ = false;
  std::vector<plane::Ring> rings_;  // of a polygon, before scaling
};

// The value, its gradient and the refined value at the start: numbers where the status is ok.
std::string evaluate_start(const ElasticProblem& problem) {
  const auto evaluator = problem.make_evaluator();
  const std::vector<double> x(problem.space().start().begin(), problem.space().start().end());
  std::vector<double> gradient(x.size());
  const Evaluation value = evaluator->value_and_gradient(x, gradient);
  const Evaluation audit = evaluator->audit(x);
  for (const Evaluation& e : {value, audit})
    EXPECT_TRUE(!e.ok() || (std::isfinite(e.cost) && e.cost >= 0.0)) << "cost " << e.cost;
  if (!value.ok()) return fmt::format("start: {}", to_string(value.status));
  for (const double slope : gradient) EXPECT_TRUE(std::isfinite(slope)) << "slope " << slope;
  return fmt::format("start: {}", to_string(audit.status));
}

// What becomes of a study: a status, or "refused".
std::string outcome_of(const std::string& study, const std::filesystem::path& path) {
  try {
    return evaluate_start(*as_elastic(parse_study(study, path, components())));
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with(path.parent_path().string())) << error.what();
    return "refused";
  } catch (const std::exception& error) {
    ADD_FAILURE() << "escaped: " << error.what();
    return "escaped";
  }
}

class AnyBody : public testing::TestWithParam<int> {};

TEST_P(AnyBody, HasAValueOrAStatusOrARefusalAndNothingElse) {
  const toy::TemporaryDirectory directory;
  const std::filesystem::path path = directory.path() / "any.toml";
  std::map<std::string, int> outcomes;
  const int first = GetParam() * kStudies;
  for (int key = first; key < first + kStudies && !HasFailure(); ++key) {
    const std::string study = StudyMaker(static_cast<std::uint64_t>(key), directory.path()).study();
    SCOPED_TRACE(fmt::format("study {}:\n{}", key, study));
    ++outcomes[outcome_of(study, path)];
  }
  // Both ends happen often, or these studies would try nothing; a build without CGAL refuses most of them.
  EXPECT_GT(outcomes["start: ok"], kStudies / (triangulation_available() ? 8 : 64));
  EXPECT_GT(outcomes["refused"], kStudies / 8);
  for (const auto& [outcome, times] : outcomes) RecordProperty(outcome, times);
}

INSTANTIATE_TEST_SUITE_P(Shares, AnyBody, testing::Range(0, 4));

}  // namespace
}  // namespace nodal::elastic
