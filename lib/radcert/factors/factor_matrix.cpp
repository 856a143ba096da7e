// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/factor_matrix.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <chrono>
#include <cmath>
#include <string_view>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/parallel.h"
#include "radcert/factors/certified_exchange.h"
#include "radcert/factors/visible_exchange.h"

namespace radcert {

namespace {

/// Rows of the upper triangle of the matrix of triangles that are computed together.
struct RowBlock {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::vector<std::size_t> offset;  ///< of each row's first pair
  std::size_t pairs = 0;

  [[nodiscard]] std::pair<std::size_t, std::size_t> pair(std::size_t k) const {
    const auto above = std::upper_bound(offset.begin(), offset.end(), k);
    const auto row = static_cast<std::size_t>(above - offset.begin()) - 1;
    return {begin + row, begin + row + 1 + (k - offset[row])};
  }
};

/// Blocks of at least so many pairs: large enough that threads have work, small enough that an interruption
/// loses little.
constexpr std::size_t pairs_of_block = 8192;

std::vector<RowBlock> row_blocks(std::size_t triangles) {
  std::vector<RowBlock> blocks;
  for (std::size_t row = 0; row < triangles;) {
    RowBlock block;
    block.begin = row;
    while (row < triangles && block.pairs < pairs_of_block) {
      block.offset.push_back(block.pairs);
      block.pairs += triangles - ++row;
    }
    block.end = row;
    blocks.push_back(std::move(block));
  }
  return blocks;
}

std::string bits_text(double x) {
  std::array<char, 2 * sizeof(double)> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), std::bit_cast<std::uint64_t>(x), 16).ptr;
  return {digits.data(), end};
}

std::string stored_text(const std::vector<PairExchange>& pairs) {
  std::string out;
  for (const PairExchange& pair : pairs) {
    out += static_cast<char>('0' + static_cast<int>(pair.sight));
    if (pair.area.value != 0 || pair.area.radius != 0)
      out += bits_text(pair.area.value) + "," + bits_text(pair.area.radius);
    out += ';';
  }
  return out;
}

bool read_number(std::string_view& text, char end, double& number) {
  std::uint64_t bits = 0;
  const auto [after, error] = std::from_chars(text.data(), text.data() + text.size(), bits, 16);
  if (error != std::errc() || after == text.data() + text.size() || *after != end) return false;
  number = std::bit_cast<double>(bits);
  text.remove_prefix(static_cast<std::size_t>(after - text.data()) + 1);
  return true;
}

/// What stored_text wrote of pairs with proved or estimated radii; nothing where it is not so many.
std::optional<std::vector<PairExchange>> stored_pairs(std::string_view text, std::size_t count,
                                                      bool guaranteed) {
  std::vector<PairExchange> pairs(count);
  for (PairExchange& pair : pairs) {
    if (text.size() < 2 || text[0] < '0' || text[0] > '3') return std::nullopt;
    pair.sight = static_cast<PairSight>(text[0] - '0');
    text.remove_prefix(1);
    if (text[0] == ';') {
      text.remove_prefix(1);
      continue;
    }
    if (!read_number(text, ',', pair.area.value) || !read_number(text, ';', pair.area.radius))
      return std::nullopt;
    pair.area.guaranteed = guaranteed;
  }
  return text.empty() ? std::optional(std::move(pairs)) : std::nullopt;
}

/// The matrix of exchange areas between units, of which half is kept.
class ExchangeSums {
public:
  explicit ExchangeSums(std::size_t units)
      : units_(units), sums_(units * (units + 1) / 2, Approximation::exact(0)) {}
  Approximation& at(std::size_t a, std::size_t b) {
    const std::size_t low = std::min(a, b);
    const std::size_t high = std::max(a, b);
    return sums_[high * (high + 1) / 2 + low];
  }
  [[nodiscard]] std::size_t size() const { return units_; }

private:
  std::size_t units_;
  std::vector<Approximation> sums_;
};

/// The ball's own midpoint keeps no more digits than the radius leaves; the quotient of values keeps
/// reciprocity.
Approximation quotient(const Approximation& exchange, const Approximation& area) {
  const double value = exchange.value / area.value;
  return {value, abs(ball_of(exchange) / ball_of(area) - Ball(value)).upper_double(),
          exchange.guaranteed && area.guaranteed};
}

