// SPDX-License-Identifier: GPL-3.0-or-later
// What a build without CGAL says.
#include <gtest/gtest.h>

#include <nodal/error.h>

#include "finite_elements/plane_mesh.h"

namespace nodal::elastic::finite_elements {
namespace {

TEST(AbsentMesh, SaysWhatToInstall) {
  EXPECT_FALSE(plane_meshes_available());
  try {
    (void)plane_mesh({}, 1.0);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("install libcgal-dev"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace nodal::elastic::finite_elements
