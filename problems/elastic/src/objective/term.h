// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A part of the objective: half a sum of squares of a spring system's own quantities, its stiffnesses and masses.
///
/// A term doesn't know what a search varies: the chain from stiffnesses to coordinates is done once, by Parameters. So
/// a new term is residuals of a system and their derivatives, and every way of tying springs works with it. Terms that
/// are *fitted* make up the cost; terms that are *held out* are evaluated where they are asked for, part by part, and
/// never enter cost, gradient or walk (objective.h).
///
/// Shapes   stiffness: [springs]; mass: [nodes], empty where nothing needs masses.
/// Units    N/m, kg.
/// Threads  Term: immutable, shared. TermEvaluator: one thread.

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nodal/elastic/parameters.h>
#include <nodal/problem.h>

namespace nodal::elastic {

/// Physical values at a point.
struct System {
  std::span<const double> stiffness, mass = {};
};

/// Derivatives by them; what is computed is added.
struct SystemGradient {
  std::span<double> stiffness, mass = {};
};

/// Keeps its last point: derivatives are asked for there, after a value that was ok. What it was given must stay as it
/// is until the next value. After the first call of each kind nothing is allocated.
class TermEvaluator {
 public:
  virtual ~TermEvaluator() = default;

  /// ½ Σ r².
  virtual Evaluation value(const System& system) = 0;
  /// The same as exactly as can be had, filling `health`.
  virtual Evaluation audit(const System& system) = 0;

  /// [residual_count] r.
  virtual Status residuals(std::span<double> r) = 0;
  /// Adds weight · ∂(½ Σ r²).
  virtual Status add_gradient(double weight, const SystemGradient& gradient) = 0;
  /// jv = Σ ∂r/∂(k, m) direction.
  virtual Status product(const System& direction, std::span<double> jv) = 0;
  /// Adds w·∂r.
  virtual Status add_transposed_product(std::span<const double> w, const SystemGradient& gradient) = 0;
  /// [residual_count][coordinates] ∂r/∂x, written through the ties: every entry.
  virtual Status jacobian(const Parameters& parameters, std::span<double> rows) = 0;

  /// [parts] The relative error of each part of the term at a system, √Σ r² of it alone. They mean something when the
  /// status is ok. The system is the last point then.
  [[nodiscard]] virtual Status part_errors(const System& system, std::span<double> errors);

  /// The walk of an objective of this term alone; nothing where the term has none. Lives as long as this object.
  [[nodiscard]] virtual Moves* moves() { return nullptr; }
  [[nodiscard]] virtual Work work() const = 0;
  /// Of the last audit.
  [[nodiscard]] virtual Health health() const { return {}; }

 protected:
  TermEvaluator() = default;
  TermEvaluator(const TermEvaluator&) = delete;
  TermEvaluator& operator=(const TermEvaluator&) = delete;
};

class Term {
 public:
  virtual ~Term() = default;

  [[nodiscard]] virtual std::string_view name() const = 0;
  /// A wish of what systems are like, not a misfit of data: results are told without it (Health::data_cost).
  [[nodiscard]] virtual bool is_prior() const { return false; }
  [[nodiscard]] virtual Abilities abilities() const = 0;
  [[nodiscard]] virtual std::size_t residual_count() const = 0;
  /// What its error can be told apart by where it is held out: the displacements' loads. Itself ordinarily.
  [[nodiscard]] virtual std::vector<std::string> parts() const { return {std::string(name())}; }
  [[nodiscard]] virtual std::unique_ptr<TermEvaluator> make_evaluator() const = 0;

 protected:
  Term() = default;
  Term(const Term&) = delete;
  Term& operator=(const Term&) = delete;
};

}  // namespace nodal::elastic