/// A bound of |A_I F_IJ - A_J F_JI| / sqrt(A_I A_J) for these doubles: in double the products of which it is
/// the difference would be rounded to the same number.
double reciprocity_defect(double area, double factor, double other_area, double back) {
  const Ball difference = Ball(area) * Ball(factor) - Ball(other_area) * Ball(back);
  return (abs(difference) / sqrt(Ball(area) * Ball(other_area))).upper_double();
}

void finish(FactorMatrix& matrix, ExchangeSums& sums, const FactorDemand& demand) {
  for (std::size_t i = 0; i < sums.size(); ++i) {
    FactorRow& row = matrix.rows[i];
    for (std::size_t j = 0; j < sums.size(); ++j) {
      Approximation exchange = sums.at(i, j);
      if (exchange.value == 0 && exchange.radius == 0) continue;
      // Both orders of two triangles of one unit.
      if (i == j) exchange = exchange + exchange;
      const Approximation factor = quotient(exchange, row.area);
      matrix.entries.push_back({i, j, factor});
      row.sum += factor;
      const Approximation& other = matrix.rows[j].area;
      const double back = quotient(exchange, other).value;
      matrix.largest_reciprocity_defect =
          std::max(matrix.largest_reciprocity_defect,
                   reciprocity_defect(row.area.value, factor.value, other.value, back));
    }
    if (demand.open_to_space) row.to_space = Approximation::exact(1) + -row.sum;
  }
}

std::string block_key(const FactorProgress& progress, const FactorDemand& demand, const RowBlock& block) {
  return progress.key + (demand.certified ? "\ncertified " : "\naccuracy ") + bits_text(demand.accuracy) +
         "\nrows " + std::to_string(block.begin) + " to " + std::to_string(block.end);
}

std::vector<PairExchange> block_pairs(const FacetScene& scene, const FactorDemand& demand,
                                      const RowBlock& block) {
  std::vector<PairExchange> pairs(block.pairs);
  const long bits = BallPrecision::current();
  constexpr std::size_t grain = 16;  // pairs differ much in cost
  parallel_for(block.pairs, grain, [&](std::size_t begin, std::size_t end) {
    const BallPrecision inside(bits);
    for (std::size_t k = begin; k < end; ++k) {
      const auto [i, j] = block.pair(k);
      pairs[k] = pair_exchange(scene, i, j, demand);
    }
  });
  return pairs;
}

}  // namespace

double FactorMatrix::largest_radius() const {
  double largest = 0;
  for (const ConfigurationFactor& entry : entries) largest = std::max(largest, entry.factor.radius);
  return largest;
}

double FactorMatrix::closure_defect(std::size_t row) const { return std::abs(rows[row].sum.value - 1); }

std::size_t FactorMatrix::worst_row() const {
  std::size_t worst = 0;
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (closure_defect(i) > closure_defect(worst)) worst = i;
  return worst;
}

PairExchange pair_exchange(const FacetScene& scene, std::size_t first, std::size_t second,
                           const FactorDemand& demand) {
  const FacetPair pair = scene.pair(first, second);
  PairExchange out{.sight = pair.sight};
  if (pair.sight == PairSight::nothing || pair.sight == PairSight::hidden) return out;
  if (demand.certified) {
    const double share = std::max(scene.area(first), scene.area(second)) / scene.total_area();
    // Shares of all shadows, each of which may come out twice as wide as was asked for.
    const double shadows = std::max(1.0, 2 * static_cast<double>(pair.occluders.size()));
    const CertifiedDemand certified{.radius = demand.accuracy * share / shadows};
    out.area = enclosing(certified_exchange_area(scene, first, second, pair, certified));
  } else if (pair.sight == PairSight::whole) {
    out.area = exchange_area(pair.first, pair.second);
  } else {
    const double share = scene.area(first) * scene.area(second) / scene.total_area();
    out.area = visible_exchange_area(scene, pair, {.tolerance = demand.accuracy * share});
  }
  return out;
}

