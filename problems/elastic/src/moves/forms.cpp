// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "moves/pricing_forms.h"

namespace nodal::elastic {

extern const PricingFormDescription kEagerForm;     // eager_form.cpp
extern const PricingFormDescription kLazyForm;      // lazy_form.cpp
extern const PricingFormDescription kRefactorForm;  // refactor_form.cpp
extern const PricingFormDescription kUpdownForm;    // updown_form.cpp

Table<PricingFormDescription> pricing_forms() {
  static constexpr std::array kForms = {
      &kEagerForm, &kLazyForm, &kRefactorForm, &kUpdownForm, &kFullForm,
  };
  return kForms;
}

}  // namespace nodal::elastic
