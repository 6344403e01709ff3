// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/picture_svg.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <nodal/show/html.h>
#include <nodal/show/number_text.h>
#include "show/measures.h"
#include "show/panels.h"
#include "show/stress_panels.h"
#include "show/style.h"

namespace nodal::elastic::show {

namespace {

constexpr double kInner = kPictureWidth - 2.0 * kMargin;
constexpr double kKeyWidth = 196.0;          // the column beside the system
constexpr double kWideSystem = 1.8;          // width over height: beyond, the key stands below the system
constexpr double kFlatBody = 4.0;            // likewise: loads stand one under the other
constexpr double kHeaderHeight = 54.0;       // title and figures
constexpr double kLoadCaptionHeight = 42.0;  // name and G of a load
constexpr double kHeadingHeight = 24.0;      // over loads that were never fitted

std::string at(double x, double y, const std::string& content) {
  return fmt::format("<g transform=\"translate({:.1f} {:.1f})\">{}</g>\n", x, y, content);
}

std::string heading(const Picture& picture) { return picture.problem + ": " + picture.title; }

std::string header(const Picture& picture) {
  return text_at({kMargin, 28.0}, shortened(heading(picture), kInner, 17.0), "head") +
         text_at(
             {kMargin, 46.0},
             fmt::format("relative error {} · G {} m · {} nodes, {} springs", figure_text(picture.relative_error, 4),
                         figure_text(picture.quality, 4), picture.nodes.size(), picture.springs.size()),
             "quiet") +
         "\n";
}

// Colours and what the marks mean.
Drawing key(const Picture& picture, const Frame& frame, const StiffnessColours& colours, double width) {
  const Drawing scale = colour_scale(colours, std::min(width, 280.0));
  Drawing drawing{text_at({0.0, 12.0}, "Stiffness", "name"), width, 20.0};
  drawing.text += at(0.0, drawing.height, scale.text);
  drawing.height += scale.height + 4.0;
  drawing.text += text_at({0.0, drawing.height += kLineHeight}, "k_max/k_min " + spread_text(picture), "figure");
  drawing.height += 8.0;
  const Drawing words = paragraph(picture_legend(picture, frame), width);
  drawing.text += at(0.0, drawing.height, words.text);
  drawing.height += words.height;
  return drawing;
}

double aspect(const Picture& picture) {
  const plane::Box box = plane::bounding_box(picture.nodes);
  return box.height() > 0.0 ? box.width() / box.height() : 1e9;
}

Drawing system_and_key(const Picture& picture, const Frame& frame, const StiffnessColours& colours) {
  if (aspect(picture) > kWideSystem) {
    const Drawing system = system_panel(picture, kInner, colours), words = key(picture, frame, colours, kInner);
    return {at(kMargin, 0.0, system.text) + at(kMargin, system.height + 8.0, words.text), kPictureWidth,
            system.height + 8.0 + words.height};
  }
  const Drawing system = system_panel(picture, kInner - kKeyWidth - kGap, colours);
  const Drawing words = key(picture, frame, colours, kKeyWidth);
  return {at(kMargin, 0.0, system.text) + at(kPictureWidth - kMargin - kKeyWidth, 8.0, words.text), kPictureWidth,
          std::max(system.height, 8.0 + words.height)};
}

// Flat bodies one under the other; else two or three beside each other, as it fills the last row.
std::size_t columns_of(const Picture& picture) {
  const std::size_t loads = picture.fitted().size();
  if (loads < 2 || aspect(picture) > kFlatBody) return 1;
  return loads == 3 || loads > 4 ? 3 : 2;
}

std::string caption_below(const PicturedLoad& load, double width, double y) {
  const auto [name, figures] = load_caption(load);
  return text_at({0.5 * width, y}, shortened(name, width, 13.5), "name", Anchor::middle) +
         text_at({0.5 * width, y + kLineHeight}, figures, "quiet", Anchor::middle);
}

Drawing load_grid(const Picture& picture, std::span<const PicturedLoad> loads, const Frame& frame,
                  const StiffnessColours& colours, std::size_t columns) {
  Drawing drawing{"", kPictureWidth, 0.0};
  const double step = (kInner + kGap) / static_cast<double>(columns),
               row_height = frame.height + kLoadCaptionHeight + kGap;
  for (std::size_t l = 0; l < loads.size(); ++l) {
    const double x = kMargin + static_cast<double>(l % columns) * step + 0.5 * (step - kGap - frame.width);
    drawing.text += fmt::format("<g class=\"load\" transform=\"translate({:.1f} {:.1f})\">", x,
                                static_cast<double>(l / columns) * row_height) +
                    load_panel(picture, loads[l], frame, colours) +
                    caption_below(loads[l], frame.width, frame.height + 18.0) + "</g>\n";
  }
  drawing.height = static_cast<double>((loads.size() + columns - 1) / columns) * row_height;
  return drawing;
}

// Fitted ones, then the others under their heading.
Drawing all_loads(const Picture& picture, const Frame& frame, const StiffnessColours& colours, std::size_t columns) {
  Drawing drawing = load_grid(picture, picture.fitted(), frame, colours, columns);
  if (picture.unseen().empty()) return drawing;
  const Drawing unseen = load_grid(picture, picture.unseen(), frame, colours, columns);
  drawing.text += text_at({kMargin, drawing.height + 14.0}, shortened(unseen_heading(picture), kInner, 13.5), "name");
  drawing.height += kHeadingHeight;
  drawing.text += at(0.0, drawing.height, unseen.text);
  drawing.height += unseen.height;
  return drawing;
}

// Empty where all are drawn.
std::string thinned_sentence(const Picture& picture) {
  const std::size_t at_rest = DrawnSprings(picture, DrawnSprings::kMostAtRest).count();
  const std::size_t under_load = DrawnSprings(picture, DrawnSprings::kMostUnderLoad).count();
  std::string text;
  if (at_rest < picture.springs.size()) text = fmt::format("{} springs are drawn at rest", at_rest);
  if (under_load < picture.springs.size() && !picture.loads.empty())
    text += fmt::format("{}{} {}under each load", text.empty() ? "" : ", ", under_load,
                        text.empty() ? "springs are drawn " : "");
  return text.empty() ? text : text + ".";
}

bool any_unknown(const Picture& picture) {
  return std::ranges::any_of(picture.loads, [](const PicturedLoad& load) { return !load.known.empty(); });
}

}  // namespace

std::string unseen_heading(const Picture& picture) {
  return fmt::format("Never fitted: unseen error {} over these loads", figure_text(picture.unseen_error, 4));
}

std::array<std::string, 2> load_caption(const PicturedLoad& load) {
  if (load.unseen) return {load.name + ", never fitted", "relative error " + figure_text(*load.unseen, 4)};
  return {load.name, "G " + figure_text(load.quality, 4) + " m"};
}

std::string spread_text(const Picture& picture) {
  const StiffnessColours range({&picture});
  return range.softest() > 0.0 ? figure_text(range.stiffest() / range.softest(), 4) : "?";
}

std::vector<std::string> picture_legend(const Picture& picture, const Frame& frame) {
  std::vector<std::string> sentences = {"Solid: the springs, coloured by stiffness on a logarithmic scale."};
  if (!picture.nearness.empty())
    sentences.emplace_back(
        "In space: x to the right and down, y to the right and up, z up; what is farther is fainter.");
  if (!picture.loads.empty()) {
    sentences.emplace_back(any_unknown(picture) ? "Dotted, and crosses: the body itself, where that is known."
                                                : "Dotted: the body itself.");
    sentences.emplace_back("Squares are held, arrows are forces.");
    sentences.push_back(
        fmt::format("Displacements are drawn {} times their size.", figure_text(frame.magnification, 1)));
  }
  if (!picture.cells.empty()) sentences.emplace_back("Light lines: the nodes' Voronoi regions.");
  if (!picture.interfaces.empty()) sentences.emplace_back("Dashed lines: borders of regions of material.");
  if (!picture.masses.empty()) sentences.emplace_back("Round dots are nodes, their area is the mass.");
  if (std::ranges::any_of(picture.masses, [](double mass) { return !(mass > 0.0); }))
    sentences.emplace_back("Red rings: nodes without a positive mass.");
  if (std::string thinned = thinned_sentence(picture); !thinned.empty()) sentences.push_back(std::move(thinned));
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

std::string picture_svg(const Picture& picture) {
  const StiffnessColours colours({&picture});
  const std::size_t columns = columns_of(picture);
  const double step = (kInner + kGap) / static_cast<double>(columns);
  const Frame frame = make_frame({&picture}, aspect(picture) > kFlatBody ? kInner : std::min(step - kGap, 420.0));
  const Drawing system = system_and_key(picture, frame, colours);
  const double below = kHeaderHeight + system.height + kGap;
  const Drawing loads = all_loads(picture, frame, colours, columns);
  const Drawing stresses = stress_panels(picture, kInner);
  const double end = below + loads.height;
  return svg_file(heading(picture), std::ceil(end + stresses.height + kMargin - kGap),
                  header(picture) + at(0.0, kHeaderHeight, system.text) + at(0.0, below, loads.text) +
                      (stresses.text.empty() ? "" : at(kMargin, end, stresses.text)));
}

}  // namespace nodal::elastic::show
