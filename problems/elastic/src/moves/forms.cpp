// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "moves/pricing_forms.h"

namespace nodal::elastic {

extern const PricingFormDescription kEagerForm;
extern const PricingFormDescription kLazyForm;
extern const PricingFormDescription kRefactorForm;
extern const PricingFormDescription kUpdownForm;

Table<PricingFormDescription> pricing_forms() {
  static constexpr std::array kForms = {
      &kEagerForm,     // eager_form.cpp
      &kLazyForm,      // lazy_form.cpp
      &kRefactorForm,  // refactor_form.cpp
      &kUpdownForm,    // updown_form.cpp
      &kFullForm,      // full_form.cpp
  };
  return kForms;
}

}  // namespace nodal::elastic
