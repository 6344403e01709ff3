// SPDX-License-Identifier: GPL-3.0-or-later
#include "show/details.h"

#include <cmath>

namespace nodal::elastic::show {

namespace {

// A figure or a count beyond this is none, and no axis holds it.
constexpr double kLargest = 1e100, kLargestCount = 1e9;

std::optional<double> number_of(const Value& table, std::string_view key, double largest = kLargest) {
  const Value* value = table.find(key);
  const bool sane = value && value->is_number() && std::abs(value->number()) <= largest;
  return sane ? std::optional(value->number()) : std::nullopt;
}

// A line without one of the three curves can't be drawn.
std::optional<plane::VoronoiStep> step_of(const Value& line) {
  if (!line.is_table()) return std::nullopt;
  const auto iteration = number_of(line, "iteration", kLargestCount), distance = number_of(line, "distance_deviation"),
             area = number_of(line, "area_deviation"), energy = number_of(line, "energy");
  if (!iteration || *iteration < 0.0 || !distance || !area || !energy) return std::nullopt;
  plane::VoronoiStep step;
  step.iteration = static_cast<std::size_t>(*iteration);
  step.distance_deviation = *distance;
  step.area_deviation = *area;
  step.energy = *energy;
  step.inner_energy = number_of(line, "inner_energy").value_or(0.0);
  step.area_error = number_of(line, "area_error").value_or(0.0);
  step.largest_move = number_of(line, "largest_move").value_or(0.0);
  return step;
}

MassDetails masses_of(const Value& table) {
  MassDetails masses;
  masses.form = table.text_or("form", "");
  masses.message = table.text_or("message", "");
  masses.smallest = number_of(table, "smallest").value_or(0.0);
  masses.rank = static_cast<int>(number_of(table, "rank", kLargestCount).value_or(0.0));
  if (const Value* errors = table.find("moment_errors"); errors && errors->is_table())
    for (const auto& [name, error] : errors->table())
      if (error.is_number()) masses.moments.push_back({name, error.number()});
  return masses;
}

// Without a load that has an error there is nothing to say.
std::optional<ElementDetails> elements_of(const Value& run) {
  const Value* errors = run.is_table() ? run.find("errors") : nullptr;
  if (!errors || !errors->is_table()) return std::nullopt;
  ElementDetails elements;
  for (const auto& [name, error] : errors->table())
    if (error.is_number() && error.number() >= 0.0 && error.number() <= kLargest)
      elements.loads.push_back({name, error.number()});
  if (elements.loads.empty()) return std::nullopt;
  elements.elements = run.text_or("elements", "elements");
  elements.meshes = number_of(run, "meshes", kLargestCount).value_or(0.0);
  elements.cells = number_of(run, "cells", kLargestCount).value_or(0.0);
  elements.unknowns = number_of(run, "unknowns", kLargestCount).value_or(0.0);
  elements.converged = run.flag_or("converged", true);
  return elements;
}

}  // namespace

SystemDetails read_details(const Value& details) {
  SystemDetails read;
  if (!details.is_table()) return read;
  if (const Value* lines = details.find("voronoi"); lines && lines->is_list())
    for (const Value& line : lines->list())
      if (const auto step = step_of(line)) read.iterations.push_back(*step);
  if (const Value* masses = details.find("masses"); masses && masses->is_table()) read.masses = masses_of(*masses);
  if (const Value* runs = details.find("finite_elements"); runs && runs->is_list())
    for (const Value& run : runs->list())
      if (auto elements = elements_of(run)) read.references.push_back(std::move(*elements));
  return read;
}

}  // namespace nodal::elastic::show
