// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/finite_element_answer.h"

#include <nodal/error.h>

namespace nodal::elastic {

std::string why_no_finite_elements(const PlacedLoad&, const Net&) {
  return "a closed form is known for the basic loads only";
}

FiniteElementAnswer answer_by_finite_elements(const Net&, const MaterialField&, const std::vector<const PlacedLoad*>&,
                                              double) {
  throw Refusal("there are no finite elements yet");
}

}  // namespace nodal::elastic
