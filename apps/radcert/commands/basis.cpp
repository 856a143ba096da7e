// SPDX-License-Identifier: GPL-3.0-or-later

// radcert basis NAME or FILE: what is known of interpolation at its nodes.
#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "command.h"
#include "commands/basis_search.h"
#include "commands/basis_table.h"
#include "output.h"
#include "radcert/core/interrupt.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/problem/node_file.h"
#include "radcert/formats/result/basis_json.h"
#include "radcert/polynomial/nodes/search/free_search.h"
#include "radcert/polynomial/nodes/symmetric_nodes.h"
#include "records/basis_records.h"

namespace radcert::app {

namespace {

constexpr int largest_inset_degree = 12;

struct BasisOptions {
  std::string name;
  std::string degree;
  std::string alpha;
  std::string csv;
  std::string latex;
  std::string nodes;
  std::string out;
  BasisSearchOptions search;
};

struct DegreeRange {
  int first = 0;
  int last = 0;
};

DegreeRange degrees_of(const std::string& text, int least, int largest) {
  const std::string allowed = "a whole number from " + std::to_string(least) + " to " +
                              std::to_string(largest) + ", or two with a - between them";
  if (text.empty()) throw InputError({.source = "--degree", .problem = "is missing", .allowed = allowed});
  const auto whole = [&](std::string_view word) {
    int value = -1;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || value < least || value > largest)
      throw InputError({.source = "--degree", .value = text, .allowed = allowed});
    return value;
  };
  const std::size_t sign = text.find('-', 1);
  if (sign == std::string::npos) {
    const int degree = whole(text);
    return {degree, degree};
  }
  const DegreeRange range{whole(std::string_view(text).substr(0, sign)),
                          whole(std::string_view(text).substr(sign + 1))};
  if (range.first > range.last)
    throw InputError({.source = "--degree", .value = text, .allowed = allowed + ", the smaller one first"});
  return range;
}

bool is_file(const std::string& name) {
  return name.ends_with(".json") || name.find('/') != std::string::npos;
}

void refuse_option(const std::string& option, const std::string& value, const std::string& name) {
  if (!value.empty())
    throw InputError({.source = option, .value = value, .problem = "has no meaning for " + name});
}

std::vector<BasisRecord> records_of(const BasisOptions& options) {
  if (is_file(options.name)) {
    refuse_option("--degree", options.degree, "a file of nodes");
    refuse_option("--alpha", options.alpha, "a file of nodes");
    return {basis_record(options.name, read_nodes(options.name))};
  }
  const std::vector<std::string> families = {"inset", "symmetric", "search", "table"};
  if (std::find(families.begin(), families.end(), options.name) == families.end()) {
    throw InputError({.source = "basis",
                      .value = options.name,
                      .problem = with_nearest_word("is unknown", options.name, families),
                      .allowed = listed(families) + ", or a file of nodes (.json)"});
  }
  const bool is_inset = options.name == "inset";
  if (!is_inset) refuse_option("--alpha", options.alpha, "symmetric nodes");
  const DegreeRange range =
      is_inset ? degrees_of(options.degree, 0, largest_inset_degree)
               : degrees_of(options.degree, smallest_symmetric_degree, largest_symmetric_degree);
  std::vector<BasisRecord> records;
  for (int degree = range.first; degree <= range.last; ++degree) {
    throw_if_interrupted();
    records.push_back(is_inset ? inset_record(degree, options.alpha, OptionStyle::command_line)
                               : symmetric_record(degree));
  }
  return records;
}

std::string title(const BasisRecord& record) {
  if (record.space)
    return *record.file + ", " + std::to_string(record.space->size()) + " functions of degree " +
           std::to_string(record.facts.degree) + " at most, all polynomials of degree " +
           std::to_string(record.facts.reproduced) + " among them";
  if (record.file) return *record.file + ", degree " + std::to_string(record.facts.degree);
  return record.family + ", degree " + std::to_string(record.facts.degree) +
         (record.alpha ? ", alpha " + *record.alpha : std::string());
}

/// Whether nodes that a file gives as fractions miss a monomial by so little that others, which do not, were
/// rounded to them.
bool is_likely_rounding(const EnclosedPrecision& precision, PrecisionProof proof) {
  constexpr double least = 1e-15;
  return proof == PrecisionProof::exact && certainly_less(abs(precision.defect), Ball(least));
}

std::string proof_words(PrecisionProof proof) {
  if (proof == PrecisionProof::algebraic) return "exact, for the algebraic nodes";
  if (proof == PrecisionProof::certificate) return "proved, for the true nodes beside these";
  return "exact";
}

std::string precision_text(const EnclosedPrecision& precision, PrecisionProof proof) {
  std::string out = std::to_string(precision.degree) + " (" + proof_words(proof) + "); misses " +
                    precision.first_failure.to_text() + " by " + precision.defect.to_text(6);
  if (is_likely_rounding(precision, proof))
    out +=
        ", likely the rounding of the nodes' decimals: numbers of a polynomial keep irrational nodes exact";
  return out;
}

std::string weights_text(const BasisFacts& facts) {
  std::vector<int> counts(3);
  for (const Rational& weight : facts.weights) ++counts[static_cast<std::size_t>(weight.sign() + 1)];
  return std::to_string(counts[2]) + " positive, " + std::to_string(counts[1]) + " zero, " +
         std::to_string(counts[0]) + " negative";
}

// Midpoint and radius, rounded outwards.
std::string norm_words(const LebesgueConstant& norm) {
  constexpr int digits = 12;
  const EnclosingText text = norm_text(norm, digits);
  return text.radius == "0" ? text.value : text.value + " +- " + text.radius;
}

/// Whether a table shows decimals where the numbers are fractions.
bool is_rounded(const BasisFacts& facts, int digits) {
  const auto cut = [&](const Rational& x) { return readable(x, digits) != x.to_text(); };
  return cut(facts.determinant) || std::any_of(facts.weights.begin(), facts.weights.end(), cut) ||
         std::any_of(facts.nodes.begin(), facts.nodes.end(), [&](const Barycentric<Rational>& node) {
           return std::any_of(node.x.begin(), node.x.end(), cut);
         });
}

std::string one_text(const BasisRecord& record) {
  const BasisFacts& facts = record.facts;
  const PredictedOrders orders = record.orders();
  std::vector<std::vector<std::string>> nodes = {{"node", "x1", "x2", "x3", "weight"}};
  constexpr int digits = 16;
  for (std::size_t j = 0; j < facts.nodes.size(); ++j) {
    const auto& x = facts.nodes[j].x;
    nodes.push_back({std::to_string(j), readable(x[0], digits), readable(x[1], digits),
                     readable(x[2], digits), readable(facts.weights[j], digits)});
  }
  std::vector<std::vector<std::string>> rows = {
      {"weights", weights_text(facts)},
      {"unisolvent", "yes, determinant " + readable(facts.determinant, digits)},
      {"precision, triangle", precision_text(facts.triangle, facts.proof)},
      {"precision, parallelogram", precision_text(facts.parallelogram, facts.proof)},
      {"norm of P_n", norm_words(facts.norm) + " (proved)"},
      {"condition", upper_readable(facts.condition, digits)},
      {"order everywhere", order_text(orders.everywhere, false) + " [m06, Theorem 4]"},
      {"order at the nodes", order_text(orders.curved, orders.curved_has_logarithm) +
                                 " on a smooth surface with a symmetric triangulation [m06, Theorems 7, 9]"},
      {"", order_text(orders.smooth_kernel, false) +
               " where G is smooth at P = Q (a sphere) and between distinct pieces"},
      {"", order_text(orders.at_edges, false) + " where pieces meet at an angle: no more is known"}};
  if (facts.products)
    rows.insert(rows.begin() + 4,
                {"precision, products",
                 std::to_string(facts.products->triangle) + ", parallelogram " +
                     std::to_string(facts.products->parallelogram) + " (" + proof_words(facts.proof) +
                     "): Int q (p - P p) = 0 for degrees up to that; orders follow it"});
  const std::string rounding =
      is_rounded(facts, digits)
          ? "Fractions are exact; decimals of nodes, weights and determinant are rounded to nearest.\n"
          : "";
  return title(record) + "\n" + aligned(nodes) + "\n" + aligned_left(rows) + rounding;
}

std::string table_text(const std::vector<BasisRecord>& records) {
  std::vector<std::vector<std::string>> rows = {{"degree", "nodes", "negative", "triangle", "parallelogram",
                                                 "norm of P_n", "+-", "condition", "everywhere", "at nodes"}};
  constexpr int digits = 11;
  constexpr std::size_t norm_radius = 6;  // the column stays with the one before it
  for (const BasisRecord& record : records) {
    const BasisFacts& facts = record.facts;
    const PredictedOrders orders = record.orders();
    const EnclosingText norm = norm_text(facts.norm, digits);
    const auto negative = std::count_if(facts.weights.begin(), facts.weights.end(),
                                        [](const Rational& w) { return w.sign() < 0; });
    rows.push_back({std::to_string(facts.degree), std::to_string(facts.nodes.size()),
                    std::to_string(negative), std::to_string(facts.triangle.degree),
                    std::to_string(facts.parallelogram.degree), norm.value, norm.radius,
                    upper_readable(facts.condition, digits), order_text(orders.everywhere, false),
                    order_text(orders.curved, orders.curved_has_logarithm)});
  }
  return records.front().family + "\n" + aligned(rows, {norm_radius});
}

JsonValue nodes_of(const BasisRecord& record) {
  if (record.family == "symmetric")
    return nodes_json(symmetric_nodes(record.facts.degree), symmetric_radius());
  if (record.space) return nodes_json(*record.space, record.facts.nodes);
  return nodes_json(record.facts.degree, record.facts.nodes);
}

ExitCode give_searched(const Common& common, const BasisOptions& options, const Outputs& outputs) {
  refuse_option("--alpha", options.alpha, "symmetric nodes");
  const DegreeRange range = degrees_of(options.degree, 1, largest_searched_degree);
  if (range.first != range.last)
    throw InputError({.source = "--degree",
                      .value = options.degree,
                      .problem = "is more than one",
                      .allowed = "the degree of one search"});
  const std::optional<SearchedBasis> found =
      searched_basis(common, options.search, range.first, outputs, options.nodes);
  if (!found) return ExitCode::differs;
  const std::vector<BasisRecord> records{found->record};
  std::vector<std::pair<std::filesystem::path, std::string>> files;
  if (!options.csv.empty()) files.emplace_back(options.csv, basis_csv(records));
  if (!options.latex.empty()) files.emplace_back(options.latex, basis_latex(records));
  if (!options.nodes.empty()) files.emplace_back(options.nodes, node_file(common, found->nodes));
  JsonValue json = basis_record_json(records, common.command);
  json.set("search", found->search);
  print_result(common, outputs, one_text(found->record) + found->words, json.pretty() + "\n",
               std::move(files));
  return ExitCode::done;
}

ExitCode give_table(const Common& common, const BasisOptions& options) {
  refuse_option("--alpha", options.alpha, "symmetric nodes");
  for (const auto& [option, value] : {std::pair("--csv", options.csv), std::pair("--latex", options.latex),
                                      std::pair("--nodes", options.nodes)})
    refuse_option(option, value, "a table, which has its files in the folder of --out");
  const bool is_symmetric = symmetry_asked(options.search);
  const DegreeRange range = degrees_of(!options.degree.empty() ? options.degree
                                       : is_symmetric          ? "1-10"
                                                               : "2-4",
                                       1, is_symmetric ? largest_searched_degree : largest_free_degree);
  return show_basis_table(common, options.out, range.first, range.last, options.search);
}

ExitCode give_basis(const Common& common, const BasisOptions& options) {
  if (options.name == "table") return give_table(common, options);
  refuse_option("--out", options.out, options.name);
  Outputs outputs(common);
  outputs.file("--csv", options.csv);
  outputs.file("--latex", options.latex);
  outputs.file("--nodes", options.nodes);
  if (options.name == "search") return give_searched(common, options, outputs);
  outputs.input(options.name);
  if (const auto given = options.search.any()) refuse_option(given->first, given->second, options.name);
  const std::vector<BasisRecord> records = records_of(options);
  if (!options.nodes.empty() && records.size() != 1)
    throw InputError({.source = "--nodes", .value = options.nodes, .problem = "is for one degree"});
  std::vector<std::pair<std::filesystem::path, std::string>> files;
  if (!options.csv.empty()) files.emplace_back(options.csv, basis_csv(records));
  if (!options.latex.empty()) files.emplace_back(options.latex, basis_latex(records));
  if (!options.nodes.empty()) files.emplace_back(options.nodes, node_file(common, nodes_of(records.front())));
  print_result(common, outputs, records.size() == 1 ? one_text(records.front()) : table_text(records),
               basis_record_json(records, common.command).pretty() + "\n", std::move(files));
  return ExitCode::done;
}

}  // namespace

