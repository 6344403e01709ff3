// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Draws pictures as in the paper's Figure 8: the body's own deformation dotted, the spring system's on top, each
/// spring coloured by its stiffness on a logarithmic scale; and the system at rest, with the body, its Voronoi cells
/// and its masses. What is drawn is styled by picture.css.

#include <cstddef>
#include <string>
#include <vector>

#include "show/picture_frame.h"
#include "show/stiffness_colours.h"

namespace nodal::elastic::show {

/// Which springs a panel draws: all up to `most`, beyond that those along the border and of the others an even share,
/// chosen by their number alone. So a file stays below a few megabytes, and a drawing of so many lines looks the same.
/// Of a net in space only those are drawn that are seen, under loads and where there are more than kMostThrough.
class DrawnSprings {
 public:
  static constexpr std::size_t kMostAtRest = 60'000, kMostUnderLoad = 20'000, kMostThrough = 3'000;

  DrawnSprings(const Picture& picture, std::size_t most);

  [[nodiscard]] bool contains(std::size_t spring) const { return all_ || drawn_[spring]; }
  [[nodiscard]] std::size_t count() const noexcept { return count_; }

 private:
  bool all_ = true;
  std::vector<bool> drawn_;
  std::size_t count_ = 0;
};

/// Springs between the nodes' places in the drawing, a path for each colour.
[[nodiscard]] std::string spring_lines(const Picture& picture, const DrawnSprings& drawn,
                                       const std::vector<Point>& places, double line_width,
                                       const StiffnessColours& colours);

/// One load of one picture: what stands inside an <svg> element of the frame's size.
[[nodiscard]] std::string load_panel(const Picture& picture, const PicturedLoad& load, const Frame& frame,
                                     const StiffnessColours& colours);
/// The same as a complete <svg> element.
[[nodiscard]] std::string load_svg(const Picture& picture, const PicturedLoad& load, const Frame& frame,
                                   const StiffnessColours& colours);

/// Of the system at rest in a panel of that width.
[[nodiscard]] Frame system_frame(const Picture& picture, double width);
/// The system at rest: body, Voronoi cells, springs, nodes sized by mass, and a strip with the scales of both.
[[nodiscard]] Drawing system_panel(const Picture& picture, double width, const StiffnessColours& colours);
/// The same as a complete <svg> element.
[[nodiscard]] std::string system_svg(const Picture& picture, double width, const StiffnessColours& colours);

}  // namespace nodal::elastic::show
