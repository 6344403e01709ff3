// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "html.h"
#include "number_text.h"
#include "plate_svg.h"

namespace nodal::report {

namespace {

// The lines of a large net must be thin to be told apart.
double line_width(const Plate& plate) {
  return plate.springs.size() > 2000 ? 0.4 : plate.springs.size() > 400 ? 0.8 : 1.6;
}

std::string row_html(const Plate& plate, const PlateFrame& frame, const StiffnessColours& colours) {
  std::string text = fmt::format(
      "<h3>{} <small>G {}, relative error {}</small></h3>\n<div class=\"plates\" style=\"--line:{}\">\n",
      escape_html(plate.title), figure_text(plate.quality, 4), figure_text(plate.relative_error, 4), line_width(plate));
  for (const PlateLoad& load : plate.loads)
    text += "<figure>" + panel_svg(plate, load, frame, colours) +
            fmt::format("<figcaption>{}<br><small>G {}</small></figcaption></figure>\n", escape_html(load.name),
                        figure_text(load.quality, 4));
  return text + "</div>\n";
}

std::string colour_legend(const StiffnessColours& colours) {
  std::string bar;
  for (std::size_t step = 0; step < StiffnessColours::kSteps; ++step)
    bar +=
        fmt::format("<rect x=\"{}\" width=\"1.05\" height=\"1\" fill=\"{}\"/>", step, StiffnessColours::colour(step));
  return fmt::format(
      "<p class=\"scale\"><span>{} N/m</span><svg viewBox=\"0 0 {} 1\" preserveAspectRatio=\"none\" "
      "aria-hidden=\"true\">{}</svg><span>{} N/m</span></p>\n",
      figure_text(colours.softest(), 3), StiffnessColours::kSteps, bar, figure_text(colours.stiffest(), 3));
}

}  // namespace

std::string plates_html(const std::vector<const Plate*>& plates) {
  if (plates.empty()) return {};
  const PlateFrame frame = make_frame(plates);
  const StiffnessColours colours(plates);
  std::string text = "<div class=\"plate-figure\">\n";
  for (const Plate* plate : plates) text += row_html(*plate, frame, colours);
  text += fmt::format(
      "<p class=\"note\">Solid: the spring system, coloured by stiffness on a logarithmic scale. Dotted: the body "
      "itself. "
      "Squares are held, arrows are forces. Displacements are drawn {} times their size.</p>\n",
      figure_text(frame.magnification, 1));
  return text + colour_legend(colours) + "</div>\n";
}

}  // namespace nodal::report
