// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/basis_search.h"

#include <charconv>
#include <chrono>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "output.h"
#include "progress.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/version.h"
#include "radcert/formats/problem/node_file.h"
#include "radcert/polynomial/nodes/orbit_structure.h"
#include "radcert/polynomial/nodes/search/free_search.h"
#include "radcert/polynomial/nodes/search/symmetric_search.h"
#include "radcert/polynomial/nodes/symmetric_certificate.h"
#include "records/basis_records.h"

namespace radcert::app {

namespace {

std::uint64_t whole(const std::string& option, const std::string& text, std::uint64_t usual,
                    std::uint64_t least, std::uint64_t largest) {
  if (text.empty()) return usual;
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < least || value > largest)
    throw InputError(
        {.source = option,
         .value = text,
         .allowed = "a whole number from " + std::to_string(least) + " to " + std::to_string(largest)});
  return value;
}

SymmetricGoal goal_of(const BasisSearchOptions& options, int degree) {
  const int largest = largest_regular_precision(degree);
  SymmetricGoal goal{
      .degree = degree, .precision = precision_for_orders(degree), .positive = options.positive};
  if (!options.precision.empty()) {
    if (!options.goal.empty())
      throw InputError({.source = "--goal",
                        .value = options.goal,
                        .problem = "is one way to say a precision",
                        .allowed = "it, or --precision"});
    goal.precision =
        static_cast<int>(whole("--precision", options.precision, 0, static_cast<std::uint64_t>(degree),
                               static_cast<std::uint64_t>(largest)));
    if (const std::optional<std::string> why = hindrance(goal))
      throw InputError({.source = "--precision", .value = options.precision, .problem = *why});
    return goal;
  }
  if (options.goal == "precision") {
    goal.precision = largest;
  } else if (options.goal == "norm") {
    goal.precision = degree;
  } else if (options.goal == "parallelogram") {
    goal.precision = precision_for_parallelogram(degree);
  } else if (!options.goal.empty() && options.goal != "orders") {
    throw InputError(
        {.source = "--goal", .value = options.goal, .allowed = "orders, precision, parallelogram, norm"});
  }
  return goal;
}

std::string structure_words(int degree) {
  const OrbitStructure structure = orbit_structure(degree);
  const auto part = [](int count, const std::string& of) {
    return count == 0 ? std::string() : ", " + std::to_string(count) + " of " + of;
  };
  return "orbits, of which no other numbers are unisolvent: " +
         (part(structure.ones, "one node") + part(structure.threes, "three") + part(structure.sixes, "six"))
             .substr(2);
}

void write_unfinished(const Outputs& outputs, const SearchResult& found, const std::string& nodes_file) {
  if (!found.best || nodes_file.empty()) return;
  outputs.write({{nodes_file, nodes_json(found.best->nodes, symmetric_radius()).pretty() + "\n"}});
  say("radcert: the best nodes of " + std::to_string(found.starts) + " starts are in " + nodes_file + "\n");
}

FreeGoal free_goal_of(const BasisSearchOptions& options, int degree) {
  if (degree > largest_free_degree)
    throw InputError({.source = "--degree",
                      .value = std::to_string(degree),
                      .problem = "is too much for a search without symmetry",
                      .allowed = "a whole number from 1 to " + std::to_string(largest_free_degree)});
  if (!options.goal.empty() && options.goal != "orders")
    throw InputError({.source = "--goal", .value = options.goal, .allowed = "orders, with --symmetric off"});
  if (options.positive)
    throw InputError({.source = "--positive", .problem = "has no meaning with --symmetric off"});
  if (!options.precision.empty())
    throw InputError({.source = "--precision",
                      .value = options.precision,
                      .problem = "has no meaning with --symmetric off, which takes what the orders ask for"});
  FreeGoal goal = free_goal(degree);
  if (const std::optional<std::string> why = hindrance(goal))
    throw InputError({.source = "--degree",
                      .value = std::to_string(degree),
                      .problem = "has no such nodes to look for: " + *why});
  return goal;
}

/// A search with its progress.
/// Result    `found` has what the last call of `look` told
template <class Found, class Look>
void show_search(const Common& common, const SearchEffort& effort, std::uint64_t seconds, Found& found,
                 const Look& look) {
  const auto begin = std::chrono::steady_clock::now();
  ProgressDisplay progress(common.quiet);
  const auto starts = static_cast<std::size_t>(effort.starts);
  progress.counted(0, starts, "starts");
  found = look([&](const Found& so_far) {
    found = so_far;
    progress.counted(static_cast<std::size_t>(so_far.starts), starts, "starts");
    return seconds == 0 ||
           std::chrono::steady_clock::now() - begin < std::chrono::seconds(static_cast<long>(seconds));
  });
}

std::string tried_words(int starts, int solutions) {
  return std::to_string(starts) + " starts, " + std::to_string(solutions) + " solutions inside";
}
constexpr const char* followed =
    ": of these the least norm was followed; that no set has a lesser one is not said\n";

std::optional<SearchedBasis> searched_without_symmetry(const Common& common, const FreeGoal& goal,
                                                       const SearchEffort& effort, std::uint64_t seconds) {
  FreeSearchResult found;
  show_search(common, effort, seconds, found,
              [&](const auto& goes_on) { return search_free_nodes(goal, effort, goes_on); });
  const std::string tried = tried_words(found.starts, found.solutions);
  if (!found.best) {
    complain("no nodes of degree " + std::to_string(goal.degree) + " without symmetry were found: " + tried +
             "; that there are none is not said; more --starts, or another --seed, may find some");
    return std::nullopt;
  }
  const ProgressDisplay progress(common.quiet, "proof of precision and norm");
  const Outcome<SymmetricCertificate> certificate = certify(found.best->nodes, symmetric_radius());
  if (!certificate) {
    complain("the nodes that were found are not proved: " + certificate.reason());
    return std::nullopt;
  }
  SearchedBasis out;
  out.nodes = nodes_json(found.best->nodes, symmetric_radius());
  out.record = certified_record("search", found.best->nodes.points(), *certificate);
  out.search = JsonValue::object({{"precision", goal.triangle},
                                  {"positive", false},
                                  {"symmetric", false},
                                  {"starts", found.starts},
                                  {"seed", effort.seed},
                                  {"solutions", found.solutions}});
  out.words =
      "no symmetry: the parallelogram is the one along the side of the vertices 2 and 3\n" + tried + followed;
  return out;
}

}  // namespace

