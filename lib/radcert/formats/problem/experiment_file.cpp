// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/problem/experiment_file.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "radcert/formats/json/json_document.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/formats/problem/problem_words.h"

namespace radcert {

namespace {

/// The keys of a problem but for `emission`: where no solution is known there is no error to compare.
const std::vector<std::string> parts = {"surface",  "triangulation", "geometry", "basis", "reflectivity",
                                        "solution", "quadrature",    "operator", "solver"};
/// All are checked before any is solved, and each is a line of a legend.
constexpr std::size_t most_combinations = 1000;

/// A list of vary, with the places of its elements.
struct VariedList {
  std::string key;
  std::vector<JsonReader> elements;
};

/// The labels of each list that has them, one an element.
std::map<std::string, std::vector<std::string>> read_labels(const JsonReader& labels,
                                                            const std::vector<VariedList>& lists) {
  labels.require_object(parts);
  std::map<std::string, std::vector<std::string>> out;
  for (const auto& [key, list] : labels.members("an object")) {
    const auto varied =
        std::find_if(lists.begin(), lists.end(), [&](const VariedList& each) { return each.key == key; });
    if (varied == lists.end()) list.refuse("are labels of what is not varied", "keys of vary");
    const std::size_t count = varied->elements.size();
    for (const JsonReader& label : list.elements("a list of labels")) out[key].push_back(read_label(label));
    if (out[key].size() != count)
      list.refuse("has not as many labels as vary has elements", std::to_string(count) + " labels");
  }
  return out;
}

void refuse_emission(const JsonReader& object) {
  if (const auto emission = object.find("emission"))
    emission->refuse("leaves no error to compare", "solution in its place: the emission is then u - Ku");
}

std::string read_name(const JsonReader& name) {
  constexpr std::size_t longest = 64;
  const std::string allowed = "1 to 64 of the letters a-z, digits and _";
  const std::string& text = name.string(allowed);
  const auto plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  if (text.empty() || text.size() > longest || !std::all_of(text.begin(), text.end(), plain))
    name.refuse("is no name", allowed);
  return text;
}

std::vector<VariedList> read_lists(const JsonReader& vary, const JsonReader& base) {
  refuse_emission(vary);
  vary.require_object(parts);
  const std::string allowed = "a list, not empty";
  std::vector<VariedList> lists;
  std::size_t combinations = 1;
  for (const auto& [key, list] : vary.members("an object")) {
    if (base.find(key)) list.refuse("is stated in base too", "each part in base or in vary");
    lists.push_back({key, list.elements(allowed)});
    if (lists.back().elements.empty()) list.refuse("is empty", allowed);
    // Both factors are at most 2^26, the bytes of a file.
    combinations *= lists.back().elements.size();
    if (combinations > most_combinations)
      list.refuse("makes " + std::to_string(combinations) + " combinations",
                  "at most " + std::to_string(most_combinations));
  }
  if (lists.empty())
    vary.refuse("is empty", "an object with a list for one part of the problem at least: " + listed(parts));
  return lists;
}

JsonValue problem_of(const JsonReader& base, const std::vector<VariedList>& lists,
                     const Combination& combination) {
  JsonValue problem = JsonValue::object();
  problem.set("schema", "radcert/problem/1");
  for (const auto& [key, value] : *base.value().members()) problem.set(key, value);
  for (std::size_t i = 0; i < lists.size(); ++i)
    problem.set(lists[i].key, lists[i].elements[combination.choice[i].second].value());
  return problem;
}

/// The next combination, the last list running fastest; false after the last.
bool advance(Combination& combination, const std::vector<VariedList>& lists) {
  for (std::size_t i = lists.size(); i-- > 0;) {
    if (++combination.choice[i].second < lists[i].elements.size()) return true;
    combination.choice[i].second = 0;
  }
  return false;
}

std::string pointer_to(const std::pair<std::string, std::size_t>& choice) {
  return pointer_below(pointer_below("/vary", choice.first), choice.second);
}

void refuse_repetition(const Combination& now, const Combination& before,
                       const std::vector<VariedList>& lists) {
  for (std::size_t i = 0; i < now.choice.size(); ++i)
    if (now.choice[i] != before.choice[i])
      lists[i].elements[now.choice[i].second].refuse(
          "makes the same problem as " + pointer_to(before.choice[i]), "combinations that differ");
}

/// Of the words of each element those that are not the same in all elements of the list.
std::vector<std::vector<std::string>> telling_words(
    const std::vector<std::vector<std::string>>& of_elements) {
  const std::size_t count = of_elements.front().size();
  std::vector<std::vector<std::string>> out = of_elements;
  if (of_elements.size() < 2 || !std::all_of(of_elements.begin(), of_elements.end(),
                                             [&](const auto& words) { return words.size() == count; }))
    return out;
  for (std::size_t i = count; i-- > 0;)
    if (std::all_of(of_elements.begin(), of_elements.end(),
                    [&](const auto& words) { return words[i] == of_elements.front()[i]; }))
      for (auto& words : out) words.erase(words.begin() + static_cast<std::ptrdiff_t>(i));
  return out;
}

/// Names are cells of CSV tables too, which many programs part at every comma.
void name_combinations(std::vector<Combination>& combinations, const std::vector<VariedList>& lists,
                       const std::map<std::string, std::vector<std::string>>& labels) {
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const auto own = labels.find(lists[i].key);
    if (own != labels.end()) {
      for (Combination& combination : combinations)
        combination.name +=
            (combination.name.empty() ? "" : "; ") + own->second[combination.choice[i].second];
      continue;
    }
    if (lists[i].elements.size() == 1 && combinations.size() > 1) continue;
    std::vector<std::vector<std::string>> words(lists[i].elements.size());
    for (const Combination& combination : combinations)
      words[combination.choice[i].second] = part_words(combination.problem, lists[i].key);
    words = telling_words(words);
    for (Combination& combination : combinations) {
      for (const std::string& word : words[combination.choice[i].second])
        combination.name += (combination.name.empty() ? "" : "; ") + word;
    }
  }
  std::map<std::string, std::size_t> uses;
  for (Combination& combination : combinations)
    if (const std::size_t use = ++uses[combination.name]; use > 1)
      combination.name += " (" + std::to_string(use) + ")";
}

Experiment read(const JsonValue& document, const std::string& source) {
  const JsonReader root(document);
  root.require_schema("radcert/experiment/1", "an object: an experiment");
  root.require_object({"schema", "name", "base", "vary", "labels", "fit_from"});
  Experiment experiment;
  experiment.name = read_name(root.at("name", "a name"));
  const JsonReader base = root.at("base", "an object: the parts that all problems share");
  refuse_emission(base);
  base.require_object(parts);
  const std::vector<VariedList> lists =
      read_lists(root.at("vary", "an object with a list for each part that is varied"), base);
  std::map<std::string, std::vector<std::string>> labels;
  if (const auto given = root.find("labels")) labels = read_labels(*given, lists);
  std::optional<int> fit_from;
  if (const auto given = root.find("fit_from")) fit_from = read_fit_from(*given);

  Combination next;
  for (const VariedList& list : lists) {
    experiment.varied.push_back(list.key);
    next.choice.emplace_back(list.key, 0);
  }
  std::map<std::string, std::size_t> seen;
  do {
    with_combination(next, source,
                     [&] { next.problem = parse_problem(problem_of(base, lists, next).compact(), source); });
    const auto [same, is_new] =
        seen.emplace(problem_json(next.problem).compact(), experiment.combinations.size());
    if (!is_new) refuse_repetition(next, experiment.combinations[same->second], lists);
    experiment.combinations.push_back(next);
  } while (advance(next, lists));
  for (Combination& combination : experiment.combinations) combination.problem.fit_from = fit_from;
  name_combinations(experiment.combinations, lists, labels);
  return experiment;
}

}  // namespace

