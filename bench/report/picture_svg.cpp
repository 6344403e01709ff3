// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_svg.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "html.h"
#include "number_text.h"
#include "plate_svg.h"

namespace nodal::report {

namespace {

constexpr double kMargin = 16.0, kGap = 16.0;
constexpr double kInner = kPictureWidth - 2.0 * kMargin;
constexpr double kKeyWidth = 196.0;      // the column beside the system
constexpr double kWideBody = 1.8;        // width over height: beyond, the key stands below the system
constexpr double kFlatBody = 4.0;        // likewise: loads stand one under the other
constexpr double kHeaderHeight = 54.0;   // title and figures
constexpr double kCaptionHeight = 42.0;  // name and G of a load

std::string at(double x, double y, const std::string& content) {
  return fmt::format("<g transform=\"translate({:.1f} {:.1f})\">{}</g>\n", x, y, content);
}

std::string heading(const Plate& plate) { return plate.problem + ": " + plate.title; }

std::string header(const Plate& plate) {
  return text_at({kMargin, 28.0}, shortened(heading(plate), kInner, 17.0), "head") +
         text_at({kMargin, 46.0},
                 fmt::format("relative error {} · G {} m · {} nodes, {} springs", figure_text(plate.relative_error, 4),
                             figure_text(plate.quality, 4), plate.nodes.size(), plate.springs.size()),
                 "quiet") +
         "\n";
}

// Colours and what the marks mean.
Drawing key(const Plate& plate, const PlateFrame& frame, const StiffnessColours& colours, double width) {
  const Drawing scale = colour_scale(colours, std::min(width, 280.0));
  Drawing drawing{text_at({0.0, 12.0}, "Stiffness", "name"), width, 20.0};
  drawing.text += at(0.0, drawing.height, scale.text);
  drawing.height += scale.height + 4.0;
  drawing.text += text_at({0.0, drawing.height += kLineHeight}, "k_max/k_min " + spread_text(plate), "figure");
  drawing.height += 8.0;
  const Drawing words = paragraph(picture_legend(plate, frame), width);
  drawing.text += at(0.0, drawing.height, words.text);
  drawing.height += words.height;
  return drawing;
}

double aspect(const Plate& plate) {
  Extent box;
  for (const Vector2& node : plate.nodes) box.add(node);
  return box.height() > 0.0 ? box.width() / box.height() : 1e9;
}

Drawing system_and_key(const Plate& plate, const PlateFrame& frame, const StiffnessColours& colours) {
  if (aspect(plate) > kWideBody) {
    const Drawing system = system_panel(plate, kInner, colours), words = key(plate, frame, colours, kInner);
    return {at(kMargin, 0.0, system.text) + at(kMargin, system.height + 8.0, words.text), kPictureWidth,
            system.height + 8.0 + words.height};
  }
  const Drawing system = system_panel(plate, kInner - kKeyWidth - kGap, colours);
  const Drawing words = key(plate, frame, colours, kKeyWidth);
  return {at(kMargin, 0.0, system.text) + at(kPictureWidth - kMargin - kKeyWidth, 8.0, words.text), kPictureWidth,
          std::max(system.height, 8.0 + words.height)};
}

// Flat bodies one under the other; else two or three beside each other, as it fills the last row.
std::size_t columns_of(const Plate& plate) {
  const std::size_t loads = plate.loads.size();
  if (loads < 2 || aspect(plate) > kFlatBody) return 1;
  return loads == 3 || loads > 4 ? 3 : 2;
}

std::string load_caption(const PlateLoad& load, double width, double y) {
  return text_at({0.5 * width, y}, shortened(load.name, width, 13.5), "name", Anchor::middle) +
         text_at({0.5 * width, y + kLineHeight}, "G " + figure_text(load.quality, 4) + " m", "quiet", Anchor::middle);
}

Drawing load_grid(const Plate& plate, const PlateFrame& frame, const StiffnessColours& colours, std::size_t columns) {
  Drawing drawing{"", kPictureWidth, 0.0};
  const double step = (kInner + kGap) / static_cast<double>(columns), row_height = frame.height + kCaptionHeight + kGap;
  for (std::size_t l = 0; l < plate.loads.size(); ++l) {
    const double x = kMargin + static_cast<double>(l % columns) * step + 0.5 * (step - kGap - frame.width);
    drawing.text += fmt::format("<g class=\"load\" transform=\"translate({:.1f} {:.1f})\">", x,
                                static_cast<double>(l / columns) * row_height) +
                    load_panel(plate, plate.loads[l], frame, colours) +
                    load_caption(plate.loads[l], frame.width, frame.height + 18.0) + "</g>\n";
  }
  drawing.height = static_cast<double>((plate.loads.size() + columns - 1) / columns) * row_height;
  return drawing;
}

// Empty where all are drawn.
std::string thinned_sentence(const Plate& plate) {
  const std::size_t at_rest = DrawnSprings(plate, DrawnSprings::kMostAtRest).count();
  const std::size_t under_load = DrawnSprings(plate, DrawnSprings::kMostUnderLoad).count();
  std::string text;
  if (at_rest < plate.springs.size()) text = fmt::format("{} springs are drawn at rest", at_rest);
  if (under_load < plate.springs.size() && !plate.loads.empty())
    text += fmt::format("{}{} {}under each load", text.empty() ? "" : ", ", under_load,
                        text.empty() ? "springs are drawn " : "");
  return text.empty() ? text : text + ".";
}

bool any_unknown(const Plate& plate) {
  return std::ranges::any_of(plate.loads, [](const PlateLoad& load) { return !load.known.empty(); });
}

}  // namespace

std::string spread_text(const Plate& plate) {
  const StiffnessColours range({&plate});
  return range.softest() > 0.0 ? figure_text(range.stiffest() / range.softest(), 4) : "?";
}

std::vector<std::string> picture_legend(const Plate& plate, const PlateFrame& frame) {
  std::vector<std::string> sentences = {"Solid: the springs, coloured by stiffness on a logarithmic scale."};
  if (!plate.loads.empty()) {
    sentences.emplace_back(any_unknown(plate) ? "Dotted, and crosses: the body itself, where that is known."
                                              : "Dotted: the body itself.");
    sentences.emplace_back("Squares are held, arrows are forces.");
    sentences.push_back(
        fmt::format("Displacements are drawn {} times their size.", figure_text(frame.magnification, 1)));
  }
  if (!plate.cells.empty()) sentences.emplace_back("Light lines: the nodes' Voronoi regions.");
  if (!plate.masses.empty()) sentences.emplace_back("Round dots are nodes, their area is the mass.");
  if (std::ranges::any_of(plate.masses, [](double mass) { return !(mass > 0.0); }))
    sentences.emplace_back("Red rings: nodes without a positive mass.");
  if (std::string thinned = thinned_sentence(plate); !thinned.empty()) sentences.push_back(std::move(thinned));
  return sentences;
}

std::string svg_file(const std::string& title, double height, const std::string& content) {
  const std::string size = fmt::format("{:.0f} {:.0f}", kPictureWidth, height);
  return fmt::format(
             "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plate\" "
             "width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\">\n<title>{2}</title>\n",
             kPictureWidth, height, escape_xml(title)) +
         "<style>\n" + std::string(picture_css()) + "</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" +
         content + "</svg>\n";
}

std::string picture_svg(const Plate& plate) {
  const StiffnessColours colours({&plate});
  const std::size_t columns = columns_of(plate);
  const double step = (kInner + kGap) / static_cast<double>(columns);
  const PlateFrame frame = make_frame({&plate}, aspect(plate) > kFlatBody ? kInner : std::min(step - kGap, 420.0));
  const Drawing system = system_and_key(plate, frame, colours);
  const double below = kHeaderHeight + system.height + kGap;
  const Drawing loads = load_grid(plate, frame, colours, columns);
  return svg_file(heading(plate), std::ceil(below + loads.height + kMargin - kGap),
                  header(plate) + at(0.0, kHeaderHeight, system.text) + at(0.0, below, loads.text));
}

}  // namespace nodal::report
