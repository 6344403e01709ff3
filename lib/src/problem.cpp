// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/problem.h>

namespace nodal {

namespace {

struct NamedAbility {
  const char* name;
  bool Abilities::*member;
};
constexpr NamedAbility kNamedAbilities[] = {
    {"gradient", &Abilities::gradient},
    {"residuals", &Abilities::residuals},
    {"jacobian-products", &Abilities::jacobian_products},
    {"moves", &Abilities::moves},
};

}  // namespace

std::vector<std::string> Abilities::missing(const Abilities& needs) const {
  std::vector<std::string> lacking;
  for (const auto& [name, member] : kNamedAbilities)
    if (needs.*member && !(this->*member)) lacking.emplace_back(name);
  return lacking;
}

std::vector<std::string> Abilities::names() const { return Abilities{}.missing(*this); }

}  // namespace nodal