Experiment read_experiment(const std::filesystem::path& path) {
  const JsonValue document = read_json(path);
  return with_source(path.string(), [&] { return read(document, path.string()); });
}

Experiment parse_experiment(std::string_view text, const std::string& source) {
  const JsonValue document = parse_json(text, source);
  return with_source(source, [&] { return read(document, source); });
}

InputError in_experiment(const InputError& error, const Combination& combination) {
  InputFault fault = error.fault();
  const std::size_t end = fault.pointer.find('/', 1);
  const std::string key = fault.pointer.substr(0, end);
  const std::string rest = end == std::string::npos ? "" : fault.pointer.substr(end);
  if (!key.empty()) fault.pointer = "/base" + key + rest;
  std::string others;
  for (const auto& choice : combination.choice) {
    if ("/" + choice.first == key)
      fault.pointer = pointer_to(choice) + rest;
    else
      others += (others.empty() ? " (with " : ", ") + pointer_to(choice);
  }
  if (!others.empty()) fault.problem += others + ")";
  return InputError(std::move(fault));
}

void with_combination(const Combination& combination, const std::string& source,
                      const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    // A file that the problem names has pointers of its own.
    if (!error.fault().source.empty() && error.fault().source != source) throw;
    throw in_experiment(error, combination).with_source(source);
  }
}

}  // namespace radcert
