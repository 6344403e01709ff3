// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "show/panels.h"

namespace nodal::elastic::show {

namespace {

constexpr double kReferenceSpacing = 9.0;  // between dotted lines, in drawing units: nearer ones would be grey
constexpr double kMarkSpacing = 4.0;       // between nodes, where each has its mark
constexpr double kCross = 2.4;             // half the size of a mark
constexpr double kArrowSpacing = 6.0;      // between the beginnings of arrows
constexpr double kShortestForce = 0.5;     // shorter ones would be a dot

using Link = std::pair<std::size_t, std::size_t>;

std::vector<Point> displaced(const Picture& picture, const std::vector<Point>& by, const Frame& frame) {
  std::vector<Point> places(picture.nodes.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = frame.at(picture.nodes[i], by[i]);
  return places;
}

// Of a grid: springs along its rows and columns, every few of them where they lie close.
std::vector<Link> grid_links(const Picture& picture, const Frame& frame) {
  const std::size_t columns = picture.columns, rows = picture.nodes.size() / columns;
  const double spacing = std::max(frame.spacing, 1e-3);
  const auto step = static_cast<std::size_t>(std::max(1.0, std::ceil(kReferenceSpacing / spacing)));
  const auto shown = [&](std::size_t line, std::size_t lines) { return line % step == 0 || line + 1 == lines; };
  std::vector<Link> links;
  for (const PicturedSpring& s : picture.springs) {
    const bool along_row = s.first / columns == s.second / columns && shown(s.first / columns, rows);
    const bool along_column = s.first % columns == s.second % columns && shown(s.first % columns, columns);
    if (along_row || along_column) links.emplace_back(s.first, s.second);
  }
  return links;
}

// What the body's shape is seen by: a grid's lines, another net's border, or else all springs.
std::vector<Link> reference_links(const Picture& picture, const Frame& frame) {
  if (picture.columns > 0) return grid_links(picture, frame);
  std::vector<Link> links;
  for (const std::vector<std::size_t>& ring : picture.border)
    for (std::size_t i = 0; ring.size() > 1 && i < ring.size(); ++i)
      links.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  if (links.empty())
    for (const PicturedSpring& s : picture.springs) links.emplace_back(s.first, s.second);
  return links;
}

std::string cross_at(const Point& p) {
  return move_to({p[0] - kCross, p[1] - kCross}) + line_to({p[0] + kCross, p[1] + kCross}) +
         move_to({p[0] - kCross, p[1] + kCross}) + line_to({p[0] + kCross, p[1] - kCross});
}

// Where only x or only y is known, the body's point is somewhere on a line; it is drawn beside the system's own.
std::string bar_at(const Point& reference, const Point& own, bool x_known) {
  return x_known ? move_to({reference[0], own[1] - 2.0 * kCross}) + line_to({reference[0], own[1] + 2.0 * kCross})
                 : move_to({own[0] - 2.0 * kCross, reference[1]}) + line_to({own[0] + 2.0 * kCross, reference[1]});
}

// Where the reference is known at some nodes only, these have crosses: they are all there is to compare with.
std::string known_marks(const PicturedLoad& load, const std::vector<Point>& body, const std::vector<Point>& system) {
  if (load.known.empty()) return {};
  std::string path;
  for (std::size_t i = 0; i < body.size(); ++i)
    if (load.knows(i))
      path += cross_at(body[i]);
    else if (load.known[i][0] || load.known[i][1])
      path += bar_at(body[i], system[i], load.known[i][0]);
  return path.empty() ? path : "<path class=\"known\" d=\"" + path + "\"/>";
}

std::string node_marks(const std::vector<Point>& body, const Frame& frame) {
  if (frame.spacing < kMarkSpacing) return {};
  std::string path;
  for (const Point& p : body) path += dot_at(p);
  const double width = std::clamp(0.2 * frame.spacing, 1.0, 2.6);
  return fmt::format("<path class=\"mark\" stroke-width=\"{:.1f}\" d=\"{}\"/>", width, path);
}

std::string reference_lines(const Picture& picture, const PicturedLoad& load, const Frame& frame,
                            const std::vector<Point>& body) {
  LinePath path;
  for (const auto& [i, j] : reference_links(picture, frame))
    if (load.knows(i) && load.knows(j)) path.add(i, body[i], j, body[j]);
  const double width = std::clamp(0.75 * frame.line_width(), 0.8, 1.2);
  std::string text =
      path.empty() ? "" : fmt::format("<path class=\"body\" stroke-width=\"{:.2f}\" d=\"{}\"/>", width, path.text());
  return picture.columns > 0 || !picture.seen.empty() || !load.known.empty() ? text : text + node_marks(body, frame);
}

// Places that are kept apart from each other, so that of many marks in a row some remain, not a bar.
class Apart {
 public:
  explicit Apart(double distance) : distance_(distance) {}
  bool take(const Point& p) {
    const bool free =
        std::ranges::none_of(taken_, [&](const Point& q) { return std::hypot(q[0] - p[0], q[1] - p[1]) < distance_; });
    if (free) taken_.push_back(p);
    return free;
  }

 private:
  double distance_;
  std::vector<Point> taken_;
};

std::string force_arrows(const PicturedLoad& load, const Frame& frame, const std::vector<Point>& system,
                         const std::vector<bool>& drawn) {
  Apart apart(kArrowSpacing);
  std::string path;
  for (std::size_t i = 0; i < load.forces.size(); ++i)
    if (drawn[i] && length(load.forces[i]) * frame.arrow > kShortestForce && apart.take(system[i]))
      path += arrow_path(system[i], {frame.arrow * load.forces[i][0], -frame.arrow * load.forces[i][1]});
  return path.empty() ? "" : "<path class=\"force\" d=\"" + path + "\"/>";
}

std::string support_marks(const PicturedLoad& load, const Frame& frame, const std::vector<Point>& system,
                          const std::vector<bool>& drawn) {
  const double side = frame.spacing > 0.0 ? std::clamp(0.5 * frame.spacing, 2.5, 5.0) : 5.0;
  Apart apart(side + 1.5);
  std::string text;
  for (const std::size_t node : load.fixed)
    if (drawn[node] && apart.take(system[node]))
      text += fmt::format(R"(<rect class="held" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/>)",
                          system[node][0] - 0.5 * side, system[node][1] - 0.5 * side, side, side);
  return text;
}

// [nodes] whether something of the body is between a node and who looks: in space those on no face that is seen.
std::vector<bool> hidden_nodes(const Picture& picture) {
  std::vector<bool> hidden(picture.nodes.size(), !picture.seen.empty());
  for (std::size_t e = 0; e < picture.seen.size(); ++e)
    if (picture.seen[e]) hidden[picture.springs[e].first] = hidden[picture.springs[e].second] = false;
  return hidden;
}

// What pulls and what holds behind the body, or it would look as if it did so on a face that is seen.
std::string marks_behind(const PicturedLoad& load, const Frame& frame, const std::vector<Point>& system,
                         const std::vector<bool>& hidden) {
  const std::string marks = force_arrows(load, frame, system, hidden) + support_marks(load, frame, system, hidden);
  return marks.empty() ? marks : "<g class=\"behind\" opacity=\"0.3\">" + marks + "</g>";
}

}  // namespace

std::string load_panel(const Picture& picture, const PicturedLoad& load, const Frame& frame,
                       const StiffnessColours& colours) {
  const std::vector<Point> system = displaced(picture, load.displacement, frame);
  const std::vector<Point> body = displaced(picture, load.reference, frame);
  const std::vector<bool> hidden = hidden_nodes(picture);
  std::vector<bool> in_front = hidden;
  in_front.flip();
  return marks_behind(load, frame, system, hidden) +
         spring_lines(picture, DrawnSprings(picture, DrawnSprings::kMostUnderLoad), system, frame.line_width(),
                      colours) +
         reference_lines(picture, load, frame, body) + force_arrows(load, frame, system, in_front) +
         known_marks(load, body, system) + support_marks(load, frame, system, in_front);
}

std::string load_svg(const Picture& picture, const PicturedLoad& load, const Frame& frame,
                     const StiffnessColours& colours) {
  return fmt::format("<svg class=\"plate load\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}, {}\">",
                     frame.width, std::ceil(frame.height), escape_xml(load.name), escape_xml(picture.title)) +
         load_panel(picture, load, frame, colours) + "</svg>";
}

}  // namespace nodal::elastic::show
