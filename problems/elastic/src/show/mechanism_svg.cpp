// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/mechanism_svg.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include <nodal/show/svg.h>
#include "show/measures.h"
#include "show/picture_frame.h"
#include "show/picture_svg.h"

namespace nodal::elastic::show {

namespace {

constexpr double kHeader = 40.0;
constexpr double kWidth = kPictureWidth - 2.0 * kMargin;
constexpr double kMotionShare = 0.12;     // the longest arrow, as a share of the net
constexpr std::size_t kMostNumbers = 24;  // nodes that have their number beside them
constexpr double kShortestStep = 3.0;

// Places in the drawing, and the step that each node makes there; both zero where it stays.
struct Moved {
  Frame frame;
  std::vector<Point> from, step;
  std::vector<bool> moves;
  std::size_t count = 0;
};

Moved move_nodes(const Mechanism& mechanism) {
  const double most = largest(mechanism.motion);
  std::vector<Point> drawn = mechanism.nodes;
  const double scale = most > 0.0 ? kMotionShare * plane::bounding_box(drawn).size() / most : 0.0;
  for (const Ring& ring : mechanism.rings) drawn.insert(drawn.end(), ring.begin(), ring.end());
  Moved moved;
  for (std::size_t i = 0; i < mechanism.nodes.size(); ++i) {
    const Point &p = mechanism.nodes[i], &u = mechanism.motion[i];
    drawn.push_back({p[0] + scale * u[0], p[1] + scale * u[1]});
    moved.moves.push_back(length(u) > kMovingShare * most);
    moved.count += moved.moves.back() ? 1 : 0;
  }
  moved.frame = fit_frame(plane::bounding_box(drawn), kWidth, 14.0, 0.0);
  for (std::size_t i = 0; i < mechanism.nodes.size(); ++i) {
    moved.from.push_back(moved.frame.at(mechanism.nodes[i]));
    const double unit = moved.moves[i] ? scale * moved.frame.unit : 0.0;
    moved.step.push_back({unit * mechanism.motion[i][0], -unit * mechanism.motion[i][1]});
  }
  return moved;
}

Point after(const Moved& moved, std::size_t i) {
  return {moved.from[i][0] + moved.step[i][0], moved.from[i][1] + moved.step[i][1]};
}

std::string body(const Mechanism& mechanism, const Moved& moved) {
  std::string path;
  for (const Ring& ring : mechanism.rings) {
    Ring drawn;
    for (const Point& vertex : ring) drawn.push_back(moved.frame.at(vertex));
    path += polygon_path(drawn);
  }
  return path.empty() ? path : "<path class=\"material\" d=\"" + path + "\"/>\n";
}

std::string springs(const Mechanism& mechanism, const Moved& moved) {
  LinePath net, gives;
  double total = 0.0;
  for (const auto& [i, j] : mechanism.springs) {
    net.add(i, moved.from[i], j, moved.from[j]);
    if (moved.moves[i] || moved.moves[j]) gives.add(i, after(moved, i), j, after(moved, j));
    total += std::hypot(moved.from[j][0] - moved.from[i][0], moved.from[j][1] - moved.from[i][1]);
  }
  const double spacing = mechanism.springs.empty() ? kWidth : total / static_cast<double>(mechanism.springs.size());
  const double width = std::clamp(0.06 * spacing, 0.4, 1.6);
  std::string text = fmt::format("<path class=\"net\" stroke-width=\"{:.2f}\" d=\"{}\"/>\n", width, net.text());
  return gives.empty() ? text : text + "<path class=\"gives\" d=\"" + gives.text() + "\"/>\n";
}

// A number stands on the side that its arrow doesn't point to.
std::string number_beside(const Moved& moved, std::size_t node) {
  const bool left = moved.step[node][0] > 0.0;
  const Point p = {moved.from[node][0] + (left ? -7.0 : 7.0),
                   moved.from[node][1] + (moved.step[node][1] > 0.0 ? -5.0 : 12.0)};
  return text_at(p, std::to_string(node), "label", left ? Anchor::end : Anchor::start);
}

std::string moving_nodes(const Moved& moved) {
  std::string arrows, dots, numbers;
  for (std::size_t i = 0; i < moved.from.size(); ++i) {
    if (!moved.moves[i]) continue;
    dots += fmt::format("<circle class=\"moving\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>", moved.from[i][0],
                        moved.from[i][1], moved.count > 400 ? 2.0 : 3.5);
    if (length(moved.step[i]) >= kShortestStep) arrows += arrow_path(moved.from[i], moved.step[i]);
    if (moved.count <= kMostNumbers) numbers += number_beside(moved, i);
  }
  if (!arrows.empty()) arrows = "<path class=\"motion\" d=\"" + arrows + "\"/>\n";
  return arrows + dots + numbers + "\n";
}

std::vector<std::string> sentences(const Mechanism& mechanism, const Moved& moved) {
  std::vector<std::string> all;
  if (!mechanism.text.empty()) all.push_back(mechanism.text);
  all.push_back(fmt::format(
      "{} of {} nodes (red) can move along the arrows while no spring changes its length; dashed: where their springs "
      "would be.",
      moved.count, moved.from.size()));
  return all;
}

}  // namespace

std::string mechanism_svg(const Mechanism& mechanism) {
  if (mechanism.motion.size() != mechanism.nodes.size())
    throw std::invalid_argument(
        fmt::format("a mechanism of {} nodes has {} motions", mechanism.nodes.size(), mechanism.motion.size()));
  const Moved moved = move_nodes(mechanism);
  const Drawing words = paragraph(sentences(mechanism, moved), kWidth);
  const auto group = [](double y, const std::string& content) {
    return fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n{}</g>\n", kMargin, y, content);
  };
  return svg_file(mechanism.title, std::ceil(kHeader + moved.frame.height + words.height + kMargin),
                  text_at({kMargin, 28.0}, shortened(mechanism.title, kWidth, 17.0), "head") + "\n" +
                      group(kHeader, body(mechanism, moved) + springs(mechanism, moved) + moving_nodes(moved)) +
                      group(kHeader + moved.frame.height, words.text));
}

}  // namespace nodal::elastic::show
