// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <initializer_list>
#include <span>
#include <string>

#include "radcert/formats/json/json_document.h"
#include "radcert/formats/schema/schema_texts.h"

namespace radcert {

namespace {

constexpr const char* experiment_text = R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "An experiment of radcert",
  "description": "Problems that differ in a few parts: each takes the parts of base and one element of every list of vary. See radcert schema problem.",
  "type": "object",
  "required": ["schema", "name", "base", "vary"],
  "additionalProperties": false
})json";

constexpr const char* result_text = R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "A result of radcert experiment",
  "description": "Seconds live in timing alone: apart from timing and command, all is the same to the bit on every run.",
  "type": "object",
  "required": ["schema", "radcert", "command", "name", "varied", "combinations", "at_equal_unknowns", "timing"],
  "additionalProperties": false,
  "properties": {
    "schema": {"const": "radcert/experiment_result/1"},
    "radcert": {"description": "The version that wrote the file.", "type": "string"},
    "command": {"description": "How it was called.", "type": "string"},
    "name": {"type": "string"},
    "varied": {"description": "Keys of vary.", "type": "array", "items": {"type": "string"}},
    "combinations": {
      "type": "array",
      "items": {
        "type": "object",
        "required": ["combination", "name", "choice", "problem", "levels", "orders", "orders_in_unknowns"],
        "additionalProperties": false,
        "properties": {
          "combination": {"description": "Its number, from 0.", "type": "integer", "minimum": 0},
          "name": {"description": "What is varied, in words.", "type": "string"},
          "choice": {
            "description": "Of each varied part, the place in its list, from 0.",
            "type": "object",
            "additionalProperties": {"type": "integer", "minimum": 0}
          },
          "problem": true,
          "levels": true,
          "orders": true,
          "orders_in_unknowns": {
            "description": "Of the same levels: the error falls as the unknowns to the power -order; halfwidth null with two levels.",
            "$ref": "#/$defs/orders"
          }
        }
      }
    },
    "at_equal_unknowns": {"$ref": "#/$defs/at_equal_cost"},
    "timing": {
      "type": "object",
      "required": ["at_equal_seconds", "combinations"],
      "additionalProperties": false,
      "properties": {
        "at_equal_seconds": {
          "description": "Seconds of assembly and solution; what Ku costs is no part of a method.",
          "$ref": "#/$defs/at_equal_cost"
        },
        "combinations": {
          "type": "array",
          "items": {
            "type": "object",
            "required": ["combination", "levels"],
            "additionalProperties": false,
            "properties": {"combination": {"type": "integer", "minimum": 0}, "levels": true}
          }
        }
      }
    }
  }
})json";

constexpr const char* equal_cost_text = R"json({
  "description": "Of all combinations with the same surface, reflectivity and solution, and of each error: by their error at one cost, the largest that all of them pay at some level; between levels by a power law. error null, at the end: all levels cost more.",
  "type": "array",
  "items": {
    "type": "object",
    "required": ["combinations", "discretisation_error", "node_error", "uniform_error"],
    "properties": {"combinations": {"type": "array", "items": {"type": "integer", "minimum": 0}}},
    "additionalProperties": {
      "type": "object",
      "required": ["ranking"],
      "additionalProperties": false,
      "properties": {
        "unknowns": {"type": ["number", "null"]},
        "seconds": {"type": ["number", "null"]},
        "ranking": {
          "type": "array",
          "items": {
            "type": "object",
            "required": ["combination", "error"],
            "additionalProperties": false,
            "properties": {
              "combination": {"type": "integer", "minimum": 0},
              "error": {"type": ["number", "null"]}
            }
          }
        }
      }
    }
  }
})json";

/// The keys of an object, one of them by another value.
JsonValue with(const JsonValue& object, const std::string& key, const JsonValue& value) {
  JsonValue out = JsonValue::object();
  for (const auto& [name, old] : *object.members()) out.set(name, name == key ? value : old);
  if (object.find(key) == nullptr) out.set(key, value);
  return out;
}

const JsonValue& below(const JsonValue& object, std::initializer_list<const char*> keys) {
  const JsonValue* at = &object;
  for (const char* key : keys) at = at->find(key);
  return *at;
}

JsonValue open_object(const JsonValue& properties) {
  JsonValue out = JsonValue::object();
  out.set("type", "object");
  out.set("additionalProperties", false);
  out.set("properties", properties);
  return out;
}

std::string made_experiment_schema() {
  const JsonValue problem = parse_json(problem_schema(), "the schema of a problem");
  JsonValue parts = JsonValue::object();
  JsonValue lists = JsonValue::object();
  for (const auto& [key, part] : *problem.find("properties")->members()) {
    if (key == "schema" || key == "emission") continue;
    JsonValue list = JsonValue::object();
    list.set("type", "array");
    list.set("minItems", 1);
    list.set("items", part);
    parts.set(key, part);
    lists.set(key, std::move(list));
  }
  JsonValue schema = JsonValue::object();
  schema.set("const", "radcert/experiment/1");
  JsonValue name = JsonValue::object();
  name.set("type", "string");
  name.set("pattern", "^[a-z0-9_]{1,64}$");
  JsonValue properties = JsonValue::object();
  properties.set("schema", std::move(schema));
  properties.set("name", std::move(name));
  properties.set("base", open_object(parts));
  properties.set("vary", with(open_object(lists), "minProperties", 1));
  const JsonValue head = parse_json(experiment_text, "the schema of an experiment");
  return with(with(head, "properties", properties), "$defs", *problem.find("$defs")).pretty() + "\n";
}

std::string made_result_schema() {
  const JsonValue solution = parse_json(solution_schema(), "the schema of a solution");
  const JsonValue& of_solution = *solution.find("properties");
  JsonValue schema = parse_json(result_text, "the schema of an experiment's result");
  const auto replace = [](const JsonValue& object, auto&& self, const std::string& key,
                          const JsonValue& value, std::span<const char* const> path) -> JsonValue {
    if (path.empty()) return with(object, key, value);
    return with(object, path.front(), self(*object.find(path.front()), self, key, value, path.subspan(1)));
  };
  const std::array<const char*, 4> in_combination = {"properties", "combinations", "items", "properties"};
  for (const char* key : {"problem", "levels", "orders"})
    schema = replace(schema, replace, key, *of_solution.find(key), in_combination);
  const std::array<const char*, 6> in_timing = {"properties",   "timing", "properties",
                                                "combinations", "items",  "properties"};
  schema =
      replace(schema, replace, "levels", below(of_solution, {"timing", "properties", "levels"}), in_timing);
  JsonValue definitions = with(*solution.find("$defs"), "orders", *of_solution.find("orders"));
  definitions = with(definitions, "at_equal_cost", parse_json(equal_cost_text, "at equal cost"));
  return with(schema, "$defs", definitions).pretty() + "\n";
}

}  // namespace

std::string_view experiment_schema() {
  static const std::string text = made_experiment_schema();
  return text;
}

std::string_view experiment_result_schema() {
  static const std::string text = made_result_schema();
  return text;
}

}  // namespace radcert
