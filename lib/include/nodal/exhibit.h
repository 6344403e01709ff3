// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How a problem shows itself to people: what `nodal evaluate`, `fit`, `explain` and `report`, --picture and --export
/// say of it. The program knows no problem: it asks the exhibit.
///
/// Values   what describes a system in the problem's own terms: the stiffnesses of springs, say, where coordinates are
///          logarithms of some of them. Bounds don't apply to values. Of a plain problem they are the coordinates.
///
/// Errors   a std::logic_error for a wrong number of values or coordinates.
/// Threads  const calls may run at once.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nodal/error.h>
#include <nodal/problem.h>

namespace nodal {

/// A format that systems are written in.
struct ExportFormat {
  std::string name;
  std::string extension;   ///< by which --export tells formats apart: ".json", in lower case
  std::string summary;     ///< what it is, for messages: "JSON"
  std::string lacks = {};  ///< what this build lacks to write it; empty when it can
};

/// A part of a page: HTML, and the style and the script that it needs. A page has each style and script once; a script
/// comes after Vega and `charts` (bench/report/charts.js). Empty HTML is no part.
struct ReportPart {
  std::string html, style, script;

  [[nodiscard]] bool empty() const noexcept { return html.empty(); }
};

/// A point of a problem's space, for a report: "start", "best: annealing".
struct LabelledPoint {
  std::string label;
  std::vector<double> x;
};

/// A system that has been evaluated once, to be shown in several ways.
class ShownSystem {
 public:
  virtual ~ShownSystem() = default;

  /// Why there is nothing to show; empty when there is. Then nothing else may be asked for.
  [[nodiscard]] virtual std::string failure() const { return {}; }
  /// What `nodal evaluate --json` prints.
  [[nodiscard]] virtual Value data() const = 0;
  /// The same for people.
  [[nodiscard]] virtual std::string text() const = 0;
  /// An SVG file. Asked for only where the exhibit draws.
  [[nodiscard]] virtual std::string picture(const std::string& /*title*/) const { return {}; }

 protected:
  ShownSystem() = default;
  ShownSystem(const ShownSystem&) = delete;
  ShownSystem& operator=(const ShownSystem&) = delete;
};

/// A problem with parts left out that did little.
struct Reduced {
  std::shared_ptr<const Problem> problem;  ///< none when nothing could be left out
  std::vector<double> values;              ///< of `problem`
  std::string text;                        ///< what was left out, and what it costs
};

class Exhibit {
 public:
  virtual ~Exhibit() = default;

  /// Values at a point of the space, and those that the problem starts from.
  [[nodiscard]] virtual std::vector<double> values(std::span<const double> x) const = 0;
  [[nodiscard]] virtual std::vector<double> start() const = 0;
  /// Values from a file that people name. InputError for what is wrong in it; Refusal by a problem that reads none.
  [[nodiscard]] virtual std::vector<double> read(const std::filesystem::path& file) const;

  /// The point of the space that has these values, as far as people write them; empty where none has, for a bound or
  /// for parts that move together. Refusal by a problem that doesn't say. Goes with `values`: who overrides one
  /// overrides both.
  [[nodiscard]] virtual std::optional<std::vector<double>> point(std::span<const double> values) const;

  /// The quality of values by arithmetic of more digits than doubles have, rounded at the end: it says how many digits
  /// of a best known quality hold. Empty where there is no such arithmetic, or it would take longer than a second.
  [[nodiscard]] virtual std::optional<double> exact_quality(std::span<const double> /*values*/) const {
    return std::nullopt;
  }

  /// `label` is what the study calls the problem.
  [[nodiscard]] virtual std::unique_ptr<ShownSystem> show(const std::string& label,
                                                          std::span<const double> values) const = 0;
  /// Systems have a picture.
  [[nodiscard]] virtual bool draws() const { return false; }

  /// What may be wrong with the problem, told with every result.
  [[nodiscard]] virtual std::vector<std::string> notes() const { return {}; }
  /// What is to be known of a result: that the data leave some of its values open, say.
  [[nodiscard]] virtual std::vector<std::string> notes_at(std::span<const double> /*values*/) const { return {}; }

  /// What would make the data say more of the values, for `nodal explain`: a line each, with what it would come to.
  [[nodiscard]] virtual std::vector<std::string> proposals() const { return {}; }

  /// What makes a fit hold better where nothing was fitted, and isn't done yet: "a prior (prior = { … })".
  [[nodiscard]] virtual std::vector<std::string> remedies() const { return {}; }

  /// Points side by side for a page; empty where there is nothing to draw, or too much of it.
  [[nodiscard]] virtual ReportPart report(const std::string& /*label*/,
                                          std::span<const LabelledPoint> /*points*/) const {
    return {};
  }

  /// At least one, the first being what is written where nobody asks for another.
  [[nodiscard]] virtual std::vector<ExportFormat> formats() const = 0;
  [[nodiscard]] virtual std::string write(const ExportFormat& format, std::span<const double> values) const = 0;

  /// `nodal fit --prune` is for this problem.
  [[nodiscard]] virtual bool reduces() const { return false; }
  /// Leaves out what can be, within `most_loss`: how much larger the error may become, as a share of it. Asked for only
  /// where the exhibit reduces. InputError when values allow none.
  [[nodiscard]] virtual Reduced reduce(std::span<const double> /*values*/, double /*most_loss*/) const { return {}; }

 protected:
  Exhibit() = default;
  Exhibit(const Exhibit&) = delete;
  Exhibit& operator=(const Exhibit&) = delete;
};

/// Of a problem that says nothing of its own: values are coordinates, shown by cost and quality, written as JSON. A
/// base for exhibits that have little to add. The problem must outlive it.
class PlainExhibit : public Exhibit {
 public:
  explicit PlainExhibit(const Problem& problem) : problem_(problem) {}

  [[nodiscard]] std::vector<double> values(std::span<const double> x) const override { return {x.begin(), x.end()}; }
  [[nodiscard]] std::vector<double> start() const override { return values(problem_.space().start()); }
  [[nodiscard]] std::optional<std::vector<double>> point(std::span<const double> values) const override;
  [[nodiscard]] std::unique_ptr<ShownSystem> show(const std::string& label,
                                                  std::span<const double> values) const override;
  [[nodiscard]] std::vector<ExportFormat> formats() const override;
  [[nodiscard]] std::string write(const ExportFormat& format, std::span<const double> values) const override;

 private:
  const Problem& problem_;
};

/// The problem's own exhibit, or a plain one. The problem must outlive it.
[[nodiscard]] std::shared_ptr<const Exhibit> exhibit_of(const Problem& problem);

/// Bad input of a kind that can be drawn.
class DrawnInputError : public InputError {
 public:
  using InputError::InputError;

  /// An SVG file; `name` is what the input is called, "gear".
  [[nodiscard]] virtual std::string picture(const std::string& name) const = 0;
};

}  // namespace nodal
