// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "html.h"
#include "number_text.h"
#include "picture_svg.h"
#include "plate_svg.h"

namespace nodal::report {

namespace {

constexpr std::size_t kMostColumns = 5;  // the system and the four loads of the paper

std::string figure_html(const char* style, const std::string& svg, const std::string& name,
                        const std::string& figures) {
  return fmt::format("<figure{}>{}<figcaption>{}<br><small>{}</small></figcaption></figure>\n", style, svg,
                     escape_html(name), figures);
}

std::string row_html(const Plate& plate, const PlateFrame& frame, const StiffnessColours& colours) {
  const std::size_t panels = plate.loads.size() + 1;
  std::string text = fmt::format(
      "<h3>{} <small>G {}, relative error {}</small></h3>\n<div class=\"plates{}\" style=\"--columns:{}\">\n",
      escape_html(plate.title), figure_text(plate.quality, 4), figure_text(plate.relative_error, 4),
      panels % 2 == 1 ? " odd" : "", std::min(panels, kMostColumns));
  text += figure_html(" class=\"system-figure\"", system_svg(plate, kPanelWidth, colours), "the system",
                      "k<sub>max</sub>/k<sub>min</sub> " + spread_text(plate));
  for (const PlateLoad& load : plate.loads)
    text += figure_html("", load_svg(plate, load, frame, colours), load.name, "G " + figure_text(load.quality, 4));
  return text + "</div>\n";
}

std::string scale_svg(const StiffnessColours& colours) {
  const Drawing scale = colour_scale(colours, kPanelWidth);
  return fmt::format(
      "<svg class=\"plate scale\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"stiffness, {} to {} "
      "N/m\">{}</svg>\n",
      scale.width, scale.height, figure_text(colours.softest(), 3), figure_text(colours.stiffest(), 3), scale.text);
}

}  // namespace

std::string plates_html(std::span<const Plate> all) {
  if (all.empty()) return {};
  std::vector<const Plate*> plates;
  for (const Plate& plate : all) plates.push_back(&plate);
  const PlateFrame frame = make_frame(plates);
  const StiffnessColours colours(plates);
  std::string text = "<div class=\"plate-figure\">\n", note;
  for (const Plate* plate : plates) text += row_html(*plate, frame, colours);
  for (const std::string& sentence : picture_legend(*plates.front(), frame)) note += escape_html(sentence) + " ";
  note.pop_back();
  return text + "<p class=\"note\">" + note + "</p>\n" + scale_svg(colours) + "</div>\n";
}

}  // namespace nodal::report
