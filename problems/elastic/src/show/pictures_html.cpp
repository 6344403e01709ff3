// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include <nodal/show/html.h>
#include <nodal/show/number_text.h>
#include "show/panels.h"
#include "show/picture_svg.h"
#include "show/pictures_html.h"
#include "show/springs_html.h"

namespace nodal::elastic::show {

namespace {

constexpr std::size_t kMostColumns = 5;  // the system and the four loads of the paper
constexpr std::size_t kMostRows = 2;     // before and after: of others only the systems are drawn

std::string figure_html(const char* style, const std::string& svg, const std::string& name,
                        const std::string& figures) {
  return fmt::format("<figure{}>{}<figcaption>{}<br><small>{}</small></figcaption></figure>\n", style, svg,
                     escape_html(name), figures);
}

std::string loads_html(const Picture& picture, std::span<const PicturedLoad> loads, const Frame& frame,
                       const StiffnessColours& colours) {
  std::string text;
  for (const PicturedLoad& load : loads) {
    const auto [name, figures] = load_caption(load);
    text += figure_html("", load_svg(picture, load, frame, colours), name, figures);
  }
  return text;
}

std::string row_html(const Picture& picture, const Frame& frame, const StiffnessColours& colours) {
  const std::size_t panels = picture.fitted().size() + 1, columns = std::min(panels, kMostColumns);
  std::string text = fmt::format(
      "<h3>{} <small>G {}, relative error {}</small></h3>\n<div class=\"plates{}\" style=\"--columns:{}\">\n",
      escape_html(picture.title), figure_text(picture.quality, 4), figure_text(picture.relative_error, 4),
      panels % 2 == 1 ? " odd" : "", columns);
  text += figure_html(" class=\"system-figure\"", system_svg(picture, kPanelWidth, colours), "the system",
                      "k<sub>max</sub>/k<sub>min</sub> " + spread_text(picture));
  text += loads_html(picture, picture.fitted(), frame, colours) + "</div>\n";
  if (picture.unseen().empty()) return text;
  return text +
         fmt::format("<h4>{}</h4>\n<div class=\"plates\" style=\"--columns:{}\">\n",
                     escape_html(unseen_heading(picture)), columns) +
         loads_html(picture, picture.unseen(), frame, colours) + "</div>\n";
}

std::string scale_svg(const StiffnessColours& colours) {
  const Drawing scale = colour_scale(colours, kPanelWidth);
  return fmt::format(
      "<svg class=\"plate scale\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"stiffness, {} to {} "
      "N/m\">{}</svg>\n",
      scale.width, scale.height, figure_text(colours.softest(), 3), figure_text(colours.stiffest(), 3), scale.text);
}

}  // namespace

std::string pictures_html(std::span<const Picture> all) {
  if (all.empty()) return {};
  std::vector<const Picture*> pictures;
  for (const Picture& picture : all) pictures.push_back(&picture);
  // The scale is of these alone: an optimizer that went far astray would leave them without a difference of colour.
  pictures.resize(std::min(pictures.size(), kMostRows));
  const StiffnessColours colours(pictures);
  const Frame frame = make_frame(pictures);
  std::string text = "<div class=\"plate-figure\">\n", note;
  for (const Picture* picture : pictures) text += row_html(*picture, frame, colours);
  for (const std::string& sentence : picture_legend(*pictures.front(), frame)) note += escape_html(sentence) + " ";
  note.pop_back();
  return text + "<p class=\"note\">" + note + "</p>\n" + scale_svg(colours) + springs_html(all, colours) + "</div>\n";
}

}  // namespace nodal::elastic::show
