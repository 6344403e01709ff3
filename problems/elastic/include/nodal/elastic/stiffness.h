// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Initial spring stiffnesses, and files that hold fitted systems.
///
/// Shapes   [springs].
/// Units    N/m.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nodal/elastic/material_field.h>
#include <nodal/elastic/net.h>
#include <nodal/input_files.h>

namespace nodal::elastic {

/// Of several materials, and of orthotropic ones, a spring's E·t is that of the simplices at it: their mean, by area,
/// each with the material at its centroid, and with E along the spring; what is at the middle of a spring that has
/// none.

/// `paper`: k = E·t·s0/4 (section 5.2); in space k = E·s0/4, whose dimension is right.
[[nodiscard]] std::vector<double> paper_stiffness(const Net& net, const MaterialField& material);
/// `area`: k = E·t·Σ(areas of the triangles at the spring)/L² (Van Gelder 1998). Springs that cross a side of two
/// triangles count these two; a crossed grid, and a net with such flips, counts both kinds at half weight. Satisfies
/// Σ k L² = 3 E A t of one isotropic material. In space E·Σ(volumes of the tetrahedra at the spring)/L², Σ k L² = 6 E
/// V. Refusal for a net that is neither a grid nor made of triangles.
[[nodiscard]] std::vector<double> area_stiffness(const Net& net, const MaterialField& material);
/// `lattice`: what makes the net deform exactly as a body with ν' = 1/3 does. Each crossed square cell gives its sides
/// and diagonals ⅜E't, so an axial spring gets ¾E't inside and ⅜E't on the outline; each equilateral triangle gives
/// its sides (√3/4)E't, so a spring gets (√3/2)E't inside and half of that on the outline.
/// In space, on cubes of side a with the diagonals of their faces: 0.4 E a for each spring, half of it on a face of the
/// body and a quarter on an edge, exact at ν = ¼.
/// Refusal unless the net is made of such cells, all of one size, that fill the body to its outline, and the body is of
/// one isotropic material.
[[nodiscard]] std::vector<double> lattice_stiffness(const Net& net, const MaterialField& material);

/// Reads the springs of a system file, {"springs": [{"nodes": [i, j], "stiffness": k}, …]}, in any order; nodes by what
/// the net calls them. Other keys than a system file's are refused; only stiffnesses are taken. Lengths of springs and
/// places of nodes [m], where the file has them, must be the net's within 1e-6 of its size: a file of another body is
/// refused.
/// InputError for a missing, doubled or unknown spring, an unknown node, or a stiffness that is not a positive number.
[[nodiscard]] std::vector<double> read_stiffness_file(InputFiles& files, const std::filesystem::path& path,
                                                      const Net& net);
/// One that no study names.
[[nodiscard]] std::vector<double> read_stiffness_file(const std::filesystem::path& path, const Net& net);

/// What a system file says beyond nodes and springs; what is empty is left out.
struct SystemDetails {
  std::vector<std::string> groups = {};              ///< [springs]: springs of one share a stiffness
  std::optional<std::array<double, 2>> bounds = {};  ///< within which stiffnesses were fitted
};

/// The number that "schema" has in a system file. Raised when a key changes its meaning or goes away.
inline constexpr int kSystemSchema = 1;

/// All that a simulator needs, springs and nodes in the net's order, and what a study needs to go on from there:
///     {"schema": 1, "bounds": [lower, upper],
///      "nodes": [{"node": i, "x": x, "y": y, "z": z, "mass": m}, …],
///      "springs": [{"nodes": [i, j], "stiffness": k, "length": L, "group": "chord"}, …]}
/// "mass" only where the net has masses, "z" only in space; in m, kg, N/m. Numbers have all digits that a double has.
/// A study can read it back as points, springs and start, in space as a start only; docs/your_own_system.md has every
/// key.
[[nodiscard]] std::string system_json(const Net& net, const std::vector<double>& stiffness,
                                      const SystemDetails& details = {});

class ElasticProblem;
/// The same with the problem's groups and bounds; of springs that have bounds of their own the lowest and the highest.
[[nodiscard]] std::string system_json(const ElasticProblem& problem, const std::vector<double>& stiffness);

}  // namespace nodal::elastic
