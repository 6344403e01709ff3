// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The displacements that loads are compared with, where nobody measured them: in closed form where that is exact, by
/// finite elements elsewhere, or as the study chooses.
///
/// Units    m, Pa; a tolerance is relative to a load's largest displacement.
/// Cost     closed forms: none worth naming; finite elements: finite_element_answer.h, or a file read where a cache has
///          them.
/// Threads  one at a time.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/elastic/account.h>
#include <nodal/elastic/loads.h>
#include <nodal/elastic/material_field.h>
#include <nodal/error.h>
#include <nodal/result_cache.h>

#include "loads/placed_load.h"
#include "reference/finite_element_answer.h"

namespace nodal::elastic {

/// Of finite elements, unless a study says otherwise.
inline constexpr double kReferenceTolerance = 1e-4;

struct ReferenceChoice {
  /// `file` and `none` are of the study's own loads; others are answered as `automatic` then.
  enum class Method { automatic, analytic, finite_elements, file, none } method = Method::automatic;
  double tolerance = kReferenceTolerance;  ///< of finite elements
  Source source = {};                      ///< where it was chosen
};

class References {
 public:
  /// Net, material and account must outlive it.
  References(ReferenceChoice choice, const Net& net, const MaterialField& material, Account& account,
             ResultCache cache = {})
      : choice_(std::move(choice)), net_(net), material_(material), account_(account), cache_(std::move(cache)) {}

  /// Loads of the toolkit's own. Refusal as `place`, and where none of the methods that may be taken has an answer.
  [[nodiscard]] LoadSet of(const std::vector<LoadSpec>& specs);
  /// Loads that a study describes, by finite elements. Refusal where these have no answer.
  [[nodiscard]] LoadSet of(std::vector<PlacedLoad> loads);
  /// Why one of them has none, as far as can be told before it is tried; empty when it may.
  [[nodiscard]] std::string no_answer_for(const PlacedLoad& load) const { return why_no_finite_elements(load, net_); }

  /// What was taken so far, and why the others weren't.
  void tell(std::string_view no_closed_form = "finite elements were chosen",
            std::string_view no_elements = "the closed form is exact");

  [[nodiscard]] const ReferenceChoice& choice() const noexcept { return choice_; }

 private:
  /// A load, and its reference once it is known.
  struct Answered {
    PlacedLoad load;
    std::vector<double> reference = {}, uncertainty = {};
    std::vector<Tensor> stress = {};  ///< [nodes]
  };

  void answer_by_elements(const std::vector<Answered*>& loads);
  FiniteElementAnswer answer_kept_or_made(const std::vector<const PlacedLoad*>& loads) const;
  /// By finite elements what has no reference yet.
  LoadSet finish(std::vector<Answered> loads);

  ReferenceChoice choice_;
  const Net& net_;
  const MaterialField& material_;
  Account& account_;
  ResultCache cache_;                                 // of finite elements' answers
  bool analytic_ = false;                             // some load, of all calls
  std::string no_closed_form_;                        // why the first that has none hasn't
  std::vector<FiniteElementAnswer::Summary> meshed_;  // of all calls
};

}  // namespace nodal::elastic
