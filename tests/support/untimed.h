// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What equal trials have in common.

#include <nodal/record.h>

namespace nodal {

/// A record without what the clock says.
inline TrialRecord untimed(TrialRecord record) {
  record.seconds = {};
  record.conditions.reset();
  for (TracePoint& point : record.trace) point.seconds = 0.0;
  if (record.unseen)
    for (UnseenPoint& point : record.unseen->points) point.at.seconds = 0.0;
  return record;
}

}  // namespace nodal
