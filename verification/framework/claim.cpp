// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/claim.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <locale>
#include <sstream>
#include <toml++/toml.h>

#include "radcert/core/errors.h"

namespace radcert::verification {
namespace {

constexpr std::array<std::string_view, 4> figures{"discretisation_error", "discretisation_ratio",
                                                  "node_error", "node_ratio"};

std::string list_of(const auto& words) {
  std::string out;
  for (const auto& word : words) out += (out.empty() ? "" : ", ") + std::string(word);
  return out;
}

int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

// The text of a value for a message.
std::optional<std::string> shown(const toml::node* node) {
  if (node == nullptr) return std::nullopt;
  std::ostringstream out;
  out.imbue(std::locale::classic());
  if (const auto* table = node->as_table())
    out << "a table of " << table->size();
  else if (const auto* array = node->as_array())
    out << "an array of " << array->size();
  else if (const auto* text = node->as_string())
    out << text->get();
  else if (const auto* whole = node->as_integer())
    out << whole->get();
  else if (const auto* number = node->as_floating_point())
    out << number->get();
  else if (const auto* truth = node->as_boolean())
    out << (truth->get() ? "true" : "false");
  else
    out << "a date or time";
  return out.str();
}

// A place in the file that is read with an expectation.
class Place {
public:
  Place(const toml::node& node, std::string pointer, const std::string& source)
      : node_(&node), pointer_(std::move(pointer)), source_(&source) {}

  [[noreturn]] void refuse(const std::string& problem, const std::string& allowed) const {
    refuse_at(line_of(*node_), pointer_, shown(node_), problem, allowed);
  }

  const toml::table& table(const std::string& what) const {
    const toml::table* table = node_->as_table();
    if (table == nullptr) refuse("is not a table", what);
    return *table;
  }

  Place at(std::string_view key, const std::string& what) const {
    const toml::table& here = table("a table");
    if (const toml::node* found = here.get(key)) return {*found, below(key), *source_};
    refuse_at(line_of(*node_), below(key), std::nullopt, "is missing", what);
  }

  std::optional<Place> find(std::string_view key) const {
    const toml::table& here = table("a table");
    if (const toml::node* found = here.get(key)) return Place{*found, below(key), *source_};
    return std::nullopt;
  }

  // The keys of a table in the order of the file.
  std::vector<std::pair<std::string, Place>> members(const std::string& what) const {
    std::vector<std::pair<std::string, Place>> members;
    for (const auto& [key, value] : table(what))
      members.emplace_back(std::string(key.str()), Place{value, below(key.str()), *source_});
    std::stable_sort(members.begin(), members.end(),
                     [](const auto& a, const auto& b) { return a.second.begin() < b.second.begin(); });
    return members;
  }

  void require_keys(const std::vector<std::string_view>& allowed) const {
    for (const auto& [key, value] : members("a table"))
      if (std::find(allowed.begin(), allowed.end(), key) == allowed.end())
        refuse_at(value.line(), value.pointer_, std::nullopt, "is an unknown key", list_of(allowed));
  }

  std::string text(const std::string& what) const {
    const auto* value = node_->as_string();
    if (value == nullptr || value->get().empty()) refuse("is not allowed", what);
    return value->get();
  }

  bool truth() const {
    const auto* value = node_->as_boolean();
    if (value == nullptr) refuse("is not allowed", "true or false");
    return value->get();
  }

  int whole(int least, const std::string& what) const {
    const auto* value = node_->as_integer();
    if (value == nullptr || value->get() < least || value->get() > 1000000) refuse("is not allowed", what);
    return static_cast<int>(value->get());
  }

  double number(const std::string& what) const {
    double number = 0;
    if (const auto* whole = node_->as_integer())
      number = static_cast<double>(whole->get());
    else if (const auto* value = node_->as_floating_point())
      number = value->get();
    else
      refuse("is not allowed", what);
    if (!std::isfinite(number)) refuse("is not allowed", what);
    return number;
  }

