// SPDX-License-Identifier: GPL-3.0-or-later
// The operator of clusters against entries that are integrated one by one, within the radii of both:
//   cluster_agreement columns SURFACE DEGREE LEVEL TOLERANCE [COUNT]   columns in all rows, against the dense
//                                                                      matrix; all of them without COUNT
//   cluster_agreement rows SURFACE DEGREE LEVEL TOLERANCE COUNT        rows times random signs, without a
//                                                                      matrix; those at the corners of the
//                                                                      charts' domains are always among them
//   either with a GRADING after COUNT                                  on a graded triangulation
//   cluster_agreement all TOLERANCE [UNKNOWNS [PART PARTS]]            all columns for degrees 0 to 8 on each
//                                                                      closed surface, at the finest level
//                                                                      of at most so many unknowns (6144);
//                                                                      of this list every PARTS-th case from
//                                                                      PART on
// Prints the largest difference in parts of the radius. Exit code 1 where one exceeds it.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "radcert/clusters/cluster_operator.h"
#include "radcert/clusters/cluster_tree.h"
#include "radcert/collocation/assembly.h"
#include "radcert/collocation/nodes.h"
#include "radcert/core/memory_plan.h"
#include "radcert/core/parallel.h"
#include "radcert/quadrature/collocation_point_block.h"
#include "radcert/quadrature/element_integrator.h"
#include "radcert/surface/catalogue.h"

namespace radcert::bench {
namespace {

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Discretisation {
  Surface surface;
  int level;
  double grading;
  Triangulation triangulation;
  TriangleBasis<double> basis;
  std::vector<CollocationPoint<double>> nodes;
  std::vector<double> rho;
};

Discretisation discretisation(const Surface& surface, int degree, int level, double grading = 1) {
  Discretisation d{surface, level, grading, {}, InsetBasis<double>(degree, 1.0 / 6), {}, {}};
  d.triangulation = triangulate(d.surface, level, {.diagonals = std::nullopt, .grading = grading});
  d.nodes = collocation_nodes<double>(d.surface, d.triangulation, d.basis);
  d.rho.assign(d.nodes.size(), 0.5);
  return d;
}

Discretisation discretisation(const std::string& name, int degree, int level, double grading) {
  const SurfaceDescription* found = find_surface(name);
  if (found == nullptr) throw std::invalid_argument("no surface " + name);
  return discretisation(default_surface(*found), degree, level, grading);
}

std::unique_ptr<const ClusterOperator> clusters_of(const Discretisation& d, double tolerance,
                                                   std::optional<int> refinements = std::nullopt) {
  const double begin = seconds();
  const int cuts = refinements.value_or(leaf_refinements(d.basis.size()));
  const ClusterTree tree = (d.grading == 1 ? ClusterTree::make(d.triangulation, d.level, cuts)
                                           : ClusterTree::graded(d.triangulation, d.level, cuts))
                               .value();
  auto made =
      std::make_unique<const ClusterOperator>(ClusterOperator::Setting{.surface = d.surface,
                                                                       .tree = tree,
                                                                       .part = ClusterPart(tree),
                                                                       .basis = d.basis,
                                                                       .nodes = d.nodes,
                                                                       .reflectivity = d.rho,
                                                                       .far = ClusterTolerance(tolerance),
                                                                       .memory_limit = available_memory()});
  const ClusterOperator& k = *made;
  std::cerr << d.surface.name << ", degree " << d.basis.degree() << ", " << d.nodes.size()
            << " unknowns: set-up " << seconds() - begin << " s, near entries an unknown "
            << static_cast<double>(k.near_entries().size()) / static_cast<double>(d.nodes.size())
            << ", evaluations an unknown "
            << static_cast<double>(k.couplings().evaluations()) / static_cast<double>(d.nodes.size())
            << std::endl;
  return made;
}

/// The nodes of the elements at the corners of the charts' domains, and others at random.
std::vector<std::size_t> chosen(const Discretisation& d, std::size_t count) {
  const std::size_t p = d.basis.size();
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < d.triangulation.triangles.size(); ++k) {
    const auto& vertices = d.triangulation.triangles[k].vertices;
    const bool at_corner = std::any_of(vertices.begin(), vertices.end(), [](const auto& v) {
      return (v.s == 0 || v.s == 1) && (v.t == 0 || v.t == 1);
    });
    if (at_corner)
      for (std::size_t j = 0; j < p; ++j) places.push_back(k * p + j);
  }
  std::mt19937 random(1);
  for (std::size_t i = 0; i < count; ++i) places.push_back(random() % d.nodes.size());
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// Differences between an operator and the dense matrix, in parts of the radii of both.
struct Difference {
  double entry = 0;  ///< the largest of an entry, in parts of the radius of its row
  double row = 0;    ///< the largest of a row, all sizes added
};

Difference difference(const Discretisation& d, const ClusterOperator& k,
                      const CollocationMatrix<double>& dense, const std::vector<std::size_t>& which) {
  const std::size_t n = d.nodes.size();
  constexpr std::size_t at_a_time = 64;
  std::vector<double> products(at_a_time * n);
  std::vector<double> sums(n);
  Difference worst;
  for (std::size_t first = 0; first < which.size(); first += at_a_time) {
    const std::size_t count = std::min(at_a_time, which.size() - first);
    parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
      std::vector<double> unit(n);
      for (std::size_t c = begin; c < end; ++c) {
        unit[which[first + c]] = 1;
        k.multiply(unit, std::span(products).subspan(c * n, n));
        unit[which[first + c]] = 0;
      }
    });
    for (std::size_t c = 0; c < count; ++c)
      for (std::size_t i = 0; i < n; ++i) {
        const double off = std::abs(products[c * n + i] - dense.entries(i, which[first + c]));
        sums[i] += off;
        worst.entry = std::max(worst.entry, off / (k.row_radius()[i] + dense.row_radius[i]));
      }
  }
  for (std::size_t i = 0; i < n; ++i)
    worst.row = std::max(worst.row, sums[i] / (k.row_radius()[i] + dense.row_radius[i]));
  return worst;
}

