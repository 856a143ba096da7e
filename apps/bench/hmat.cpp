// SPDX-License-Identifier: GPL-3.0-or-later
// Beside clusters.cpp: the same matrix as a hierarchical one of hmat-oss, far blocks compressed by adaptive
// cross approximation and kept. Degree 1, inset 1/6. The argument `digits` is the tolerance of the
// compression, 10^-digits. An entry is taken by one rule of 16 points, near or far: what is compared is how
// the far blocks are held, and near entries are not those of clusters.cpp. hmat-oss works in one thread.
#include <benchmark/benchmark.h>
#include <hmat/hmat.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "radcert/collocation/nodes.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/polynomial/triangle_basis.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert::bench {
namespace {

constexpr double rho_over_pi = 0.5 / 3.14159265358979323846;
constexpr int functions = 3;

/// Entries of the matrix by one rule an element, in the order of collocation_nodes.
class RuleEntries {
public:
  RuleEntries(const Surface& surface, int level) {
    const Triangulation triangulation = triangulate(surface, level);
    const TriangleBasis<double> basis(InsetBasis<double>(1, 1.0 / 6));
    nodes_ = collocation_nodes<double>(surface, triangulation, basis);
    const TriangleRule<double> rule = conical_rule<double>(order, Grading::none);
    for (const ParameterTriangle& triangle : triangulation.triangles) {
      const auto& v = triangle.vertices;
      const double parallelogram = cross(v[1] - v[0], v[2] - v[0]);
      const ChartIn<double>& chart = surface.charts[triangle.chart].in<double>();
      for (std::size_t q = 0; q < rule.weights.size(); ++q) {
        const Frame<double> frame = chart.frame(triangle.at(rule.points[q].x));
        std::array<double, functions> values{};
        basis.values(rule.points[q], values);
        Point point{.at = frame.point, .normal = unit_normal(frame), .weights = {}};
        for (int j = 0; j < functions; ++j)
          point.weights[j] = rho_over_pi * rule.weights[q] * parallelogram * area_element(frame) * values[j];
        points_.push_back(point);
      }
      points_of_element_ = rule.weights.size();
    }
  }

  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] std::vector<double> coordinates() const {
    std::vector<double> out;
    for (const CollocationPoint<double>& node : nodes_)
      out.insert(out.end(), {node.point.x, node.point.y, node.point.z});
    return out;
  }
  [[nodiscard]] double operator()(int row, int column) const {
    const CollocationPoint<double>& node = nodes_[static_cast<std::size_t>(row)];
    const auto [element, j] = std::div(column, functions);
    double sum = 0;
    for (const Point& q : std::span(points_).subspan(static_cast<std::size_t>(element) * points_of_element_,
                                                     points_of_element_))
      sum +=
          q.weights[static_cast<std::size_t>(j)] * geometric_kernel(node.point, node.normal, q.at, q.normal);
    return sum;
  }

private:
  struct Point {
    Vector<double> at;
    Vector<double> normal;
    std::array<double, functions> weights;
  };
  static constexpr int order = 4;
  std::vector<CollocationPoint<double>> nodes_;
  std::vector<Point> points_;
  std::size_t points_of_element_ = 0;
};