  std::optional<Rational> exact_number() const {
    if (const auto* whole = node_->as_integer()) return Rational(whole->get());
    const auto* text = node_->as_string();
    if (text == nullptr) return std::nullopt;
    Outcome<Rational> value = Rational::parse(text->get());
    return value ? std::optional<Rational>(*value) : std::nullopt;
  }

  std::vector<Place> elements(const std::string& what) const {
    const toml::array* array = node_->as_array();
    if (array == nullptr) refuse("is not an array", what);
    std::vector<Place> elements;
    std::size_t index = 0;
    for (const toml::node& element : *array)
      elements.emplace_back(element, below(std::to_string(index++)), *source_);
    return elements;
  }

  template <class T, class Read>
  PerBudget<T> per_budget(const Read& read) const {
    if (!node_->is_table()) return PerBudget<T>::same(read(*this));
    require_keys({"quick", "standard", "full"});
    PerBudget<T> values;
    for (const Budget budget : all_budgets)
      values.at(budget) = read(at(name(budget), "one value for each budget"));
    return values;
  }

  int line() const { return line_of(*node_); }
  std::pair<int, int> begin() const {
    return {static_cast<int>(node_->source().begin.line), static_cast<int>(node_->source().begin.column)};
  }
  bool is_table() const { return node_->is_table(); }

private:
  std::string below(std::string_view key) const { return pointer_ + "/" + std::string(key); }
  [[noreturn]] void refuse_at(int line, const std::string& pointer, std::optional<std::string> value,
                              const std::string& problem, const std::string& allowed) const {
    throw InputError({.source = *source_ + ", line " + std::to_string(line),
                      .pointer = pointer,
                      .value = std::move(value),
                      .problem = problem,
                      .allowed = allowed});
  }

  const toml::node* node_;
  std::string pointer_;
  const std::string* source_;
};

bool is_name(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return ('a' <= c && c <= 'z') || ('0' <= c && c <= '9') || c == '_';
  });
}

Verdict read_verdict(const Place& place) {
  const std::string allowed =
      "one of " + list_of(recordable_verdicts()) + ", or one of these for each of quick, standard, full";
  const std::optional<Verdict> verdict = verdict_named(place.text(allowed));
  if (!verdict || *verdict == Verdict::failed) place.refuse("cannot be recorded", allowed);
  return *verdict;
}

TableSeries read_series(const Place& place) {
  place.require_keys({"name", "where", "problem", "control", "figures", "verified"});
  TableSeries series;
  series.line = place.line();
  if (const auto name = place.find("name")) {
    series.name = name->text("a name of a-z, 0-9 and _");
    if (!is_name(series.name)) name->refuse("is not allowed", "a name of a-z, 0-9 and _");
  }
  if (const auto where = place.find("where"))
    for (const auto& [column, value] : where->members("a table of columns and the text that they hold"))
      series.where.emplace_back(column, value.text("the text in that column"));
  series.problem = place.at("problem", "a problem file").text("a problem file");
  series.control = place.at("control", "the file of a problem that must be rejected").text("a problem file");
  if (const auto verified = place.find("verified"))
    series.verified = verified->per_budget<int>(
        [](const Place& elements) { return elements.whole(0, "a number of elements"); });
  const Place columns = place.at("figures", "a table: figure = \"column\"");
  for (const auto& [figure, column] : columns.members("a table: figure = \"column\"")) {
    if (std::find(figures.begin(), figures.end(), figure) == figures.end())
      column.refuse("is a figure that is not known", list_of(figures));
    series.figures.push_back({figure, column.text("a column of the table")});
  }
  if (series.figures.empty()) columns.refuse("is empty", "at least one of " + list_of(figures));
  return series;
}

