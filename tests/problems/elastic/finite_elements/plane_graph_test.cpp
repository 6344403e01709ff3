// SPDX-License-Identifier: GPL-3.0-or-later
// Interfaces in a body's outline as pieces that meet in places alone.
#include <gtest/gtest.h>

#include <algorithm>

#include "finite_elements/plane_graph.h"

namespace nodal::elastic::finite_elements {
namespace {

// The square [0, 4]² with the hole [1, 2]²; labels 0 to 3, and 4 to 7.
PlaneBody square() {
  PlaneBody body;
  body.rings = {{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {0, 1, 2, 3}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}, {4, 5, 6, 7}}};
  return body;
}

double length_of(const PlaneGraph& graph, const std::vector<PlaneGraph::Piece>& pieces) {
  double length = 0.0;
  for (const auto& [from, to] : pieces)
    length += std::hypot(graph.places[to][0] - graph.places[from][0], graph.places[to][1] - graph.places[from][1]);
  return length;
}

TEST(PlaneGraph, OfRingsAloneIsTheirSides) {
  const PlaneGraph graph = plane_graph(square());
  EXPECT_EQ(graph.places.size(), 8u);
  EXPECT_EQ(graph.label, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_TRUE(graph.interfaces.empty());
}

TEST(PlaneGraph, InterfacesAreCutAtBordersAndEachOther) {
  PlaneBody body = square();
  body.interfaces = {{{-1, 1.5}, {5, 1.5}}, {{3, -2}, {3, 9}}};  // through the hole, and across
  const PlaneGraph graph = plane_graph(body);
  EXPECT_DOUBLE_EQ(length_of(graph, graph.interfaces), 1.0 + 2.0 + 4.0);
  EXPECT_EQ(graph.interfaces.size(), 1u + 2u + 2u);
  EXPECT_EQ(graph.border.size(), 8u + 6u);
  EXPECT_DOUBLE_EQ(length_of(graph, graph.border), 16.0 + 4.0);
  EXPECT_EQ(std::ranges::count(graph.label, 0u), 2);      // halves keep their side's label
  EXPECT_EQ(singular_interface_places(body).size(), 7u);  // six at the border, and the crossing
}

TEST(PlaneGraph, WhatLiesAlongASideOrIsRepeatedIsLeftOut) {
  PlaneBody body = square();
  const double off = 1e-7;  // as far as people's six digits are
  body.interfaces = {
      {{0.5, off}, {3.5, -off}}, {{1 + off, 0.5}, {1 - off, 3}}, {{3, 0}, {3, 4}}, {{3, 1}, {3 + off, 3}}};
  const PlaneGraph graph = plane_graph(body);
  EXPECT_NEAR(length_of(graph, graph.interfaces), 0.5 + 1.0 + 4.0,
              1e-6);                                  // above and below the hole's side, and once x = 3
  EXPECT_EQ(std::ranges::count(graph.label, 4u), 1);  // the hole's own side is whole
  for (std::size_t i = 0; i < graph.places.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const plane::Point &p = graph.places[i], &q = graph.places[j];
      EXPECT_GT(std::hypot(p[0] - q[0], p[1] - q[1]), 1e-3);
    }
}

TEST(PlaneGraph, EndsNearVerticesAreThere) {
  PlaneBody body = square();
  body.interfaces = {{{1e-7, -1e-7}, {1 - 1e-7, 1 + 1e-7}}, {{2, 2}, {4, 4}}};
  const PlaneGraph graph = plane_graph(body);
  EXPECT_EQ(graph.places.size(), 8u);
  EXPECT_EQ(graph.interfaces, (std::vector<PlaneGraph::Piece>{{0, 4}, {6, 2}}));
}

TEST(PlaneGraph, SmoothInterfacesAreNotSingularWithin) {
  PlaneBody body = square();
  body.interfaces = {{{2.5, 2.5}, {3.5, 2.5}}, {{3.5, 2.5}, {3.5, 3.5}}, {{3.5, 3.5}, {2.5, 3.5}},
                     {{2.5, 3.5}, {2.5, 2.5}}, {{0.5, 3.0}, {1.0, 3.1}}, {{1.0, 3.1}, {1.5, 3.3}}};
  EXPECT_EQ(singular_interface_places(body).size(), 4u + 2u);
  EXPECT_EQ(singular_interface_places(body, 3.0).size(), 2u);  // no corner turns as far
}

}  // namespace
}  // namespace nodal::elastic::finite_elements
