// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "springs/connection.h"

namespace nodal::elastic {

extern const Connection kSingleConnection;
extern const Connection kAlternatingConnection;
extern const Connection kCrossedConnection;
extern const Connection kFacesConnection;
extern const Connection kGridConnection;
extern const Connection kTriangularConnection;
extern const Connection kDelaunayConnection;
extern const Connection kDelaunayFlipConnection;
extern const Connection kVoronoiNeighboursConnection;

Table<Connection> connections() {
  static constexpr std::array kConnections = {
      &kSingleConnection,             // grid_connections.cpp
      &kAlternatingConnection,        // grid_connections.cpp
      &kCrossedConnection,            // grid_connections.cpp
      &kFacesConnection,              // grid_connections.cpp
      &kGridConnection,               // grid_connections.cpp
      &kTriangularConnection,         // grid_connections.cpp
      &kDelaunayConnection,           // free_connections.cpp
      &kDelaunayFlipConnection,       // free_connections.cpp
      &kVoronoiNeighboursConnection,  // free_connections.cpp
      &kNearestConnection,            // free_connections.cpp
  };
  return kConnections;
}

}  // namespace nodal::elastic