void read_cells(const Place& place, const std::string& label, std::vector<CellRecord>& cells) {
  if (place.find("verdict")) {
    place.require_keys({"verdict", "note", "second_route"});
    CellRecord cell;
    cell.label = label;
    cell.line = place.line();
    cell.verdict = place.at("verdict", "").per_budget<Verdict>(read_verdict);
    if (const auto note = place.find("note")) cell.note = note->text("a text");
    if (const auto second = place.find("second_route")) cell.second_route = second->truth();
    cells.push_back(std::move(cell));
    return;
  }
  const auto members = place.members("the verdicts of cells");
  if (members.empty()) place.refuse("is empty", "verdict, or tables that have one");
  for (const auto& [key, member] : members) {
    if (!is_name(key) || !member.is_table())
      member.refuse("is not allowed", "verdict, note and second_route of a cell, or tables of cells");
    read_cells(member, label + "." + key, cells);
  }
}

// What every statement may have, whichever way it is checked.
constexpr std::array<std::string_view, 10> common_keys{"covers", "page",      "says",    "formula", "needs",
                                                       "met",    "unchecked", "erratum", "check",   "note"};
constexpr std::array<std::string_view, 3> table_only_keys{"table", "rows", "series"};

TableClaim read_table(const Place& place, const std::string& label) {
  TableClaim table;
  table.file = place.at("table", "the file of the printed table").text("the file of the printed table");
  if (const auto rows = place.find("rows")) table.rows = rows->text("a column of the table");
  const Place series = place.at("series", "an array of tables");
  for (const Place& each : series.elements("an array of tables")) table.series.push_back(read_series(each));
  if (table.series.empty()) series.refuse("is empty", "at least one series");
  for (const auto& [key, member] : place.members("a table")) {
    const auto is_in = [&](const auto& keys) {
      return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    if (is_in(common_keys) || is_in(table_only_keys)) continue;
    if (!is_name(key) || !member.is_table())
      member.refuse("is an unknown key",
                    list_of(common_keys) + ", " + list_of(table_only_keys) + ", and tables of cells");
    read_cells(member, label + "." + key, table.cells);
  }
  return table;
}

OrderClaim read_order(const Place& place) {
  OrderClaim order;
  order.problem = place.at("problem", "a problem file").text("a problem file");
  order.control = place.at("control", "the file of a problem that must be rejected").text("a problem file");
  const Place quantity = place.at("quantity", "discretisation_error or node_error");
  order.quantity = quantity.text("discretisation_error or node_error");
  if (order.quantity != "discretisation_error" && order.quantity != "node_error")
    quantity.refuse("is not known", "discretisation_error or node_error");
  order.order = place.at("order", "a number").number("a number");
  order.slack = place.at("slack", "a number >= 0, or one for each of quick, standard, full")
                    .per_budget<double>([](const Place& value) {
                      const double slack = value.number("a number >= 0");
                      if (slack < 0) value.refuse("is not allowed", "a number >= 0");
                      return slack;
                    });
  order.why = place.at("why", "the reason for the slack").text("the reason for the slack");
  return order;
}

// Numbers that are exact: a text, or a whole number.
Rational read_exact(const Place& place) {
  const std::string allowed = "a decimal or a fraction as a text, or a whole number";
  const std::optional<Rational> value = place.exact_number();
  if (!value) place.refuse("is not allowed", allowed);
  return *value;
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
    claim.number.reference = reference->text("a name of radcert list references");
    claim.number.values = read_values(place.find("values"));
    claim.control.reference = control.text("a name of radcert list references");
    claim.control.values = read_values(place.find("control_values"));
    return claim;
  }
  for (const std::string_view key : {"values", "control_values"})
    if (const auto other = place.find(key)) other->refuse("does not go with `problem`", "with `reference`");
  claim.number.problem =
      place.at("problem", "a problem file; or `reference`").text("a problem file; or `reference`");
  const std::vector<std::string> known = enclosed_quantities();
  const Place quantity = place.at("quantity", list_of(known));
  claim.number.quantity = quantity.text(list_of(known));
  if (std::find(known.begin(), known.end(), claim.number.quantity) == known.end())
    quantity.refuse("is not known", list_of(known));
  if (const auto level = place.find("level")) claim.number.level = level->whole(0, "a level");
  claim.control = claim.number;
  claim.control.problem = control.text("a problem file");
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
    const std::string kind = check->text(allowed);
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

std::vector<std::string_view> with_common(std::initializer_list<std::string_view> own) {
  std::vector<std::string_view> keys(common_keys.begin(), common_keys.end());
  keys.insert(keys.end(), own);
  return keys;
}

// What the reader of a report is told of a statement.
void read_account(const Place& place, Claim& claim) {
  claim.says = place.at("says", "the statement in words").text("the statement in words");
  if (const auto formula = place.find("formula")) claim.formula = formula->text("the statement in TeX");
  if (const auto needs = place.find("needs"))
    for (const Place& need : needs->elements("an array of hypotheses"))
      claim.needs.push_back(need.text("a hypothesis"));
  if (const auto met = place.find("met")) {
    const std::string allowed =
        "an array of as many texts as `needs` has, " + std::to_string(claim.needs.size());
    for (const Place& how : met->elements(allowed))
      claim.met.push_back(how.text("how the hypothesis is met"));
    if (claim.met.size() != claim.needs.size()) met->refuse("does not fit the hypotheses", allowed);
  }
  if (const auto unchecked = place.find("unchecked")) claim.unchecked = unchecked->text("a text");
  if (const auto erratum = place.find("erratum")) claim.erratum = erratum->text("a place of errata.md");
  if (const auto note = place.find("note")) claim.note = note->text("a text");
}

Claim read_claim(const std::string& label, const Place& place) {
  if (!is_name(label)) place.refuse("is no label", "a name of a-z, 0-9 and _");
  Claim claim;
  claim.label = label;
  claim.line = place.line();
  if (const auto verdict = place.find("verdict")) claim.verdict = verdict->per_budget<Verdict>(read_verdict);
  claim.check = read_check(place, claim.verdict);
  if (claim.check == CheckKind::table) {
    if (claim.verdict)
      place.at("verdict", "")
          .refuse("is not allowed", "a verdict for each cell of a table, none for the whole");
    claim.table = read_table(place, label);
  } else {
    if (!claim.verdict) static_cast<void>(place.at("verdict", "one of " + list_of(recordable_verdicts())));
    if (claim.check == CheckKind::order) {
      place.require_keys(with_common({"verdict", "problem", "control", "quantity", "order", "slack", "why"}));
      claim.order = read_order(place);
    } else if (claim.check == CheckKind::enclosure) {
      place.require_keys(with_common({"verdict", "problem", "quantity", "level", "reference", "values",
                                      "control", "control_values", "interval"}));
      claim.enclosure = read_enclosure(place);
      require_verdicts_of_a_proof(place.at("verdict", ""), claim.verdict.value());
    } else {
      place.require_keys(with_common({"verdict", "symbol"}));
    }
  }
  if (const auto covers = place.find("covers"))
    for (const Place& equation : covers->elements("an array of equation numbers"))
      claim.covers.push_back(equation.whole(1, "the number of an equation"));
  if (const auto page = place.find("page")) claim.page = page->whole(1, "a page number");
  read_account(place, claim);
  if (const auto symbol = place.find("symbol")) claim.symbol = symbol->text("a public symbol");
  const bool defines = claim.verdict && claim.verdict->at(Budget::quick) == Verdict::definition;
  if (defines && claim.symbol.empty())
    static_cast<void>(place.at("symbol", "the public symbol that stands for the definition"));
  return claim;
}

}  // namespace

std::vector<std::string> enclosed_quantities() {
  return {"discretisation_error", "node_error", "least_u_n", "largest_u_n"};
}

std::vector<Claim> read_claims(std::string_view text, const std::string& source) {
  toml::table document;
  try {
    document = toml::parse(text, source);
  } catch (const toml::parse_error& error) {
    throw InputError({.source = source + ", line " + std::to_string(error.source().begin.line) + ", column " +
                                std::to_string(error.source().begin.column),
                      .problem = std::string(error.description()),
                      .allowed = "TOML 1.0"});
  }
  std::vector<Claim> claims;
  for (const auto& [label, place] : Place(document, "", source).members("a table"))
    claims.push_back(read_claim(label, place));
  return claims;
}

}  // namespace radcert::verification
