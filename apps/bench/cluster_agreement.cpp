// SPDX-License-Identifier: GPL-3.0-or-later
// The operator of clusters against entries that are integrated one by one, within the radii of both:
//   cluster_agreement columns SURFACE DEGREE LEVEL TOLERANCE [COUNT]   columns in all rows, against the dense
//                                                                      matrix; all of them without COUNT
//   cluster_agreement rows SURFACE DEGREE LEVEL TOLERANCE COUNT        rows times random signs, without a
//                                                                      matrix; those at the corners of the
//                                                                      charts' domains are always among them
// Prints the largest difference in parts of the radius. Exit code 1 where one exceeds it.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "radcert/clusters/cluster_operator.h"
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
  Triangulation triangulation;
  TriangleBasis<double> basis;
  std::vector<CollocationPoint<double>> nodes;
  std::vector<double> rho;
};

Discretisation discretisation(const std::string& name, int degree, int level) {
  const SurfaceDescription* found = find_surface(name);
  if (found == nullptr) throw std::invalid_argument("no surface " + name);
  Discretisation d{default_surface(*found), level, {}, InsetBasis<double>(degree, 1.0 / 6), {}, {}};
  d.triangulation = triangulate(d.surface, level);
  d.nodes = collocation_nodes<double>(d.surface, d.triangulation, d.basis);
  d.rho.assign(d.nodes.size(), 0.5);
  return d;
}

std::unique_ptr<const ClusterOperator> clusters_of(const Discretisation& d, double tolerance) {
  const double begin = seconds();
  auto made =
      std::make_unique<const ClusterOperator>(ClusterOperator::Setting{.surface = d.surface,
                                                                       .triangulation = d.triangulation,
                                                                       .level = d.level,
                                                                       .basis = d.basis,
                                                                       .nodes = d.nodes,
                                                                       .reflectivity = d.rho,
                                                                       .far = ClusterTolerance(tolerance),
                                                                       .memory_limit = available_memory()});
  const ClusterOperator& k = *made;
  std::cout << d.surface.name << ", degree " << d.basis.degree() << ", " << d.nodes.size()
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

double columns(const Discretisation& d, double tolerance, std::size_t count) {
  const CollocationMatrix<double> dense =
      assemble<double>(d.surface, d.triangulation, d.basis, d.nodes, d.rho);
  const std::unique_ptr<const ClusterOperator> made = clusters_of(d, tolerance);
  const ClusterOperator& k = *made;
  const std::size_t n = d.nodes.size();
  std::vector<std::size_t> which(n);
  std::iota(which.begin(), which.end(), std::size_t{0});
  if (count < n) which = chosen(d, count);
  std::vector<double> unit(n);
  std::vector<double> y(n);
  std::vector<double> sums(n);
  double worst = 0;
  for (const std::size_t j : which) {
    unit[j] = 1;
    k.multiply(unit, y);
    unit[j] = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double difference = std::abs(y[i] - dense.entries(i, j));
      sums[i] += difference;
      worst = std::max(worst, difference / (k.row_radius()[i] + dense.row_radius[i]));
    }
  }
  double worst_sum = 0;
  for (std::size_t i = 0; i < n; ++i)
    worst_sum = std::max(worst_sum, sums[i] / (k.row_radius()[i] + dense.row_radius[i]));
  std::cout << "  " << which.size() << " columns: an entry differs by " << worst
            << " of its row's radius at most, the sum over a row by " << worst_sum << std::endl;
  return worst_sum;
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
  if (words.size() < 5) {
    std::cerr << "cluster_agreement columns|rows SURFACE DEGREE LEVEL TOLERANCE [COUNT]\n";
    return 2;
  }
  const Discretisation d = discretisation(words[1], std::stoi(words[2]), std::stoi(words[3]));
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
