// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/stiffness_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include <nodal/show/number_text.h>

#include "show/measures.h"

namespace nodal::elastic::show {

namespace {

constexpr double kLabelBaseline = 25.0, kColourScaleHeight = 29.0;

// "1", "0.01", "1e7".
std::string power_of_ten_text(int power) { return figure_text(std::pow(10.0, power), 1); }

struct Range {
  double from = 0.0, to = 0.0;
};

std::string end_labels(const StiffnessColours& colours, double width, std::vector<Range>& taken) {
  const std::string low = figure_text(colours.softest(), 3), high = figure_text(colours.stiffest(), 3) + " N/m";
  taken.push_back({0.0, text_width(low, kLabelSize)});
  taken.push_back({width - text_width(high, kLabelSize), width});
  return text_at({0.0, kLabelBaseline}, low, "label") + text_at({width, kLabelBaseline}, high, "label", Anchor::end);
}

std::string decades(const StiffnessColours& colours, double width, std::vector<Range>& taken) {
  constexpr double kLabelGap = 5.0;
  const double low = std::log10(colours.softest()), high = std::log10(colours.stiffest());
  std::string ticks, labels;
  for (int power = static_cast<int>(std::ceil(low)); power <= static_cast<int>(std::floor(high)); ++power) {
    const double x = (power - low) / (high - low) * width;
    ticks += move_to({x, kBarHeight}) + line_to({x, kBarHeight + 4.0});
    const std::string label = power_of_ten_text(power);
    const double half = 0.5 * text_width(label, kLabelSize);
    const Range range = {x - half - kLabelGap, x + half + kLabelGap};
    if (std::ranges::any_of(taken, [&](const Range& r) { return r.from < range.to && range.from < r.to; })) continue;
    taken.push_back({x - half, x + half});
    labels += text_at({x, kLabelBaseline}, label, "label", Anchor::middle);
  }
  return ticks.empty() ? labels : "<path class=\"tick\" d=\"" + ticks + "\"/>" + labels;
}

}  // namespace

StiffnessColours::StiffnessColours(const std::vector<const Picture*>& pictures) {
  for (const Picture* picture : pictures)
    for (const PicturedSpring& s : picture->springs)
      if (s.stiffness > 0.0) {
        softest_ = softest_ == 0.0 ? s.stiffness : std::min(softest_, s.stiffness);
        stiffest_ = std::max(stiffest_, s.stiffness);
      }
}

std::size_t StiffnessColours::step(double stiffness) const {
  if (!(stiffness > softest_)) return 0;
  const double share = std::log(stiffness / softest_) / std::log(stiffest_ / softest_);
  return std::min(kSteps - 1, static_cast<std::size_t>(share * static_cast<double>(kSteps)));
}

std::string StiffnessColours::colour(std::size_t step) {
  // Along viridis, stopping before its yellow, which vanishes on white.
  constexpr std::array<std::array<double, 3>, 6> kStops = {
      {{68, 1, 84}, {65, 68, 135}, {42, 120, 142}, {34, 168, 132}, {122, 209, 81}, {190, 205, 30}}};
  const double at =
      static_cast<double>(step) / static_cast<double>(kSteps - 1) * static_cast<double>(kStops.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  std::array<int, 3> rgb{};
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<int>(
        std::lround(kStops[below][c] + (at - static_cast<double>(below)) * (kStops[below + 1][c] - kStops[below][c])));
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

Drawing colour_scale(const StiffnessColours& colours, double width) {
  const bool even = !(colours.stiffest() > colours.softest() * (1.0 + 1e-9));
  if (even)
    return {fmt::format("<rect width=\"24\" height=\"{:.0f}\" fill=\"{}\"/>", kBarHeight, StiffnessColours::colour(0)) +
                text_at({30.0, kBarHeight}, "all " + figure_text(colours.softest(), 3) + " N/m", "label"),
            width, kBarHeight + 4.0};
  const double step = width / static_cast<double>(StiffnessColours::kSteps);
  std::string text;
  for (std::size_t s = 0; s < StiffnessColours::kSteps; ++s) {
    const double x = static_cast<double>(s) * step;
    const double overlap = s + 1 < StiffnessColours::kSteps ? 0.5 : 0.0;  // no white hair between two steps
    text += fmt::format("<rect x=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.0f}\" fill=\"{}\"/>", x, step + overlap,
                        kBarHeight, StiffnessColours::colour(s));
  }
  std::vector<Range> taken;
  text += end_labels(colours, width, taken);
  text += decades(colours, width, taken);
  return {text, width, kColourScaleHeight};
}

}  // namespace nodal::elastic::show
