// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "points/layout.h"

namespace nodal::elastic {

extern const Layout kTriangularLayout;  // grid_layout.cpp
extern const Layout kRandomLayout;      // scattered_layout.cpp
extern const Layout kVoronoiLayout;     // scattered_layout.cpp

Table<Layout> layouts() {
  static constexpr std::array kLayouts = {
      &kGridLayout, &kTriangularLayout, &kRandomLayout, &kVoronoiLayout, &kFileLayout,
  };
  return kLayouts;
}

}  // namespace nodal::elastic
