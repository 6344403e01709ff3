// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <nodal/broken.h>

std::string nodal::broken() { return "broken"; }
