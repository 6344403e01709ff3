// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/registry.h>

namespace nodal {

void register_ceres(Registry& registry) {
  registry.add(AbsentDescription{"ceres-*",
                                 "this build has no Ceres: install libceres-dev and configure with -DNODAL_CERES=ON"});
}

}  // namespace nodal
