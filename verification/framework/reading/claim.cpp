// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/reading/claim.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <regex>

#include "radcert/core/errors.h"
#include "radcert/formats/json/json_reader.h"
#include "verification/framework/reading/toml_document.h"

namespace radcert::verification {
namespace {

using Place = JsonReader;

const std::vector<std::string> figures = {"discretisation_error", "discretisation_ratio", "node_error",
                                          "node_ratio"};

std::string text_at(const Place& place, const std::string& what) {
  const std::string& text = place.string(what);
  if (text.empty()) place.refuse("is empty", what);
  return text;
}

int whole_at(const Place& place, int least, const std::string& what) {
  constexpr int largest = 1000000;
  return static_cast<int>(place.whole(least, largest, what));
}

bool is_table(const Place& place) { return place.value().members() != nullptr; }

// One value for all budgets, or a table of them.
template <class T, class Read>
PerBudget<T> per_budget(const Place& place, const Read& read) {
  if (!is_table(place)) return PerBudget<T>::same(read(place));
  place.require_object({"quick", "standard", "full"});
  PerBudget<T> values;
  for (const Budget budget : all_budgets)
    values.at(budget) = read(place.at(name(budget), "one value for each budget"));
  return values;
}

bool is_name(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return ('a' <= c && c <= 'z') || ('0' <= c && c <= '9') || c == '_';
  });
}

Verdict read_verdict(const Place& place) {
  const std::string allowed =
      "one of " + listed(recordable_verdicts()) + ", or one of these for each of quick, standard, full";
  const std::optional<Verdict> verdict = verdict_named(text_at(place, allowed));
  if (!verdict || *verdict == Verdict::failed) place.refuse("cannot be recorded", allowed);
  return *verdict;
}

TableSeries read_series(const Place& place, const TomlDocument& document) {
  place.require_object({"name", "where", "problem", "control", "figures", "verified"});
  TableSeries series;
  series.line = document.line_of(place.pointer());
  if (const auto name = place.find("name")) {
    series.name = text_at(*name, "a name of a-z, 0-9 and _");
    if (!is_name(series.name)) name->refuse("is not allowed", "a name of a-z, 0-9 and _");
  }
  if (const auto where = place.find("where"))
    for (const auto& [column, value] : where->members("a table of columns and the text that they hold"))
      series.where.emplace_back(column, text_at(value, "the text in that column"));
  series.problem = text_at(place.at("problem", "a problem file"), "a problem file");
  series.control =
      text_at(place.at("control", "the file of a problem that must be rejected"), "a problem file");
  if (const auto verified = place.find("verified"))
    series.verified = per_budget<int>(
        *verified, [](const Place& elements) { return whole_at(elements, 0, "a number of elements"); });
  const Place columns = place.at("figures", "a table: figure = \"column\"");
  for (const auto& [figure, column] : columns.members("a table: figure = \"column\"")) {
    if (std::find(figures.begin(), figures.end(), figure) == figures.end())
      column.refuse("is a figure that is not known", listed(figures));
    series.figures.push_back({figure, text_at(column, "a column of the table")});
  }
  if (series.figures.empty()) columns.refuse("is empty", "at least one of " + listed(figures));
  return series;
}

void read_cells(const Place& place, const std::string& label, const TomlDocument& document,
                std::vector<CellRecord>& cells) {
  if (place.find("verdict")) {
    place.require_object({"verdict", "note", "second_route"});
    CellRecord cell;
    cell.label = label;
    cell.line = document.line_of(place.pointer());
    cell.verdict = per_budget<Verdict>(place.at("verdict", ""), read_verdict);
    if (const auto note = place.find("note")) cell.note = text_at(*note, "a text");
    if (const auto second = place.find("second_route")) cell.second_route = second->boolean("true or false");
    cells.push_back(std::move(cell));
    return;
  }
  const auto members = place.members("the verdicts of cells");
  if (members.empty()) place.refuse("is empty", "verdict, or tables that have one");
  for (const auto& [key, member] : members) {
    if (!is_name(key) || !is_table(member))
      member.refuse("is not allowed", "verdict, note and second_route of a cell, or tables of cells");
    read_cells(member, label + "." + key, document, cells);
  }
}

