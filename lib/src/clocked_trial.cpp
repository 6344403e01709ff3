// SPDX-License-Identifier: GPL-3.0-or-later
#include "clocked_trial.h"

#include <sys/resource.h>

#include "core.h"
#include "warm_up.h"

namespace nodal {

namespace {

rusage thread_usage() {
  rusage usage{};
  ::getrusage(RUSAGE_THREAD, &usage);  // can't fail with these arguments
  return usage;
}

}  // namespace

TrialRecord run_clocked_trial(const Study& study, const Trial& trial, const Registry& registry,
                              std::optional<int> core) {
  const OnCore here(core);
  const WarmUp before = warm_up(study, trial, registry);
  const rusage began = thread_usage();
  TrialRecord record = run_trial(study, trial, registry);
  const rusage ended = thread_usage();
  record.seconds.warm_up = before.seconds;
  Conditions& conditions = record.conditions.emplace();
  conditions.core = here.core();
  conditions.preempted = ended.ru_nivcsw - began.ru_nivcsw;
  conditions.waited = ended.ru_nvcsw - began.ru_nvcsw;
  conditions.cold = times_as_cold(before, record);
  return record;
}

}  // namespace nodal
