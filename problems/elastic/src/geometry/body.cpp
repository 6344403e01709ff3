// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/elastic/body.h>

namespace nodal::elastic {

Extent extent_of(const Body& body) {
  if (body.box) return *body.box;
  return body.has_outline() ? extent_of(lifted(body.rings[0])) : Extent{};
}

double border_tolerance(const Body& body) {
  return body.box ? kPlaceRounding * body.box->size() : plane::outline_tolerance(body);
}

}  // namespace nodal::elastic
