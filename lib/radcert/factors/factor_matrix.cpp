// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/factor_matrix.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <chrono>
#include <cmath>
#include <numeric>
#include <string_view>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/parallel.h"
#include "radcert/factors/certified_exchange.h"
#include "radcert/factors/visible_exchange.h"

namespace radcert {

namespace {

/// The pairs of triangles (i, j), i < j, row by row.
class PairList {
public:
  explicit PairList(std::size_t triangles) {
    std::size_t first = 0;
    for (std::size_t row = 0; row + 1 < triangles; first += triangles - ++row) first_of_row_.push_back(first);
    count_ = first;
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::pair<std::size_t, std::size_t> pair(std::size_t k) const {
    const auto above = std::upper_bound(first_of_row_.begin(), first_of_row_.end(), k);
    const auto row = static_cast<std::size_t>(above - first_of_row_.begin()) - 1;
    return {row, row + 1 + (k - first_of_row_[row])};
  }

private:
  std::vector<std::size_t> first_of_row_;
  std::size_t count_ = 0;
};

/// Pairs that are computed together: `first`, `first + step`, and so on, so that each block has its share of
/// every row, and what is done stands for the rest.
struct PairBlock {
  std::size_t first = 0;
  std::size_t step = 1;
  std::size_t pairs = 0;
  [[nodiscard]] std::size_t number(std::size_t k) const { return first + k * step; }
};

/// At most so many pairs: an interruption loses little. And at least so many blocks, for the time that is
/// left, but where threads would have no work.
constexpr std::size_t pairs_of_block = 8192;
constexpr std::size_t least_blocks = 40;
constexpr std::size_t least_pairs = 64;

std::vector<PairBlock> pair_blocks(std::size_t pairs) {
  const std::size_t size = std::clamp(pairs / least_blocks, least_pairs, pairs_of_block);
  // Odd, as pairs of triangles of a rectangle follow each other.
  const std::size_t count = ((pairs + size - 1) / size) | 1U;
  std::vector<PairBlock> blocks;
  for (std::size_t b = 0; b < std::min(count, pairs); ++b)
    blocks.push_back({b, count, (pairs - b + count - 1) / count});
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
  [[nodiscard]] const Approximation& at(std::size_t a, std::size_t b) const {
    const std::size_t high = std::max(a, b);
    return sums_[high * (high + 1) / 2 + std::min(a, b)];
  }
  [[nodiscard]] std::size_t size() const { return units_; }
  /// In coordinates that count this length, in place of lengths of 1.
  void count_in(const Rational& unit) {
    if (unit == Rational(1)) return;
    const Ball factor(unit * unit);
    for (Approximation& sum : sums_) {
      const double value = sum.value * factor.to_double();
      sum = {value, abs(ball_of(sum) * factor - Ball(value)).upper_double(), sum.guaranteed};
    }
  }
  /// Of the whole matrix, those that are not exactly zero.
  [[nodiscard]] std::size_t entry_count() const {
    std::size_t count = 0;
    for (std::size_t high = 0, k = 0; high < units_; ++high)
      for (std::size_t low = 0; low <= high; ++low, ++k)
        if (sums_[k].value != 0 || sums_[k].radius != 0) count += low == high ? 1 : 2;
    return count;
  }

private:
  std::size_t units_;
  std::vector<Approximation> sums_;
};

/// One row of the matrix, its area known.
struct FinishedRow {
  std::vector<ConfigurationFactor> factors;
  Approximation sum = Approximation::exact(0);
  double reciprocity_defect = 0;
};

FinishedRow finished_row(const FactorMatrix& matrix, const ExchangeSums& sums, std::size_t i) {
  FinishedRow out;
  const Approximation& area = matrix.rows[i].area;
  for (std::size_t j = 0; j < sums.size(); ++j) {
    Approximation exchange = sums.at(i, j);
    if (exchange.value == 0 && exchange.radius == 0) continue;
    // Both orders of two triangles of one unit.
    if (i == j) exchange = exchange + exchange;
    const Approximation factor = exchange_over_area(exchange, area);
    out.factors.push_back({i, j, factor});
    out.sum += factor;
    const Approximation& other = matrix.rows[j].area;
    const double back = exchange_over_area(exchange, other).value;
    out.reciprocity_defect =
        std::max(out.reciprocity_defect, reciprocity_defect(area.value, factor.value, other.value, back));
  }
  return out;
}

void finish(FactorMatrix& matrix, const ExchangeSums& sums, const FactorDemand& demand,
            const FactorProgress& progress) {
  constexpr std::size_t entries_of_block = std::size_t{1} << 18U;
  const std::size_t size = sums.size();
  const std::size_t block = std::max<std::size_t>(1, entries_of_block / std::max<std::size_t>(1, size));
  if (!progress.row) matrix.entries.reserve(sums.entry_count());
  const long bits = BallPrecision::current();
  std::vector<FinishedRow> rows;
  for (std::size_t first = 0; first < size; first += block) {
    rows.assign(std::min(block, size - first), {});
    parallel_for(rows.size(), 1, [&](std::size_t begin, std::size_t end) {
      const BallPrecision inside(bits);
      for (std::size_t k = begin; k < end; ++k) rows[k] = finished_row(matrix, sums, first + k);
    });
    for (std::size_t k = 0; k < rows.size(); ++k) {
      FactorRow& row = matrix.rows[first + k];
      row.sum = rows[k].sum;
      if (demand.open_to_space) row.to_space = Approximation::exact(1) + -row.sum;
      matrix.take(rows[k].factors, rows[k].reciprocity_defect, progress.row);
    }
  }
}

std::string block_key(const FactorProgress& progress, const FactorDemand& demand, const PairBlock& block) {
  return progress.key + (demand.certified ? "\ncertified " : "\naccuracy ") + bits_text(demand.accuracy) +
         "\npairs " + std::to_string(block.first) + " by " + std::to_string(block.step);
}

std::vector<PairExchange> block_pairs(const FacetScene& scene, const FactorDemand& demand,
                                      const PairList& list, const PairBlock& block) {
  std::vector<PairExchange> pairs(block.pairs);
  const long bits = BallPrecision::current();
  constexpr std::size_t grain = 16;  // pairs differ much in cost
  parallel_for(block.pairs, grain, [&](std::size_t begin, std::size_t end) {
    const BallPrecision inside(bits);
    for (std::size_t k = begin; k < end; ++k) {
      const auto [i, j] = list.pair(block.number(k));
      pairs[k] = pair_exchange(scene, i, j, demand);
    }
  });
  return pairs;
}

/// The pairs of a block from the store, or computed and kept there.
std::vector<PairExchange> kept_pairs(const FacetScene& scene, const FactorDemand& demand,
                                     const PairList& list, const PairBlock& block,
                                     const FactorProgress& progress) {
  if (progress.store != nullptr)
    if (const auto kept = progress.store->get(block_key(progress, demand, block)))
      if (auto pairs = stored_pairs(*kept, block.pairs, demand.certified)) return *std::move(pairs);
  std::vector<PairExchange> pairs = block_pairs(scene, demand, list, block);
  if (progress.store != nullptr)
    static_cast<void>(progress.store->put(block_key(progress, demand, block), stored_text(pairs)));
  return pairs;
}

/// The first of these blocks, one a rank, each computed by its rank; none but on the first.
std::vector<std::vector<PairExchange>> shared_blocks(
    std::span<const PairBlock> blocks, const FactorProgress& progress, bool guaranteed,
    const std::function<std::vector<PairExchange>(const PairBlock&)>& pairs_of) {
  const Ranks& ranks = *progress.ranks;
  if (ranks.count() == 1) return {pairs_of(blocks.front())};
  const bool has_one = ranks.here() < blocks.size();
  const std::vector<std::string> texts =
      ranks.gather_at_first(has_one ? stored_text(pairs_of(blocks[ranks.here()])) : std::string());
  std::vector<std::vector<PairExchange>> found;
  for (std::size_t b = 0; b < std::min(texts.size(), blocks.size()); ++b) {
    auto pairs = stored_pairs(texts[b], blocks[b].pairs, guaranteed);
    expects(pairs.has_value(), "pairs as their rank has sent them", named("rank", b));
    found.push_back(*std::move(pairs));
  }
  return found;
}

}  // namespace

Approximation exchange_over_area(const Approximation& exchange, const Approximation& area) {
  // The ball's own midpoint keeps no more digits than the radius leaves; the quotient of values keeps
  // reciprocity.
  const double value = exchange.value / area.value;
  return {value, abs(ball_of(exchange) / ball_of(area) - Ball(value)).upper_double(),
          exchange.guaranteed && area.guaranteed};
}

double reciprocity_defect(double area, double factor, double other_area, double back) {
  const Ball difference = Ball(area) * Ball(factor) - Ball(other_area) * Ball(back);
  return (abs(difference) / sqrt(Ball(area) * Ball(other_area))).upper_double();
}

void FactorMatrix::take(std::span<const ConfigurationFactor> row, double defect,
                        const std::function<void(std::span<const ConfigurationFactor>)>& sink) {
  for (const ConfigurationFactor& entry : row)
    largest_given_radius = std::max(largest_given_radius, entry.factor.radius);
  largest_reciprocity_defect = std::max(largest_reciprocity_defect, defect);
  entry_count += row.size();
  if (sink) {
    sink(row);
  } else {
    entries.insert(entries.end(), row.begin(), row.end());
  }
}

double FactorMatrix::largest_radius() const {
  double largest = largest_given_radius;
  for (const ConfigurationFactor& entry : entries) largest = std::max(largest, entry.factor.radius);
  return largest;
}

namespace {

/// What one entry of the matrix takes once its exchange area is known.
double seconds_of_entry() {
  constexpr int count = 256;
  constexpr double seconds_of_writing = 2e-6;  // a line of a table, on one thread
  const Approximation area = Approximation::proved(0.3, 0x1p-55);
  double sum = 0;
  const auto start = std::chrono::steady_clock::now();
  for (int k = 1; k <= count; ++k) {
    const Approximation exchange = Approximation::estimated(1e-3 / k, 1e-12);
    const double factor = exchange_over_area(exchange, area).value;
    const double back = exchange_over_area(exchange, area).value;
    sum += reciprocity_defect(area.value, factor, area.value, back);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  expects(sum >= 0, "defects that are not negative");
  return seconds / count / static_cast<double>(thread_count()) + seconds_of_writing;
}

/// Pairs evenly spread over the matrix, timed, with their radii.
class PairSamples {
public:
  PairSamples(const FacetScene& scene, const FactorDemand& demand) : scene_(scene), demand_(demand) {}

  /// Most pairs take next to no time and few take nearly all of it: how many light passes between is found
  /// from many samples, what they take from fewer, until the mean is known to a tenth.
  [[nodiscard]] double seconds_of_all(std::uint64_t pairs) {
    constexpr std::uint64_t most_sights = 32768;
    constexpr std::uint64_t least_sights = 64;
    constexpr double seconds_of_sights = 1.5;
    constexpr std::size_t batch = 64;
    const auto wanted = static_cast<std::size_t>(std::clamp(pairs, least_sights, most_sights));
    const auto start = Clock::now();
    while (sights_.size() < wanted && since(start) < seconds_of_sights)
      look(std::min(batch, wanted - sights_.size()));
    const double of_sight = mean(sights_);
    const double share = share_that_sees();
    const double threads = static_cast<double>(thread_count());
    double all = of_sight * static_cast<double>(pairs) / threads;
    const auto timing = Clock::now();
    for (std::size_t next = 0; next < seen_.size(); next += batch) {
      time(next, std::min(batch, seen_.size() - next));
      all = (of_sight + share * mean(exchanges_)) * static_cast<double>(pairs) / threads;
      constexpr double least_seconds = 3;
      constexpr double most_seconds = 30;
      constexpr double part_of_all = 0.01;
      constexpr double relative_error = 0.1;
      if (since(timing) > std::clamp(part_of_all * all, least_seconds, most_seconds)) break;
      if (exchanges_.size() >= 4 * batch && error_of_mean(exchanges_) < relative_error * mean(exchanges_))
        break;
    }
    return all;
  }

  /// Of the pairs that were looked at, those between which light passes.
  [[nodiscard]] double share_that_sees() const {
    return static_cast<double>(seen_.size()) / static_cast<double>(std::max<std::size_t>(1, sights_.size()));
  }

  /// Of the exchange areas that were computed.
  [[nodiscard]] double mean_radius() const { return mean(radii_); }

private:
  using Clock = std::chrono::steady_clock;
  using Pair = std::pair<std::size_t, std::size_t>;

  static double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }
  static double mean(const std::vector<double>& x) {
    return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(std::max<std::size_t>(1, x.size()));
  }
  static double error_of_mean(const std::vector<double>& x) {
    const double middle = mean(x);
    double squares = 0;
    for (const double one : x) squares += (one - middle) * (one - middle);
    const auto count = static_cast<double>(x.size());
    return std::sqrt(squares / count / count);
  }

  /// The additive sequence of the plastic number's powers fills the square of rows and columns evenly,
  /// whatever the mesh's order.
  [[nodiscard]] Pair pair(std::size_t k) const {
    constexpr double row_step = 0.7548776662466927;
    constexpr double column_step = 0.5698402909980532;
    const std::size_t n = scene_.facet_count();
    const auto place = [k](double step, std::size_t count) {
      const double turns = static_cast<double>(k + 1) * step;
      return std::min(static_cast<std::size_t>((turns - std::floor(turns)) * static_cast<double>(count)),
                      count - 1);
    };
    const std::size_t row = place(row_step, n);
    return {row, (row + 1 + place(column_step, n - 1)) % n};
  }

  void look(std::size_t count) {
    const std::size_t first = sights_.size();
    sights_.resize(first + count);
    std::vector<char> sees(count, 0);
    parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const auto [row, column] = pair(first + k);
        const auto start = Clock::now();
        const PairSight sight = scene_.pair(row, column).sight;
        sights_[first + k] = since(start);
        sees[k] = sight == PairSight::whole || sight == PairSight::mixed ? 1 : 0;
      }
    });
    for (std::size_t k = 0; k < count; ++k)
      if (sees[k] != 0) seen_.push_back(pair(first + k));
  }

