// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/schema/schema_texts.h"

namespace radcert {

std::string_view solution_schema() {
  return R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "A result of radcert solve",
  "description": "Seconds live in timing alone: apart from timing and command, all is the same to the bit on every run. A number with a point or an exponent means the nearest double, and radii and bounds hold for those doubles, not for the decimal texts, which differ from them by rounding.",
  "type": "object",
  "required": ["schema", "radcert", "command", "problem", "levels", "orders", "timing"],
  "additionalProperties": false,
  "properties": {
    "schema": {"const": "radcert/solution/1"},
    "radcert": {"description": "The version that wrote the file.", "type": "string"},
    "command": {"description": "How it was called.", "type": "string"},
    "problem": {
      "description": "The problem as read, defaults filled in; see radcert schema problem.",
      "type": "object",
      "required": ["schema", "surface", "triangulation", "geometry", "basis", "reflectivity", "solver"],
      "properties": {"schema": {"const": "radcert/problem/1"}}
    },
    "levels": {"type": "array", "items": {"$ref": "#/$defs/level"}},
    "orders": {
      "description": "Least-squares slopes of log error over log h.",
      "type": "object",
      "propertyNames": {"enum": ["discretisation_error", "node_error", "uniform_error"]},
      "additionalProperties": {
        "type": "object",
        "required": ["order", "halfwidth", "levels", "left_out", "model"],
        "additionalProperties": false,
        "properties": {
          "order": {"type": ["number", "null"]},
          "halfwidth": {"type": ["number", "null"]},
          "levels": {"type": "array", "items": {"type": "integer"}},
          "left_out": {
            "description": "Levels whose radius exceeds 5 % of their error.",
            "type": "array",
            "items": {"type": "integer"}
          },
          "model": {"type": "string"}
        }
      }
    },
    "timing": {
      "type": "object",
      "required": ["levels"],
      "additionalProperties": false,
      "properties": {
        "levels": {
          "type": "array",
          "items": {
            "type": "object",
            "required": ["assembly_seconds", "operator_seconds", "solve_seconds"],
            "additionalProperties": false,
            "properties": {
              "assembly_seconds": {"type": "number", "minimum": 0},
              "operator_seconds": {"description": "Ku for the emission.", "type": "number", "minimum": 0},
              "solve_seconds": {"type": "number", "minimum": 0}
            }
          }
        }
      }
    }
  },
  "$defs": {
    "figure": {
      "oneOf": [
        {"type": "null"},
        {
          "type": "object",
          "required": ["value", "radius", "guaranteed"],
          "additionalProperties": false,
          "properties": {
            "value": {"type": "number"},
            "radius": {
              "description": "Bounds what quadrature, geometry and rounding may have changed; null: not estimated.",
              "type": ["number", "null"],
              "minimum": 0
            },
            "guaranteed": {"description": "true: the radius is proved; false: an estimate.", "type": "boolean"}
          },
          "if": {"properties": {"guaranteed": {"const": true}}},
          "then": {"properties": {"radius": {"type": "number"}}}
        }
      ]
    },
    "level": {
      "type": "object",
      "required": [
        "level", "elements", "unknowns", "mesh_size", "discretisation_error", "node_error", "uniform_error",
        "discretisation_ratio", "node_ratio", "discretisation_order", "node_order", "piece_means", "norm_K",
        "planned_bytes"
      ],
      "additionalProperties": false,
      "properties": {
        "level": {"type": "integer", "minimum": 0},
        "elements": {"type": "integer", "minimum": 1},
        "unknowns": {"type": "integer", "minimum": 1},
        "mesh_size": {"type": "number", "exclusiveMinimum": 0},
        "discretisation_error": {"description": "max over the nodes of |K(I-P_n)u|", "$ref": "#/$defs/figure"},
        "node_error": {"description": "max over the nodes of |u - u_n|", "$ref": "#/$defs/figure"},
        "uniform_error": {"description": "max over a sample of S of |u - u_n|", "$ref": "#/$defs/figure"},
        "discretisation_ratio": {"type": ["number", "null"]},
        "node_ratio": {"type": ["number", "null"]},
        "discretisation_order": {"type": ["number", "null"]},
        "node_order": {"type": ["number", "null"]},
        "piece_means": {"type": "object", "additionalProperties": {"type": "number"}},
        "norm_K": {
          "type": "object",
          "required": ["value", "guaranteed"],
          "additionalProperties": false,
          "properties": {
            "value": {"type": "number"},
            "radius": {
              "description": "Bounds the distance of the double `value` from the norm, proved; null: value is an estimate.",
              "type": ["number", "null"],
              "minimum": 0
            },
            "guaranteed": {"type": "boolean"}
          }
        },
        "planned_bytes": {"type": "integer", "minimum": 0},
        "solution_radius": {
          "description": "Bounds, for every node, what quadrature, rounding and the solution of the system may have changed u_n: proved with verified, else an estimate; null: not known.",
          "type": ["number", "null"],
          "minimum": 0
        },
        "means_radius": {
          "description": "Bounds the same of every mean, and the error of its own rule; an estimate; null: not known.",
          "type": ["number", "null"],
          "minimum": 0
        },
        "verified": {
          "description": "What verified has proved of u_n; null with other solvers.",
          "oneOf": [
            {"type": "null"},
            {
              "type": "object",
              "required": ["theta", "solution_radius"],
              "additionalProperties": false,
              "properties": {
                "theta": {
                  "description": "Bounds a norm of I - R (I - K_n), R an approximate inverse: the system has one solution.",
                  "type": "number",
                  "minimum": 0,
                  "exclusiveMaximum": 1
                },
                "solution_radius": {
                  "description": "Bounds max |u_n - v| over the nodes, v the exact solution of the exact collocation equations.",
                  "type": "number",
                  "minimum": 0
                }
              }
            }
          ]
        },
        "iteration": {
          "description": "How gmres or neumann came to u_n; null with other solvers.",
          "oneOf": [
            {"type": "null"},
            {
              "type": "object",
              "required": ["iterations", "contraction", "error_bound"],
              "additionalProperties": false,
              "properties": {
                "iterations": {"description": "Reflections, or Krylov vectors.", "type": "integer", "minimum": 0},
                "contraction": {
                  "description": "A weighted maximum norm of the collocation matrix, rounded up.",
                  "type": "number",
                  "minimum": 0,
                  "exclusiveMaximum": 1
                },
                "error_bound": {
                  "description": "Bounds max |u_n - v|, v the exact solution of the linear system as stored; proved.",
                  "type": "number",
                  "minimum": 0
                }
              }
            }
          ]
        }
      }
    }
  }
}
)json";
}

}  // namespace radcert
