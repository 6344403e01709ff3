// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The Metropolis rule of Figure 6: a better step is taken, a worse one with probability exp((G − G')/T). So T is the
/// worsening of G that is still accepted 37 % of the time.

#include <nodal/random.h>

namespace nodal::annealing {

enum class Verdict { good, accepted_worse, rejected };

/// "Good" means strictly better than the current value. Draws from the stream only for a worse step.
[[nodiscard]] Verdict judge(double current, double proposed, double temperature, RandomStream& random);

}  // namespace nodal::annealing
