// SPDX-License-Identifier: GPL-3.0-or-later

// radcert example NAME: a problem or an experiment to start from.
#include <memory>
#include <string>
#include <vector>

#include "command.h"
#include "examples.h"
#include "output.h"
#include "radcert/formats/json/json_reader.h"

namespace radcert::app {

namespace {

std::vector<std::string> names() {
  std::vector<std::string> out{"problem"};
  for (const Example& example : examples()) out.emplace_back(example.name);
  out.emplace_back("experiment");
  for (const Example& example : experiment_examples()) out.emplace_back(example.name);
  return out;
}

const Example* find_example(const std::string& name) {
  if (name == "problem") return &examples().front();
  if (name == "experiment") return &experiment_examples().front();
  for (const auto& all : {examples(), experiment_examples()})
    for (const Example& example : all)
      if (example.name == name) return &example;
  return nullptr;
}

ExitCode print_example(const Common& common, const std::string& name) {
  if (const Example* example = find_example(name)) {
    print_result(common, example->text, example->text);
    return ExitCode::done;
  }
  const bool output = name == "solution" || name == "verification" || name == "experiment_result";
  throw InputError({.source = "example",
                    .value = name,
                    .problem = output ? "is what radcert writes, not reads: see radcert schema " + name
                                      : with_nearest_word("is no example", name, names()),
                    .allowed = listed(names())});
}

}  // namespace

void add_example(Program& program) {
  Subcommand command = program.add("example", "A runnable example of a file type");
  auto name = std::make_shared<std::string>();
  command.word("NAME", *name, listed(names()));
  command.runs([&common = program.common(), name] { return print_example(common, *name); });
}

}  // namespace radcert::app
