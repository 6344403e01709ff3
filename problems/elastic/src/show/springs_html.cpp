// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/springs_html.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <nodal/show/html.h>
#include <nodal/show/number_text.h>
#include <nodal/value.h>

#include "show/panels.h"

namespace nodal::elastic::show {

namespace {

constexpr double kPanel = 170.0;  // drawing units: many stand beside each other

// Softer than in the first system, alike, stiffer: blue over grey to red, told apart without red or green.
constexpr std::array<const char*, 7> kChangeColours = {"#2166ac", "#4393c3", "#92c5de", "#b0b0b0",
                                                       "#f4a582", "#d6604d", "#b2182b"};
constexpr std::array<double, 3> kLimits = {1.02, 1.25, 2.0};  // of the ratio: alike below the first

std::size_t colour_of(const PicturedSpring& spring, const PicturedSpring& first) {
  const double a = spring.stiffness, b = first.stiffness;
  if (!(a > 0.0 && b > 0.0)) return 3;
  const auto away = static_cast<std::size_t>(
      std::ranges::count_if(kLimits, [ratio = std::max(a / b, b / a)](double limit) { return ratio > limit; }));
  return a < b ? 3 - away : 3 + away;
}

std::vector<std::array<Point, 2>> spring_places(const Picture& picture, double width) {
  const Frame frame = system_frame(picture, width);
  std::vector<std::array<Point, 2>> places;
  for (const PicturedSpring& s : picture.springs)
    places.push_back({frame.at(picture.nodes[s.first]), frame.at(picture.nodes[s.second])});
  return places;
}

std::string difference_svg(const Picture& picture, const Picture& first) {
  const Frame frame = system_frame(picture, kPanel);
  const std::vector<std::array<Point, 2>> places = spring_places(picture, kPanel);
  std::array<std::string, kChangeColours.size()> paths;
  for (std::size_t e = 0; e < places.size(); ++e)
    paths[colour_of(picture.springs[e], first.springs[e])] += move_to(places[e][0]) + line_to(places[e][1]);
  std::string text = fmt::format(
      "<svg class=\"plate difference\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"each spring of {} "
      "against "
      "{}\"><g stroke-width=\"{:.2f}\">",
      frame.width, std::ceil(frame.height), escape_xml(picture.title), escape_xml(first.title), frame.line_width());
  for (std::size_t i = 0; i < paths.size(); ++i)
    if (!paths[i].empty()) text += fmt::format("<path stroke=\"{}\" d=\"{}\"/>", kChangeColours[i], paths[i]);
  return text + "</g></svg>";
}

std::string figures(std::span<const Picture> pictures, const StiffnessColours& colours) {
  std::string text = "<div class=\"bests\">\n";
  for (std::size_t i = 1; i < pictures.size(); ++i)
    text += fmt::format(
        "<figure data-system=\"{}\">{}{}<figcaption>{}<br><small>relative error {}</small></figcaption></figure>\n", i,
        system_svg(pictures[i], kPanel, colours), difference_svg(pictures[i], pictures.front()),
        escape_html(pictures[i].title), figure_text(pictures[i].relative_error, 4));
  return text + "</div>\n";
}

std::string legend(const std::string& first) {
  std::string text =
      "<p class=\"note\">Left: the system in the colours of its stiffnesses, on the scale above; what is softer or "
      "stiffer "
      "than any spring there has the colour of that end. Right: each spring against that of the " +
      escape_html(first) + ":";
  constexpr std::array<const char*, 7> kWords = {
      "less than half as stiff,", "down to half,", "softer by up to 20 %,",    "alike within 2 %,",
      "stiffer by up to 25 %,",   "up to twice,",  "more than twice as stiff."};
  for (std::size_t i = 0; i < kWords.size(); ++i)
    text += fmt::format("<span class=\"swatch\" style=\"background:{}\"></span>{} ", kChangeColours[i], kWords[i]);
  return text + "</p>\n";
}

std::string table(std::span<const Picture> pictures) {
  std::string text =
      "<details><summary>The stiffness of every spring</summary>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
      "aria-label=\"Stiffness of every spring\"><table class=\"stiffnesses\"><caption>Stiffnesses in N/m, springs by "
      "their nodes</caption><thead><tr><th scope=\"col\" class=\"label\">spring</th>";
  for (const Picture& picture : pictures) text += "<th scope=\"col\">" + escape_html(picture.title) + "</th>";
  text += "</tr></thead><tbody>\n";
  for (std::size_t e = 0; e < pictures.front().springs.size(); ++e) {
    const PicturedSpring& s = pictures.front().springs[e];
    text += fmt::format("<tr><th scope=\"row\">{}–{}</th>", s.first, s.second);
    for (const Picture& picture : pictures) text += "<td>" + figure_text(picture.springs[e].stiffness, 3) + "</td>";
    text += "</tr>\n";
  }
  return text + "</tbody></table></div></details>\n";
}

// {nodes: [[i, j], …], places: [[x, y, x, y], …] of kPanel, width, systems: [{label, stiffness}]}
std::string data(std::span<const Picture> pictures) {
  Value::List nodes, places, systems;
  for (const PicturedSpring& s : pictures.front().springs)
    nodes.emplace_back(
        Value::List{Value(static_cast<std::int64_t>(s.first)), Value(static_cast<std::int64_t>(s.second))});
  for (const auto& [a, b] : spring_places(pictures.front(), kPanel))
    places.emplace_back(Value::List{rounded(a[0], 4), rounded(a[1], 4), rounded(b[0], 4), rounded(b[1], 4)});
  for (const Picture& picture : pictures) {
    Value::List stiffness;
    for (const PicturedSpring& s : picture.springs) stiffness.emplace_back(rounded(s.stiffness, 4));
    systems.emplace_back(Value::Table{{"label", picture.title}, {"stiffness", std::move(stiffness)}});
  }
  const Value all = Value::Table{
      {"nodes", std::move(nodes)}, {"places", std::move(places)}, {"width", kPanel}, {"systems", std::move(systems)}};
  return "<script type=\"application/json\" class=\"springs-data\">" + escape_script(to_json(all)) + "</script>\n";
}

}  // namespace

std::string springs_html(std::span<const Picture> pictures, const StiffnessColours& colours) {
  if (pictures.size() < 2 || pictures.front().springs.size() > kMostToldSprings) return {};
  return "<h3>Spring by spring</h3>\n" + figures(pictures, colours) + legend(pictures.front().title) +
         "<p class=\"note scripted-springs\" hidden>Point at a spring for its stiffness; with the keyboard, choose a "
         "picture and go through its springs by the arrow keys.</p>\n" +
         table(pictures) + data(pictures);
}

}  // namespace nodal::elastic::show
