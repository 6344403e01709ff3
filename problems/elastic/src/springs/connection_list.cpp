// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "springs/connection.h"

namespace nodal::elastic {

Table<Connection> connections() {
  static constexpr std::array kConnections = {
      &kSingleConnection,   &kAlternatingConnection,  &kCrossedConnection,
      &kFacesConnection,    &kGridConnection,         &kTriangularConnection,
      &kDelaunayConnection, &kDelaunayFlipConnection, &kVoronoiNeighboursConnection,
      &kNearestConnection};
  return kConnections;
}

}  // namespace nodal::elastic
