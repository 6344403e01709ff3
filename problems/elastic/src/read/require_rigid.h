// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Refuses nets that can move without resistance before anybody tries to fit them.

#include <nodal/elastic/account.h>
#include <nodal/elastic/loads.h>
#include <nodal/elastic/net.h>
#include <nodal/error.h>

#include "rigidity/held.h"

namespace nodal::elastic {

/// MechanismError when, under some group of supports, nodes can move while no spring changes its length: names them.
/// A full grid with diagonals is known to be rigid and not looked at. `own_supports`: they are the study's, which can
/// be told to hold more. Returns whether the net keeps its shape with nothing held.
///
/// Cost     one sparse QR of the net; another per group of supports only where the free net is no rigid body.
bool require_rigid(const Net& net, const LoadSet& loads, bool own_supports, const Source& source, Account& account);

}  // namespace nodal::elastic