std::optional<std::pair<std::string, std::string>> BasisSearchOptions::any() const {
  using Given = std::pair<std::string, const std::string*>;
  for (const auto& [name, value] :
       {Given{"--goal", &goal}, Given{"--precision", &precision}, Given{"--starts", &starts},
        Given{"--seed", &seed}, Given{"--seconds", &seconds}, Given{"--symmetric", &symmetric}})
    if (!value->empty()) return std::pair(name, *value);
  if (positive) return std::pair(std::string("--positive"), std::string("given"));
  return std::nullopt;
}

bool symmetry_asked(const BasisSearchOptions& options) {
  if (options.symmetric.empty() || options.symmetric == "on") return true;
  if (options.symmetric == "off") return false;
  throw InputError({.source = "--symmetric", .value = options.symmetric, .allowed = "on, off"});
}

std::string node_file(const Common& common, const JsonValue& nodes) {
  JsonValue out = JsonValue::object();
  for (const JsonValue::Member& member : *nodes.members()) {
    out.set(member.key, member.value);
    if (member.key != "schema") continue;
    out.set("radcert", version());
    out.set("command", common.command);
  }
  return out.pretty() + "\n";
}

std::optional<SearchedBasis> searched_basis(const Common& common, const BasisSearchOptions& options,
                                            int degree, const Outputs& outputs,
                                            const std::string& nodes_file) {
  const bool is_symmetric = symmetry_asked(options);
  const SearchEffort effort{
      .starts =
          static_cast<int>(whole("--starts", options.starts, SearchEffort().starts, 1, most_search_starts)),
      .seed = whole("--seed", options.seed, 1, 0, std::numeric_limits<std::uint32_t>::max())};
  const std::uint64_t seconds = whole("--seconds", options.seconds, 0, 1, 10'000'000);
  const auto limit = common.limit_threads();
  if (!is_symmetric) return searched_without_symmetry(common, free_goal_of(options, degree), effort, seconds);
  const SymmetricGoal goal = goal_of(options, degree);
  SearchResult found;
  try {
    show_search(common, effort, seconds, found,
                [&](const auto& goes_on) { return search_symmetric_nodes(goal, effort, goes_on); });
  } catch (const Interrupted&) {
    write_unfinished(outputs, found, nodes_file);
    throw;
  }
  const std::string tried =
      tried_words(found.starts, found.solutions) + (goal.positive ? " with positive weights" : "");
  if (!found.best) {
    complain("no nodes of degree " + std::to_string(goal.degree) + " with the precision " +
             std::to_string(goal.precision) + " were found: " + tried +
             "; that there are none is not said; more --starts, or another --seed, may find some");
    return std::nullopt;
  }
  const ProgressDisplay progress(common.quiet, "proof of precision and norm");
  const SymmetricNodes& nodes = found.best->nodes;
  SearchedBasis out;
  if (goal.precision == goal.degree) {
    // Nothing but unisolvence is asked: the decimals are the nodes, and what is said of them is exact.
    out.nodes = nodes_json(nodes.degree, nodes.nodes());
    out.record = node_record("search", nodes.nodes());
  } else {
    const Outcome<SymmetricCertificate> certificate = certify(nodes, symmetric_radius());
    if (!certificate) {
      complain("the nodes that were found are not proved: " + certificate.reason());
      return std::nullopt;
    }
    out.nodes = nodes_json(nodes, symmetric_radius());
    out.record = certified_record("search", nodes, *certificate);
  }
  out.search = JsonValue::object({{"precision", goal.precision},
                                  {"positive", goal.positive},
                                  {"starts", found.starts},
                                  {"seed", effort.seed},
                                  {"solutions", found.solutions}});
  out.words = structure_words(goal.degree) + "\n" + tried + followed;
  return out;
}

}  // namespace radcert::app