std::vector<std::size_t> all_columns(const Discretisation& d) {
  std::vector<std::size_t> which(d.nodes.size());
  std::iota(which.begin(), which.end(), std::size_t{0});
  return which;
}

double columns(const Discretisation& d, double tolerance, std::size_t count) {
  const CollocationMatrix<double> dense =
      assemble<double>(d.surface, d.triangulation, d.basis, d.nodes, d.rho);
  const std::unique_ptr<const ClusterOperator> k = clusters_of(d, tolerance);
  const std::vector<std::size_t> which = count < d.nodes.size() ? chosen(d, count) : all_columns(d);
  const Difference worst = difference(d, *k, dense, which);
  std::cout << "  " << which.size() << " columns: an entry differs by " << worst.entry
            << " of its row's radius at most, the sum over a row by " << worst.row << std::endl;
  return worst.row;
}

/// A surface of the catalogue and a degree, at the finest level of at most so many unknowns.
struct Case {
  Surface surface;
  int degree;
  int level;
};

std::vector<Case> all_cases(std::size_t most_unknowns) {
  constexpr int largest_degree = InsetBasis<double>::largest_degree;
  std::vector<Case> cases;
  for (int degree = 0; degree <= largest_degree; ++degree)
    for (const SurfaceDescription& each : surface_catalogue()) {
      const Surface surface = default_surface(each);
      if (!surface.closed || obstacle_to_clusters(surface)) continue;
      const std::size_t functions = InsetBasis<double>(degree, 1.0 / 6).size();
      const auto unknowns = [&](int level) {
        return triangulate(surface, level).triangles.size() * functions;
      };
      int level = 0;
      while (unknowns(level + 1) <= most_unknowns) ++level;
      cases.push_back({surface, degree, level});
    }
  return cases;
}

/// An operator that couples: with leaves of the usual size, else with smaller ones, else with the tolerance
/// multiplied by ten until pairs of elements couple.
struct Coupled {
  int refinements;
  double tolerance;
  std::unique_ptr<const ClusterOperator> k;
};

Coupled coupled(const Discretisation& d, double tolerance) {
  const int usual = std::min(leaf_refinements(d.basis.size()), d.level);
  Coupled made{usual, tolerance, clusters_of(d, tolerance, usual)};
  const auto couples = [&] { return made.k->couplings().evaluations() >= d.nodes.size(); };
  while (!couples() && made.refinements > 0) {
    const int smaller = made.refinements - 1;
    made = {smaller, tolerance, clusters_of(d, tolerance, smaller)};
  }
  constexpr double coarser = 10;
  while (!couples() && made.tolerance * coarser <= ClusterTolerance::coarsest * (1 + 0x1p-30)) {
    const double next = std::min(made.tolerance * coarser, ClusterTolerance::coarsest);
    made = {0, next, clusters_of(d, next, 0)};
  }
  return made;
}

double all_columns_of(const Case& one, double tolerance) {
  const double begin = seconds();
  const Discretisation d = discretisation(one.surface, one.degree, one.level);
  const CollocationMatrix<double> dense =
      assemble<double>(d.surface, d.triangulation, d.basis, d.nodes, d.rho);
  const Coupled made = coupled(d, tolerance);
  const std::vector<double>& radii = made.k->row_radius();
  const Difference worst = difference(d, *made.k, dense, all_columns(d));
  std::printf("| %s | %d | %zu | %d | %.0e | %.0f | %.1e | %.2g | %.2g | %.0f s |\n", d.surface.name.c_str(),
              one.degree, d.nodes.size(), 1 << (2 * made.refinements), made.tolerance,
              static_cast<double>(made.k->couplings().evaluations()) / static_cast<double>(d.nodes.size()),
              *std::max_element(radii.begin(), radii.end()), worst.entry, worst.row, seconds() - begin);
  std::fflush(stdout);
  return worst.row;
}

