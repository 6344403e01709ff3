// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/registry.h>

namespace nodal {

void register_nlopt(Registry& registry) {
  registry.add(AbsentDescription{"nlopt-*",
                                 "this build has no NLopt: install libnlopt-dev and libnlopt-cxx-dev and configure "
                                 "with -DNODAL_NLOPT=ON"});
}

}  // namespace nodal