  /// What is done beyond looking.
  void time(std::size_t first, std::size_t count) {
    exchanges_.resize(first + count);
    radii_.resize(first + count);
    const long bits = BallPrecision::current();
    parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
      const BallPrecision inside(bits);
      for (std::size_t k = begin; k < end; ++k) {
        const auto [row, column] = seen_[first + k];
        const auto start = Clock::now();
        radii_[first + k] = pair_exchange(scene_, row, column, demand_).area.radius;
        exchanges_[first + k] = since(start);
      }
    });
  }

  const FacetScene& scene_;
  const FactorDemand& demand_;
  std::vector<double> sights_;     ///< seconds
  std::vector<double> exchanges_;  ///< seconds
  std::vector<double> radii_;
  std::vector<Pair> seen_;
};

}  // namespace

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
    const CertifiedDemand certified{.radius = demand.accuracy * share};
    out.area = enclosing(certified_exchange_area(scene, first, second, pair, certified));
  } else if (pair.sight == PairSight::whole) {
    out.area = exchange_area(pair.first, pair.second);
  } else {
    const double share = scene.area(first) * scene.area(second) / scene.total_area();
    out.area = visible_exchange_area(scene, pair, {.tolerance = demand.accuracy * share});
  }
  return out;
}

FactorPlan factor_plan(const FacetScene& scene, const FactorUnits& units, const FactorDemand& demand,
                       FactorsKept kept) {
  FactorPlan plan;
  const std::uint64_t n = scene.facet_count();
  const std::uint64_t m = units.names.size();
  plan.pairs = n * (n - 1) / 2;
  constexpr std::uint64_t bytes_of_triangle = 2048;
  plan.memory.add("scene", n, bytes_of_triangle);
  constexpr std::uint64_t bytes_of_pair = sizeof(PairExchange) + 64;
  plan.memory.add("pairs at a time", pairs_of_block, bytes_of_pair);
  plan.memory.add("exchange areas", m * (m + 1) / 2, sizeof(Approximation));
  if (kept == FactorsKept::all) plan.memory.add("factors", m * m, sizeof(ConfigurationFactor));
  if (plan.pairs == 0) return plan;
  PairSamples samples(scene, demand);
  plan.seconds = samples.seconds_of_all(plan.pairs);
  plan.radius = 2 * samples.mean_radius() * samples.share_that_sees() * static_cast<double>(plan.pairs) /
                scene.total_area();
  // The entries, each divided, looked at and written.
  const double of_pairs = 2 * samples.share_that_sees() * static_cast<double>(plan.pairs);
  plan.seconds += seconds_of_entry() * std::min(of_pairs, static_cast<double>(m) * static_cast<double>(m));
  return plan;
}

