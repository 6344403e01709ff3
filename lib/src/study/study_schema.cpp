// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/study.h>

namespace nodal {

OptionSchema study_schema() {
  return {
      {.name = "name",
       .type = OptionType::text,
       .default_text = "the file's name",
       .help = "names the study's folder of results; at most 100 characters"},
      {.name = "seed",
       .type = OptionType::integer,
       .default_value = 1,
       .minimum = 0,
       .help = "of every random stream, together with labels and repeat"},
      {.name = "repeats",
       .type = OptionType::integer,
       .default_value = 15,
       .minimum = 1,
       .maximum = 100000,
       .help = "trials per problem and optimizer; deterministic methods from one start run at most 3, for their time"},
      {.name = "starts",
       .type = OptionType::text,
       .default_value = "initial",
       .choices = {"initial", "sampled"},
       .help = "initial: everyone starts at the problem's start; sampled: repeat r > 0 at a random point, the same for "
               "all"},
  };
}

OptionSchema budget_schema() {
  return {
      {.name = "seconds",
       .type = OptionType::number,
       .unit = "s",
       .minimum = 0.0,
       .minimum_excluded = true,
       .help = "wall time of a trial"},
      {.name = "evaluations", .type = OptionType::integer, .minimum = 1, .help = "costs seen in a trial"},
      {.name = "target_gap",
       .type = OptionType::number,
       .minimum = 0.0,
       .maximum = 1.0,
       .minimum_excluded = true,
       .maximum_excluded = true,
       .help = "stop at (G − G*)/(G_start − G*) ≤ this; needs a best known quality"},
      {.name = "stop",
       .type = OptionType::text,
       .default_text = "none: the best point of the race is reported",
       .choices = {"unseen"},
       .help = "unseen: of the points on the way the one is reported that does best on every second thing that is held "
               "out; the others say how good it is"},
  };
}

OptionSchema problem_entry_schema() {
  return {
      {.name = "kind", .type = OptionType::text, .required = true, .help = "which problem: see nodal list problems"},
      {.name = "label",
       .type = OptionType::text,
       .default_text = "kind",
       .help = "names it in tables; unique, at most 100 characters"},
      {.name = "best_known",
       .type = OptionType::table,
       .default_text = "the problem's own, if it knows one",
       .help = "G*: the quality that gaps are measured against",
       .fields = {{.name = "quality",
                   .type = OptionType::number,
                   .default_text = "that of 'file'",
                   .minimum = 0.0,
                   .help = "the lowest quality known; either it or a file"},
                  {.name = "file",
                   .type = OptionType::text,
                   .default_text = "none",
                   .help = "the system that has it, as nodal fit --export writes it: its quality is evaluated"},
                  {.name = "origin", .type = OptionType::text, .required = true, .help = "who says so"}}},
  };
}

OptionSchema optimizer_entry_schema() {
  return {
      {.name = "use", .type = OptionType::text, .required = true, .help = "which method: see nodal list optimizers"},
      {.name = "label",
       .type = OptionType::text,
       .default_text = "use",
       .help = "names it in tables; unique, at most 100 characters, not failed or contaminated, which --rerun means "
               "otherwise"},
      {.name = "baseline",
       .type = OptionType::boolean,
       .default_value = false,
       .help = "the one that the others are stated as multiples of; one at most"},
      {.name = "multi_start",
       .type = OptionType::boolean,
       .default_value = false,
       .help =
           "run the method again and again, first from the start, then from random points, charged to the same budget"},
      {.name = "options",
       .type = OptionType::table,
       .default_text = "all defaults",
       .help = "the method's own options"},
  };
}

}  // namespace nodal