// What every statement may have, whichever way it is checked.
const std::vector<std::string> common_keys = {"covers", "page",  "says",      "formula", "needs", "met",
                                              "scope",  "tried", "unchecked", "erratum", "check", "note"};
const std::vector<std::string> table_only_keys = {"table", "rows", "series"};

TableClaim read_table(const Place& place, const std::string& label, const TomlDocument& document) {
  TableClaim table;
  table.file = text_at(place.at("table", "the file of the printed table"), "the file of the printed table");
  if (const auto rows = place.find("rows")) table.rows = text_at(*rows, "a column of the table");
  const Place series = place.at("series", "an array of tables");
  for (const Place& each : series.elements("an array of tables"))
    table.series.push_back(read_series(each, document));
  if (table.series.empty()) series.refuse("is empty", "at least one series");
  for (const auto& [key, member] : place.members("a table")) {
    const auto is_in = [&](const auto& keys) {
      return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    if (is_in(common_keys) || is_in(table_only_keys)) continue;
    if (!is_name(key) || !is_table(member))
      member.refuse("is an unknown key",
                    listed(common_keys) + ", " + listed(table_only_keys) + ", and tables of cells");
    read_cells(member, label + "." + key, document, table.cells);
  }
  return table;
}

OrderClaim read_order(const Place& place) {
  OrderClaim order;
  order.problem = text_at(place.at("problem", "a problem file"), "a problem file");
  order.control =
      text_at(place.at("control", "the file of a problem that must be rejected"), "a problem file");
  const Place quantity = place.at("quantity", "discretisation_error or node_error");
  order.quantity = text_at(quantity, "discretisation_error or node_error");
  if (order.quantity != "discretisation_error" && order.quantity != "node_error")
    quantity.refuse("is not known", "discretisation_error or node_error");
  order.order = place.at("order", "a number").number("a number");
  if (const auto logarithm = place.find("logarithm")) order.logarithm = logarithm->boolean("true or false");
  return order;
}

// Numbers that are exact: a text, or a whole number.
Rational read_exact(const Place& place) {
  const std::string allowed = "a decimal or a fraction as a text, or a whole number";
  if (place.value().string() != nullptr) return place.rational(allowed);
  return Rational(place.whole(INT64_MIN, INT64_MAX, allowed));
}

std::vector<std::pair<std::string, Rational>> read_values(const std::optional<Place>& place) {
  std::vector<std::pair<std::string, Rational>> values;
  if (!place) return values;
  for (const auto& [name, value] : place->members("a table of parameters and their values"))
    values.emplace_back(name, read_exact(value));
  return values;
}

EnclosureClaim read_enclosure(const Place& place) {
  EnclosureClaim claim;
  const Place interval = place.at("interval", "two numbers, the lesser one first");
  const std::vector<Place> ends = interval.elements("two numbers, the lesser one first");
  if (ends.size() != 2) interval.refuse("is no interval", "two numbers, the lesser one first");
  claim.least = read_exact(ends[0]);
  claim.largest = read_exact(ends[1]);
  if (claim.largest < claim.least) interval.refuse("is empty", "two numbers, the lesser one first");
  const Place control = place.at("control", "a problem file or a reference value that must be rejected");
  if (const auto reference = place.find("reference")) {
    for (const std::string_view key : {"problem", "quantity", "level"})
      if (const auto other = place.find(key)) other->refuse("does not go with `reference`", "one of the two");
    claim.number.reference = text_at(*reference, "a name of radcert list references");
    claim.number.values = read_values(place.find("values"));
    claim.control.reference = text_at(control, "a name of radcert list references");
    claim.control.values = read_values(place.find("control_values"));
    return claim;
  }
  for (const std::string_view key : {"values", "control_values"})
    if (const auto other = place.find(key)) other->refuse("does not go with `problem`", "with `reference`");
  claim.number.problem =
      text_at(place.at("problem", "a problem file; or `reference`"), "a problem file; or `reference`");
  const std::vector<std::string> known = enclosed_quantities();
  const Place quantity = place.at("quantity", listed(known));
  claim.number.quantity = text_at(quantity, listed(known));
  if (std::find(known.begin(), known.end(), claim.number.quantity) == known.end())
    quantity.refuse("is not known", listed(known));
  if (const auto level = place.find("level")) claim.number.level = whole_at(*level, 0, "a level");
  claim.control = claim.number;
  claim.control.problem = text_at(control, "a problem file");
  return claim;
}

void require_verdicts_of_a_proof(const Place& place, const PerBudget<Verdict>& verdict) {
  for (const Verdict each : verdict.values)
    if (each != Verdict::certified && each != Verdict::contradicted && each != Verdict::undecided &&
        each != Verdict::unchecked)
      place.refuse("is no verdict of an enclosure", "certified, contradicted, undecided");
}

CheckKind read_check(const Place& place, const std::optional<PerBudget<Verdict>>& verdict) {
  if (const auto check = place.find("check")) {
    const std::string allowed = "function, table, order or enclosure";
    const std::string kind = text_at(*check, allowed);
    if (kind == "function") return CheckKind::function;
    if (kind == "table") return CheckKind::table;
    if (kind == "order") return CheckKind::order;
    if (kind == "enclosure") return CheckKind::enclosure;
    check->refuse("is not known", allowed);
  }
  if (verdict && std::all_of(verdict->values.begin(), verdict->values.end(),
                             [](Verdict v) { return v == Verdict::definition || v == Verdict::unchecked; }))
    return CheckKind::none;
  return CheckKind::function;
}

// How far the verdict reaches: said by whoever wrote the check. A table is looked at cell by cell, an
// enclosure is of the one number that it speaks of, an order is that of one problem.
void read_scope(const Place& place, Claim& claim) {
  const auto scope = place.find("scope");
  const auto tried = place.find("tried");
  if (claim.check == CheckKind::none) {
    if (scope) scope->refuse("is not allowed", "a scope of what is checked");
    if (tried) tried->refuse("is not allowed", "instances of what is checked");
    return;
  }
  if (tried)
    for (const Place& each : tried->elements("an array of instances, or the family"))
      claim.tried.push_back(text_at(each, "an instance, or a family"));
  if (scope) {
    const std::string allowed = "all, family or instances";
    claim.scope = scope_named(text_at(*scope, allowed));
    if (!claim.scope) scope->refuse("is not known", allowed);
  } else if (claim.order) {
    claim.scope = Scope::instances;
    if (claim.tried.empty()) claim.tried.push_back(claim.order->problem);
  } else if (claim.table || claim.enclosure) {
    claim.scope = Scope::all;
  } else {
    static_cast<void>(place.at("scope", "all, family or instances: how far the verdict reaches"));
  }
  if (claim.scope == Scope::all && tried)
    tried->refuse("is not allowed", "no instances beside the scope `all`, which a sample does not prove");
  if (claim.scope != Scope::all && claim.tried.empty()) {
    const std::string allowed = "an array of the instances, or of the family";
    if (tried) tried->refuse("is empty", allowed);
    static_cast<void>(place.at("tried", allowed));
  }
}

std::vector<std::string> with_common(std::initializer_list<std::string> own) {
  std::vector<std::string> keys = common_keys;
  keys.insert(keys.end(), own);
  return keys;
}

// The lines of a report on a statement.
void read_account(const Place& place, Claim& claim) {
  claim.says = text_at(place.at("says", "the statement in words"), "the statement in words");
  if (const auto formula = place.find("formula")) claim.formula = text_at(*formula, "the statement in TeX");
  if (const auto needs = place.find("needs"))
    for (const Place& need : needs->elements("an array of hypotheses"))
      claim.needs.push_back(text_at(need, "a hypothesis"));
  if (const auto met = place.find("met")) {
    const std::string allowed =
        "an array of as many texts as `needs` has, " + std::to_string(claim.needs.size());
    for (const Place& how : met->elements(allowed))
      claim.met.push_back(text_at(how, "how the hypothesis is met"));
    if (claim.met.size() != claim.needs.size()) met->refuse("does not fit the hypotheses", allowed);
  }
  if (const auto unchecked = place.find("unchecked")) claim.unchecked = text_at(*unchecked, "a text");
  if (const auto erratum = place.find("erratum")) claim.erratum = text_at(*erratum, "a place of errata.md");
  if (const auto note = place.find("note")) claim.note = text_at(*note, "a text");
}

// A definition stands for a symbol and asserts nothing that could be checked.
void require_definition(const Place& place, const Claim& claim) {
  if (claim.symbol.empty())
    static_cast<void>(place.at("symbol", "the public symbol that stands for the definition"));
  if (!claim.needs.empty())
    place.at("needs", "").refuse("are hypotheses of a definition", "a claim with a check");
  static const std::regex in_words(R"([=<>]|O\(|\b(at most|at least|order|one-to-one|onto|unique|every)\b)");
  static const std::regex in_tex(R"(O\(|\bonto\b|1-1|\\forall|\\to\s*0)");
  const auto require_nothing = [&](const char* key, const std::string& text, const std::regex& assertion) {
    std::smatch found;
    if (std::regex_search(text, found, assertion))
      place.at(key, "").refuse(
          "asserts something, with \"" + found.str() + "\", and is recorded as a definition",
          "a claim with a check");
  };
  require_nothing("says", claim.says, in_words);
  require_nothing("formula", claim.formula, in_tex);
}

Claim read_claim(const std::string& label, const Place& place, const TomlDocument& document) {
  if (!is_name(label)) place.refuse("is no label", "a name of a-z, 0-9 and _");
  if (!is_table(place)) place.refuse("is " + place.value().kind(), "a table, [" + label + "]");
  Claim claim;
  claim.label = label;
  claim.line = document.line_of(place.pointer());
  if (const auto verdict = place.find("verdict")) claim.verdict = per_budget<Verdict>(*verdict, read_verdict);
  claim.check = read_check(place, claim.verdict);
  if (claim.check == CheckKind::table) {
    if (claim.verdict)
      place.at("verdict", "")
          .refuse("is not allowed", "a verdict for each cell of a table, none for the whole");
    claim.table = read_table(place, label, document);
  } else {
    if (!claim.verdict) static_cast<void>(place.at("verdict", "one of " + listed(recordable_verdicts())));
    if (claim.check == CheckKind::order) {
      if (const auto slack = place.find("slack"))
        slack->refuse("is no key of an order any more", "none: the levels give the interval of an order");
      place.require_object(with_common({"verdict", "problem", "control", "quantity", "order", "logarithm"}));
      claim.order = read_order(place);
    } else if (claim.check == CheckKind::enclosure) {
      place.require_object(with_common({"verdict", "problem", "quantity", "level", "reference", "values",
                                        "control", "control_values", "interval"}));
      claim.enclosure = read_enclosure(place);
      require_verdicts_of_a_proof(place.at("verdict", ""), claim.verdict.value());
    } else {
      place.require_object(with_common({"verdict", "symbol"}));
    }
  }
  if (const auto covers = place.find("covers"))
    for (const Place& equation : covers->elements("an array of equation numbers"))
      claim.covers.push_back(whole_at(equation, 1, "the number of an equation"));
  if (const auto page = place.find("page")) claim.page = whole_at(*page, 1, "a page number");
  read_account(place, claim);
  read_scope(place, claim);
  if (const auto symbol = place.find("symbol")) claim.symbol = text_at(*symbol, "a public symbol");
  if (claim.verdict && claim.verdict->at(Budget::quick) == Verdict::definition)
    require_definition(place, claim);
  return claim;
}

}  // namespace

std::vector<std::string> enclosed_quantities() {
  return {"discretisation_error", "node_error", "least_u_n", "largest_u_n"};
}

std::vector<Claim> read_claims(std::string_view text, const std::string& source) {
  const TomlDocument document = parse_toml(text, source);
  try {
    std::vector<Claim> claims;
    for (const auto& [label, place] : Place(document.value).members("a table"))
      claims.push_back(read_claim(label, place, document));
    // A run without statements would find every verdict as recorded.
    if (claims.empty())
      throw InputError({.problem = "has no claim", .allowed = "a table for each, as [label]"});
    return claims;
  } catch (const InputError& error) {
    throw error.with_source(source + ", line " + std::to_string(document.line_of(error.fault().pointer)));
  }
}

}  // namespace radcert::verification
