// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "moves/pricing_forms.h"

namespace nodal::elastic {

Table<PricingFormDescription> pricing_forms() {
  static constexpr std::array kForms = {&kEagerForm, &kLazyForm, &kRefactorForm, &kUpdownForm, &kFullForm};
  return kForms;
}

}  // namespace nodal::elastic