FactorMatrix factor_matrix(const FacetScene& scene, const FactorUnits& units, const FactorDemand& demand,
                           const FactorProgress& progress) {
  expects(units.of_triangle.size() == scene.facet_count(), "a unit for each triangle",
          named("units", units.of_triangle.size()));
  expects(demand.accuracy > 0, "accuracy > 0", named("accuracy", demand.accuracy));
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
  const PairList list(scene.facet_count());
  const std::size_t all = std::max<std::size_t>(list.count(), 1);
  const std::vector<PairBlock> blocks = pair_blocks(list.count());
  for (std::size_t first = 0; first < blocks.size(); first += progress.ranks->count()) {
    throw_if_interrupted();
    const std::vector<std::vector<PairExchange>> found = shared_blocks(
        std::span(blocks).subspan(first), progress, demand.certified,
        [&](const PairBlock& block) { return kept_pairs(scene, demand, list, block, progress); });
    for (std::size_t b = 0; b < found.size(); ++b) {
      const PairBlock& block = blocks[first + b];
      for (std::size_t k = 0; k < block.pairs; ++k) {
        const auto [i, j] = list.pair(block.number(k));
        const PairExchange& pair = found[b][k];
        matrix.whole_pairs += pair.sight == PairSight::whole ? 1 : 0;
        matrix.hidden_pairs += pair.sight == PairSight::hidden ? 1 : 0;
        matrix.mixed_pairs += pair.sight == PairSight::mixed ? 1 : 0;
        if (pair.area.value != 0 || pair.area.radius != 0)
          sums.at(units.of_triangle[i], units.of_triangle[j]) += pair.area;
      }
      done += block.pairs;
    }
    progress.at(static_cast<double>(done) / static_cast<double>(all));
  }
  if (!progress.ranks->is_first()) return {};
  sums.count_in(scene.unit());
  finish(matrix, sums, demand, progress);
  return matrix;
}

}  // namespace radcert
