// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include <stdexcept>
#include <string>

namespace nodal::nlopt_methods {

namespace {

constexpr std::string_view kPrefix = "nlopt-";

constexpr std::string_view kDirect =
    "J. Gablonsky, C. Kelley, A locally-biased form of the DIRECT algorithm, J. Global Optimization 21, 2001";
constexpr std::string_view kMlsl =
    "A. Rinnooy Kan, G. Timmer, Stochastic global optimization methods, Math. Programming 39, 1987; S. Kucherenko, "
    "Y. Sytsko, Computational Optimization and Applications 30, 2005";
constexpr std::string_view kConservative =
    "K. Svanberg, A class of globally convergent optimization methods based on conservative convex separable "
    "approximations, SIAM J. Optimization 12(2), 2002";

constexpr Method kMethods[] = {
    // ── global ──────────────────────────────────────────────────────────────────────────────────────────────────────
    {.name = "nlopt-direct-l",
     .algorithm = NLOPT_GN_DIRECT_L,
     .summary = "DIRECT with a bias to promising boxes: divides the box into thirds",
     .reference = kDirect,
     .uses_start = false},
    {.name = "nlopt-direct-l-rand",
     .algorithm = NLOPT_GN_DIRECT_L_RAND,
     .summary = "DIRECT-L that draws which of equal sides it divides",
     .reference = kDirect,
     .deterministic = false,
     .uses_start = false},
    {.name = "nlopt-crs2-lm",
     .algorithm = NLOPT_GN_CRS2_LM,
     .summary = "controlled random search: reflects simplices of a random population, with local mutation",
     .reference = "P. Kaelo, M. Ali, Some variants of the controlled random search algorithm for global optimization, "
                  "J. Optimization Theory and Applications 130(2), 2006",
     .deterministic = false,
     .population = {.per_freedom = 10}},
    {.name = "nlopt-isres",
     .algorithm = NLOPT_GN_ISRES,
     .summary = "evolution strategy with differential variation and self-adapted step sizes",
     .reference = "T. Runarsson, X. Yao, Search biases in constrained evolutionary optimization, IEEE Trans. Systems, "
                  "Man and Cybernetics C 35(2), 2005",
     .deterministic = false,
     .population = {.per_freedom = 20}},
    {.name = "nlopt-esch",
     .algorithm = NLOPT_GN_ESCH,
     .summary = "evolution strategy with Cauchy mutation",
     .reference = "C. da Silva Santos, M. Gonçalves, H. Hernandez-Figueroa, Designing novel photonic devices by "
                  "bio-inspired computing, IEEE Photonics Technology Letters 22(15), 2010",
     .deterministic = false,
     .population = {.constant = 40}},
    {.name = "nlopt-mlsl-lds",
     .algorithm = NLOPT_G_MLSL_LDS,
     .summary =
         "multi-level single linkage: gradient searches from points of a Sobol sequence, none twice to one minimum",
     .reference = kMlsl,
     .needs_gradient = true,
     .population = {.constant = 4},
     .local_search = LocalSearch::gradients},
    {.name = "nlopt-mlsl-lds-values",
     .algorithm = NLOPT_G_MLSL_LDS,
     .summary = "multi-level single linkage with local searches that need no derivatives",
     .reference = kMlsl,
     .population = {.constant = 4},
     .local_search = LocalSearch::values},

    // ── local, values only ──────────────────────────────────────────────────────────────────────────────────────────
    {.name = "nlopt-sbplx",
     .algorithm = NLOPT_LN_SBPLX,
     .summary = "Subplex: Nelder-Mead on a sequence of subspaces",
     .reference = "T. Rowan, Functional stability analysis of numerical algorithms, thesis, University of Texas at "
                  "Austin, 1990",
     .local = true,
     .initial_step = true},
    {.name = "nlopt-bobyqa",
     .algorithm = NLOPT_LN_BOBYQA,
     .summary = "quadratic models interpolated in 2n + 1 points, in a trust region; for up to about 100 coordinates",
     .reference = "M. Powell, The BOBYQA algorithm for bound constrained optimization without derivatives, Cambridge "
                  "NA2009/06, 2009",
     .local = true,
     .dense_model = true,
     .initial_step = true},
    {.name = "nlopt-neldermead",
     .algorithm = NLOPT_LN_NELDERMEAD,
     .summary = "the simplex of n + 1 points, kept in the box",
     .reference = "J. Nelder, R. Mead, A simplex method for function minimization, Computer Journal 7, 1965",
     .local = true,
     .initial_step = true},

    // ── local, with gradients ───────────────────────────────────────────────────────────────────────────────────────
    {.name = "nlopt-lbfgs",
     .algorithm = NLOPT_LD_LBFGS,
     .summary = "limited-memory BFGS with bounds (Luksan's code)",
     .reference = "J. Nocedal, Updating quasi-Newton matrices with limited storage, Math. of Computation 35, 1980",
     .needs_gradient = true,
     .local = true,
     .vector_storage = true},
    {.name = "nlopt-mma",
     .algorithm = NLOPT_LD_MMA,
     .summary = "method of moving asymptotes, globally convergent",
     .reference = kConservative,
     .needs_gradient = true,
     .local = true},
    {.name = "nlopt-ccsaq",
     .algorithm = NLOPT_LD_CCSAQ,
     .summary = "conservative separable quadratic approximations",
     .reference = kConservative,
     .needs_gradient = true,
     .local = true},
    {.name = "nlopt-slsqp",
     .algorithm = NLOPT_LD_SLSQP,
     .summary = "dense BFGS with least-squares subproblems; n^3 per step, so for a few hundred coordinates",
     .reference = "D. Kraft, Algorithm 733: TOMP, ACM Trans. Mathematical Software 20(3), 1994",
     .needs_gradient = true,
     .local = true,
     .dense_model = true},
    {.name = "nlopt-tnewton",
     .algorithm = NLOPT_LD_TNEWTON_PRECOND_RESTART,
     .summary = "truncated Newton, preconditioned and restarted; differences of gradients stand for the Hessian",
     .reference =
         "R. Dembo, T. Steihaug, Truncated-Newton algorithms for large-scale unconstrained optimization, Math. "
         "Programming 26, 1983",
     .needs_gradient = true,
     .local = true,
     .vector_storage = true},
    {.name = "nlopt-var2",
     .algorithm = NLOPT_LD_VAR2,
     .summary = "shifted limited-memory variable metric, rank 2",
     .reference = "J. Vlcek, L. Luksan, Shifted limited-memory variable metric methods for large-scale unconstrained "
                  "optimization, J. Computational and Applied Mathematics 186, 2006",
     .needs_gradient = true,
     .local = true,
     .vector_storage = true},
};

constexpr LeftOutMethod kLeftOut[] = {
    {"nlopt-cobyla",
     "COBYLA is left out: it can hang in spite of every limit that NLopt knows (nlopt#370) and lose its best "
     "point (nlopt#57); nlopt-bobyqa is the method to take without derivatives"},
    {"nlopt-stogo",
     "StoGO is left out: it can't be stopped from inside and can lose its best point (nlopt#504); "
     "nlopt-mlsl-lds is the global method with gradients"},
    {"nlopt-ags",
     "AGS is left out: it takes at most 10 coordinates and crashes when a cost is infinite; nlopt-direct-l "
     "divides the box too"},
};

}  // namespace

std::span<const Method> all_methods() { return kMethods; }

std::span<const LeftOutMethod> left_out_methods() { return kLeftOut; }

const Method& find_method(std::string_view short_name) {
  for (const Method& method : kMethods) {
    if (method.name.substr(kPrefix.size()) == short_name) return method;
  }
  throw std::logic_error("NLopt adapter: no method '" + std::string(short_name) + "'");
}

std::vector<std::string_view> local_methods(LocalSearch kind) {
  std::vector<std::string_view> names;
  for (const Method& method : kMethods) {
    if (method.local && method.needs_gradient == (kind == LocalSearch::gradients))
      names.push_back(method.name.substr(kPrefix.size()));
  }
  return names;
}

}  // namespace nodal::nlopt_methods
