// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The elastic problem as people see it. Its values are the stiffnesses of its springs, N/m.

#include <nodal/elastic/elastic_problem.h>
#include <nodal/exhibit.h>

namespace nodal::elastic::show {

class ElasticExhibit final : public Exhibit {
 public:
  explicit ElasticExhibit(const ElasticProblem& problem) : problem_(problem) {}

  [[nodiscard]] std::vector<double> values(std::span<const double> x) const override;
  [[nodiscard]] std::vector<double> start() const override;
  [[nodiscard]] std::vector<double> read(const std::filesystem::path& file) const override;
  /// To six digits.
  [[nodiscard]] std::optional<std::vector<double>> point(std::span<const double> stiffness) const override;
  /// By solve_extended(), where that takes at most a million operations: up to some 250 nodes in the plane.
  [[nodiscard]] std::optional<double> exact_quality(std::span<const double> stiffness) const override;
  [[nodiscard]] std::unique_ptr<ShownSystem> show(const std::string& label,
                                                  std::span<const double> stiffness) const override;
  [[nodiscard]] bool draws() const override { return true; }
  [[nodiscard]] std::vector<std::string> notes() const override;
  /// The springs whose stiffness the reference says nothing about.
  [[nodiscard]] std::vector<std::string> notes_at(std::span<const double> stiffness) const override;
  [[nodiscard]] std::vector<std::string> proposals() const override;
  [[nodiscard]] std::vector<std::string> remedies() const override;
  /// Pictures side by side; none of a net with more than 4,000 springs: a picture of more is grey, and the page grows
  /// by megabytes.
  [[nodiscard]] ReportPart report(const std::string& label, std::span<const LabelledPoint> points) const override;
  [[nodiscard]] std::vector<ExportFormat> formats() const override;
  [[nodiscard]] std::string write(const ExportFormat& format, std::span<const double> stiffness) const override;
  [[nodiscard]] bool reduces() const override { return true; }
  [[nodiscard]] Reduced reduce(std::span<const double> stiffness, double most_loss) const override;

 private:
  const ElasticProblem& problem_;
};

}  // namespace nodal::elastic::show
