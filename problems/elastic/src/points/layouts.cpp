// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "points/layout.h"

namespace nodal::elastic {

extern const Layout kTriangularLayout;
extern const Layout kRandomLayout;
extern const Layout kVoronoiLayout;

Table<Layout> layouts() {
  static constexpr std::array kLayouts = {
      &kGridLayout,        // grid_layout.cpp
      &kTriangularLayout,  // grid_layout.cpp
      &kRandomLayout,      // scattered_layout.cpp
      &kVoronoiLayout,     // scattered_layout.cpp
      &kFileLayout,        // import/file_layout.cpp
  };
  return kLayouts;
}

}  // namespace nodal::elastic