double all(const std::vector<std::string>& words) {
  const double tolerance = std::stod(words[1]);
  constexpr std::size_t design_unknowns = 6144;
  const std::vector<Case> cases = all_cases(words.size() > 2 ? std::stoul(words[2]) : design_unknowns);
  const std::size_t parts = words.size() > 4 ? std::stoul(words[4]) : 1;
  std::printf(
      "| surface | degree | unknowns | elements a leaf | tolerance | evaluations of G an unknown "
      "| largest radius | entry | row | time |\n|---|---|---|---|---|---|---|---|---|---|\n");
  double worst = 0;
  for (std::size_t i = words.size() > 4 ? std::stoul(words[3]) : 0; i < cases.size(); i += parts)
    worst = std::max(worst, all_columns_of(cases[i], tolerance));
  return worst;
}

double rows(const Discretisation& d, double tolerance, std::size_t count) {
  const std::unique_ptr<const ClusterOperator> made = clusters_of(d, tolerance);
  const ClusterOperator& k = *made;
  const std::size_t n = d.nodes.size();
  const std::size_t p = d.basis.size();
  std::vector<std::size_t> places = chosen(d, count);
  constexpr std::size_t vectors = 4;
  std::mt19937 random(2);
  std::vector<std::vector<double>> x(vectors, std::vector<double>(n));
  for (std::vector<double>& each : x)
    for (double& entry : each) entry = random() % 2 == 0 ? 1 : -1;
  std::vector<CollocationPoint<double>> observers;
  for (const std::size_t place : places) observers.push_back(d.nodes[place]);
  const auto scheme = std::make_shared<const IntegrationScheme<double>>(d.surface, d.basis, Tolerance());
  const std::vector<CollocationPointBlock<double>> blocks = observer_blocks<double>(observers);
  std::vector<double> exact(places.size() * vectors);
  std::vector<double> radius(places.size());
  const double begin = seconds();
  parallel_for(blocks.size(), 1, [&](std::size_t first, std::size_t last) {
    BlockIntegral<double> integral;
    for (std::size_t b = first; b < last; ++b)
      for (std::size_t e = 0; e < d.triangulation.triangles.size(); ++e) {
        ElementIntegrator<double> element(scheme, d.triangulation.triangles[e]);
        element.integrate(blocks[b], observers, integral);
        for (std::size_t lane = 0; lane < blocks[b].count; ++lane) {
          const std::size_t row = blocks[b].first + lane;
          const double factor = 0.5 / pi<double>();
          for (std::size_t j = 0; j < p; ++j) {
            for (std::size_t v = 0; v < vectors; ++v)
              exact[row * vectors + v] += factor * integral.value[j].lane(lane) * x[v][e * p + j];
            radius[row] += factor * integral.radius[j].lane(lane);
          }
        }
      }
  });
  std::cout << "  direct integration of " << places.size() << " rows: " << seconds() - begin << " s"
            << std::endl;
  double worst = 0;
  std::vector<double> y(n);
  for (std::size_t v = 0; v < vectors; ++v) {
    const double start = seconds();
    k.multiply(x[v], y);
    if (v == 0) std::cout << "  product " << seconds() - start << " s" << std::endl;
    for (std::size_t row = 0; row < places.size(); ++row) {
      const double rounding = 4e-15 * std::sqrt(static_cast<double>(n));
      worst = std::max(worst, std::abs(y[places[row]] - exact[row * vectors + v]) /
                                  (k.row_radius()[places[row]] + radius[row] + rounding));
    }
  }
  std::cout << "  rows times random signs differ by " << worst << " of their radius at most" << std::endl;
  return worst;
}

int run(const std::vector<std::string>& words) {
  if (!words.empty() && words[0] == "all" && words.size() > 1) return all(words) <= 1 ? 0 : 1;
  if (words.size() < 5) {
    std::cerr << "cluster_agreement columns|rows SURFACE DEGREE LEVEL TOLERANCE [COUNT [GRADING]]\n"
                 "cluster_agreement all TOLERANCE [UNKNOWNS [PART PARTS]]\n";
    return 2;
  }
  const double grading = words.size() > 6 ? std::stod(words[6]) : 1;
  const Discretisation d = discretisation(words[1], std::stoi(words[2]), std::stoi(words[3]), grading);
  const double tolerance = std::stod(words[4]);
  const std::size_t count = words.size() > 5 ? std::stoul(words[5]) : d.nodes.size();
  const double worst = words[0] == "rows" ? rows(d, tolerance, count) : columns(d, tolerance, count);
  return worst <= 1 ? 0 : 1;
}

}  // namespace
}  // namespace radcert::bench

int main(int count, char** words) {
  try {
    return radcert::bench::run({words + 1, words + count});
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 3;
  }
}