/// The matrix as hmat-oss holds it.
class Hierarchical {
public:
  Hierarchical(const RuleEntries& entries, double tolerance) : size_(entries.size()) {
    hmat_init_default_interface(&hmat_, HMAT_DOUBLE_PRECISION);
    hmat_settings_t settings;
    hmat_get_parameters(&settings);
    settings.maxLeafSize = leaf_size;
    hmat_set_parameters(&settings);
    if (hmat_.init() != 0) throw std::runtime_error("hmat-oss cannot be begun");
    std::vector<double> coordinates = entries.coordinates();
    hmat_clustering_algorithm_t* clustering = hmat_create_clustering_median();
    tree_ = hmat_create_cluster_tree(coordinates.data(), 3, static_cast<int>(size_), clustering);
    hmat_delete_clustering(clustering);
    hmat_admissibility_t* admissible = hmat_create_admissibility_standard(eta);
    matrix_ = hmat_.create_empty_hmatrix_admissibility(tree_, tree_, 0, admissible);
    hmat_delete_admissibility(admissible);
    hmat_.set_low_rank_epsilon(matrix_, tolerance);
    hmat_assemble_context_t context;
    hmat_assemble_context_init(&context);
    context.compression = hmat_create_compression_aca_plus(tolerance);
    context.simple_compute = [](void* of, int row, int column, void* result) {
      *static_cast<double*>(result) = (*static_cast<const RuleEntries*>(of))(row, column);
    };
    context.user_context = const_cast<RuleEntries*>(&entries);
    context.progress = nullptr;
    if (hmat_.assemble_generic(matrix_, &context) != 0) throw std::runtime_error("hmat-oss: assembly");
    hmat_delete_compression(context.compression);
  }
  ~Hierarchical() {
    hmat_.destroy(matrix_);
    hmat_delete_cluster_tree(tree_);
    hmat_.finalize();
  }
  Hierarchical(const Hierarchical&) = delete;
  Hierarchical& operator=(const Hierarchical&) = delete;

  void multiply(std::vector<double>& x, std::vector<double>& y) const {
    double one = 1;
    double zero = 0;
    hmat_.gemv('N', &one, matrix_, x.data(), &zero, y.data(), 1);
  }
  [[nodiscard]] double bytes_an_unknown() const {
    hmat_info_t info;
    hmat_.get_info(matrix_, &info);
    return static_cast<double>(info.compressed_size) * sizeof(double) / static_cast<double>(size_);
  }

private:
  static constexpr int leaf_size = 100;
  static constexpr double eta = 2;
  std::size_t size_;
  hmat_interface_t hmat_{};
  hmat_cluster_tree_t* tree_ = nullptr;
  hmat_matrix_t* matrix_ = nullptr;
};

/// The largest difference of the product with 1 from rows of the rule's entries, of 20 rows.
double error_of(const RuleEntries& entries, const std::vector<double>& of_one) {
  constexpr std::size_t rows = 20;
  double largest = 0;
  for (std::size_t k = 0; k < rows; ++k) {
    const std::size_t row = k * (entries.size() - 1) / (rows - 1);
    double sum = 0;
    for (std::size_t j = 0; j < entries.size(); ++j)
      sum += entries(static_cast<int>(row), static_cast<int>(j));
    largest = std::max(largest, std::abs(sum - of_one[row]));
  }
  return largest;
}

void make_and_multiply(benchmark::State& state, const Surface& surface) {
  const RuleEntries entries(surface, static_cast<int>(state.range(0)));
  const double tolerance = std::pow(10.0, -static_cast<double>(state.range(1)));
  const bool product = state.range(2) != 0;
  std::unique_ptr<Hierarchical> k;
  const auto make = [&] {
    k.reset();
    k = std::make_unique<Hierarchical>(entries, tolerance);
  };
  std::vector<double> x(entries.size(), 1.0);
  std::vector<double> y(entries.size());
  if (product) make();
  for (auto step : state) {
    if (product)
      k->multiply(x, y);
    else
      make();
  }
  k->multiply(x, y);
  state.counters["unknowns"] = static_cast<double>(entries.size());
  state.counters["bytes_an_unknown"] = k->bytes_an_unknown();
  state.counters["error_of_K1"] = error_of(entries, y);
}

void of(const std::string& name, const Surface& surface, const std::vector<std::int64_t>& levels) {
  benchmark::internal::Benchmark* const one =
      benchmark::RegisterBenchmark(("hmat_oss/" + name).c_str(),
                                   [surface](benchmark::State& state) { make_and_multiply(state, surface); });
  one->ArgNames({"level", "digits", "product"})->UseRealTime()->Unit(benchmark::kSecond);
  for (const std::int64_t level : levels)
    for (const std::int64_t digits : {6, 12})
      for (const std::int64_t product : {0, 1}) one->Args({level, digits, product});
}

const bool registered = [] {
  of("ellipsoid 1 3/2 2", ellipsoid(1, Rational(3, 2), 2), {4, 5, 6});
  of("cube", cube(), {4, 5, 6});
  return true;
}();

}  // namespace
}  // namespace radcert::bench
