// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/stored_finding.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "radcert/core/digest.h"
#include "radcert/core/errors.h"
#include "radcert/core/files/result_store.h"
#include "radcert/core/outcome.h"
#include "radcert/core/text.h"
#include "radcert/core/version.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/problem/problem_json.h"
#include "verification/framework/reading/embedded.h"

namespace radcert::verification {
namespace {

// JSON has no word for what is not finite.
JsonValue number_json(double number) { return shortest(number); }

double read_number(const JsonReader& place) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::string& text = place.string("a number as text");
  if (const std::optional<double> number = parse_double(text)) return *number;
  for (const double number : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
    if (text == shortest(number)) return number;
  place.refuse("is no number", "a number as text");
}

template <class Word, std::size_t count>
Word read_word(const JsonReader& place, const std::array<Word, count>& words) {
  const std::string& text = place.string("a word");
  for (const Word word : words)
    if (text == name(word)) return word;
  place.refuse("is no such word", "a word");
}

JsonValue evidence_json(const Evidence& evidence) {
  return JsonValue::object({{"what", evidence.what},
                            {"value", evidence.value},
                            {"radius", evidence.radius},
                            {"allowed", evidence.allowed},
                            {"standing", name(evidence.standing)},
                            {"number", number_json(evidence.number)},
                            {"kind", evidence.kind},
                            {"role", name(evidence.role)},
                            {"proved", evidence.proved}});
}

Evidence read_evidence(const JsonReader& evidence) {
  const auto text = [&](std::string_view key) { return evidence.at(key, "a text").string("a text"); };
  const JsonReader radius = evidence.at("radius", "a text or null");
  return {.what = text("what"),
          .value = text("value"),
          .radius = radius.value().is_null() ? std::nullopt : std::optional(radius.string("a text")),
          .allowed = text("allowed"),
          .standing = read_word(evidence.at("standing", "a word"),
                                std::array{Standing::holds, Standing::violated, Standing::open}),
          .number = read_number(evidence.at("number", "a number as text")),
          .kind = text("kind"),
          .role = read_word(evidence.at("role", "a word"),
                            std::array{Role::requirement, Role::control, Role::instead}),
          .proved = evidence.at("proved", "true or false").boolean("true or false")};
}

JsonValue figure_json(const std::optional<Approximation>& figure) {
  if (!figure) return {};
  return JsonValue::object({{"value", number_json(figure->value)},
                            {"radius", number_json(figure->radius)},
                            {"guaranteed", figure->guaranteed}});
}

std::optional<Approximation> read_figure(const JsonReader& figure) {
  if (figure.value().is_null()) return std::nullopt;
  return Approximation{.value = read_number(figure.at("value", "a number as text")),
                       .radius = read_number(figure.at("radius", "a number as text")),
                       .guaranteed = figure.at("guaranteed", "true or false").boolean("true or false")};
}

JsonValue asked_json(const RecordedLevels::Asked& asked) {
  return JsonValue::object({{"problem", problem_json(asked.problem)}, {"level", asked.level}});
}

// Of the claims, tables and problems of the papers: checks read them.
const std::string& papers_digest() {
  static const std::string digest = digest_of(embedded_papers());
  return digest;
}

std::string key_of(const std::string& statement, const Bench& bench) {
  return "verification finding\n" + std::string(source_digest()) + "\n" + papers_digest() + "\n" + statement +
         "\n" + std::string(name(bench.budget));
}

std::string record_of(const TimedFinding& found, const RecordedLevels& levels) {
  const Finding& finding = found.finding;
  return JsonValue::object({{"evidence", json_array(finding.evidence(), evidence_json)},
                            {"remarks", json_array(finding.remarks())},
                            {"figure", figure_json(finding.figure())},
                            {"asked", json_array(levels.asked(), asked_json)},
                            {"seconds", found.seconds}})
      .compact();
}

// A finding and the levels that it stands on.
struct Record {
  TimedFinding found;
  std::vector<RecordedLevels::Asked> asked;
};

Outcome<Record> read_record(const std::string& text) {
  try {
    const JsonValue document = parse_json(text, "a stored finding");
    const JsonReader record(document);
    std::vector<Evidence> evidence;
    for (const JsonReader& each : record.at("evidence", "a list").elements("a list"))
      evidence.push_back(read_evidence(each));
    std::vector<std::string> remarks;
    for (const JsonReader& each : record.at("remarks", "a list").elements("a list"))
      remarks.push_back(each.string("a text"));
    Record out{.found = {.finding = Finding::restored(std::move(evidence), std::move(remarks),
                                                      read_figure(record.at("figure", "a figure or null"))),
                         .seconds = record.at("seconds", "a number").number("a number")},
               .asked = {}};
    for (const JsonReader& each : record.at("asked", "a list").elements("a list"))
      out.asked.push_back(
          {.problem = parse_problem(each.at("problem", "a problem").value().compact(), "a stored finding"),
           .level = static_cast<int>(each.at("level", "a level").whole(0, 1000, "a level"))});
    return out;
  } catch (const InputError& error) {
    return because(std::string(error.what()));
  }
}

}  // namespace

bool is_stored(const std::string& statement, const Bench& bench) {
  return bench.store.get(key_of(statement, bench)).has_value();
}

TimedFinding stored_finding(const Check& check, const std::string& statement, const Bench& bench,
                            RecordedLevels& levels) {
  const std::string key = key_of(statement, bench);
  if (const std::optional<std::string> kept = bench.store.get(key)) {
    if (const Outcome<Record> record = read_record(*kept)) {
      for (const RecordedLevels::Asked& each : record->asked)
        static_cast<void>(levels.level(each.problem, each.level));
      return record->found;
    }
  }
  const auto start = std::chrono::steady_clock::now();
  TimedFinding found{.finding = check(bench)};
  found.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (found.finding.verdict() != Verdict::failed)
    static_cast<void>(bench.store.put(key, record_of(found, levels)));
  return found;
}

}  // namespace radcert::verification