FactorPlan factor_plan(const FacetScene& scene, const FactorUnits& units, const FactorDemand& demand) {
  using Clock = std::chrono::steady_clock;
  FactorPlan plan;
  const std::uint64_t n = scene.facet_count();
  const std::uint64_t m = units.names.size();
  plan.pairs = n * (n - 1) / 2;
  plan.memory.add("exchange areas", m * (m + 1) / 2, sizeof(Approximation));
  plan.memory.add("factors", m * m, sizeof(ConfigurationFactor));
  plan.memory.add("table", m * m, 64);
  if (plan.pairs == 0) return plan;
  // The additive sequence of the plastic number's powers fills the square of rows and columns evenly,
  // whatever the mesh's order.
  constexpr double row_step = 0.7548776662466927;
  constexpr double column_step = 0.5698402909980532;
  // Few pairs may take nearly all of the time: one in fifty is timed, of small scenes 64.
  constexpr std::uint64_t most_samples = 4096;
  constexpr std::uint64_t least_samples = 64;
  constexpr double most_seconds = 2;
  const std::uint64_t wanted = std::clamp(plan.pairs / 50, least_samples, most_samples);
  const auto start = Clock::now();
  double seconds = 0;
  std::uint64_t samples = 0;
  const auto place = [](std::uint64_t k, double step, std::uint64_t count) {
    const double turns = static_cast<double>(k) * step;
    return std::min(static_cast<std::uint64_t>((turns - std::floor(turns)) * static_cast<double>(count)),
                    count - 1);
  };
  while (samples < wanted && seconds < most_seconds) {
    ++samples;
    const std::uint64_t row = place(samples, row_step, n);
    const std::uint64_t column = (row + 1 + place(samples, column_step, n - 1)) % n;
    static_cast<void>(pair_exchange(scene, row, column, demand));
    seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
  plan.seconds = seconds / static_cast<double>(samples) * static_cast<double>(plan.pairs) /
                 static_cast<double>(thread_count());
  return plan;
}

FactorMatrix factor_matrix(const FacetScene& scene, const FactorUnits& units, const FactorDemand& demand,
                           const FactorProgress& progress) {
  expects(units.of_triangle.size() == scene.facet_count(), "a unit for each triangle",
          named("units", units.of_triangle.size()));
  FactorMatrix matrix;
  matrix.guaranteed = demand.certified;
  matrix.rows.resize(units.names.size());
  for (std::size_t t = 0; t < scene.facet_count(); ++t) {
    expects(units.of_triangle[t] < units.names.size(), "units have names",
            named("unit", units.of_triangle[t]));
    matrix.rows[units.of_triangle[t]].area += enclosing(certified_area(scene, t));
  }
  for (const FactorRow& row : matrix.rows) expects(row.area.value > 0, "each unit has a triangle");
  ExchangeSums sums(units.names.size());
  std::size_t done = 0;
  const std::size_t all = std::max<std::size_t>(scene.facet_count() * (scene.facet_count() - 1) / 2, 1);
  for (const RowBlock& block : row_blocks(scene.facet_count())) {
    throw_if_interrupted();
    std::optional<std::vector<PairExchange>> pairs;
    if (progress.store != nullptr)
      if (const auto kept = progress.store->get(block_key(progress, demand, block)))
        pairs = stored_pairs(*kept, block.pairs, demand.certified);
    if (!pairs) {
      pairs = block_pairs(scene, demand, block);
      if (progress.store != nullptr)
        static_cast<void>(progress.store->put(block_key(progress, demand, block), stored_text(*pairs)));
    }
    for (std::size_t k = 0; k < block.pairs; ++k) {
      const auto [i, j] = block.pair(k);
      const PairExchange& pair = (*pairs)[k];
      matrix.whole_pairs += pair.sight == PairSight::whole ? 1 : 0;
      matrix.hidden_pairs += pair.sight == PairSight::hidden ? 1 : 0;
      matrix.mixed_pairs += pair.sight == PairSight::mixed ? 1 : 0;
      if (pair.area.value != 0 || pair.area.radius != 0)
        sums.at(units.of_triangle[i], units.of_triangle[j]) += pair.area;
    }
    done += block.pairs;
    progress.at(static_cast<double>(done) / static_cast<double>(all));
  }
  finish(matrix, sums, demand);
  return matrix;
}

}  // namespace radcert
