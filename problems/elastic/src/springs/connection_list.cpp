// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "springs/connection.h"

namespace nodal::elastic {

extern const Connection kSingleConnection;             // grid_connections.cpp
extern const Connection kAlternatingConnection;        // grid_connections.cpp
extern const Connection kCrossedConnection;            // grid_connections.cpp
extern const Connection kFacesConnection;              // grid_connections.cpp
extern const Connection kGridConnection;               // grid_connections.cpp
extern const Connection kTriangularConnection;         // grid_connections.cpp
extern const Connection kDelaunayConnection;           // free_connections.cpp
extern const Connection kDelaunayFlipConnection;       // free_connections.cpp
extern const Connection kVoronoiNeighboursConnection;  // free_connections.cpp

Table<Connection> connections() {
  static constexpr std::array kConnections = {
      &kSingleConnection,   &kAlternatingConnection,  &kCrossedConnection,
      &kFacesConnection,    &kGridConnection,         &kTriangularConnection,
      &kDelaunayConnection, &kDelaunayFlipConnection, &kVoronoiNeighboursConnection,
      &kNearestConnection,
  };
  return kConnections;
}

}  // namespace nodal::elastic