void add_basis(Program& program) {
  Subcommand command =
      program.add("basis", "Nodes, weights, degrees of precision, norm and orders of a basis");
  auto options = std::make_shared<BasisOptions>();
  command.word("NAME", options->name,
               "inset, symmetric, search, table, or a file of nodes (radcert schema nodes)");
  command.option("--degree", options->degree,
                 "The degree, of inset nodes up to 12, of which solve takes 10; or several as 1-10: then a "
                 "table, a row each",
                 "R");
  command.option("--alpha", options->alpha, "Of inset nodes: a number in [0, 1/3), or superconvergent", "A");
  command.option("--csv", options->csv, "Nodes and weights", "FILE");
  command.option("--latex", options->latex, "A table, a row a basis", "FILE");
  command.option("--nodes", options->nodes, "The nodes as a file that radcert reads", "FILE");
  command.option(
      "--out", options->out,
      "Of a table: the folder of nodes.csv and nodes_R.json, or with --symmetric off of free.csv and "
      "free_R.json, whose nodes are looked at too",
      "DIR");
  command.option(
      "--goal", options->search.goal,
      "Of a search: orders (default: the least precision with the best orders), precision (the largest), "
      "parallelogram (the largest there), or norm (none but the degree)",
      "WORD");
  command.option("--precision", options->search.precision,
                 "Of a search: the degree of precision on the triangle", "D");
  command.option("--symmetric", options->search.symmetric,
                 "Of a search: on (default), or off: nodes without symmetry, of degrees up to 4", "on|off");
  command.flag("--positive", options->search.positive, "Of a search: weights above 0 alone");
  command.option("--starts", options->search.starts,
                 "Of a search: random starts; default 256. Of a table: none without it", "N");
  command.option("--seed", options->search.seed, "Of a search: of its random numbers; default 1", "S");
  command.option("--seconds", options->search.seconds, "Of a search: no start begins later", "T");
  command.footer("Degrees of precision and weights are exact, the norm lies between proved bounds.");
  command.runs([&common = program.common(), options] { return give_basis(common, *options); });
}

}  // namespace radcert::app
