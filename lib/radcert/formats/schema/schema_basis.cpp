// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/schema/schema_texts.h"

namespace radcert {

std::string_view nodes_schema() {
  return R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "Nodes of interpolation on a triangle",
  "type": "object",
  "required": ["schema", "nodes"],
  "oneOf": [{"required": ["degree"]}, {"required": ["space"]}],
  "additionalProperties": false,
  "properties": {
    "schema": {"const": "radcert/nodes/1"},
    "radcert": {"description": "The version that wrote the file.", "type": "string"},
    "command": {"description": "How it was called.", "type": "string"},
    "degree": {"description": "r, of the interpolating polynomials: all polynomials of that degree.", "type": "integer", "minimum": 0, "maximum": 12},
    "space": {
      "description": "In place of a degree: functions of one's own, as many as nodes, polynomials in the barycentric coordinates x1, x2, x3; the constants must be among their combinations.",
      "type": "array",
      "minItems": 1,
      "maxItems": 91,
      "items": {"type": "string"}
    },
    "nodes": {
      "description": "(r + 1)(r + 2)/2 different points of the triangle, or one a function of the space, by their barycentric coordinates, which have the exact sum 1.",
      "type": "array",
      "minItems": 1,
      "maxItems": 91,
      "items": {
        "type": "array",
        "minItems": 3,
        "maxItems": 3,
        "items": {
          "description": "A decimal or fraction in a string, from 0 to 1; a number means the nearest double. Where the file has numbers, an expression in these: \"1 - 2*x\".",
          "oneOf": [
            {"type": "number", "minimum": 0, "maximum": 1},
            {"type": "string"}
          ]
        }
      }
    },
    "numbers": {
      "description": "Algebraic numbers x, y, z for the coordinates, each by a polynomial and an interval that holds one of its zeros. Degrees of precision are those of the exact numbers; a problem is solved with 70 digits of them.",
      "type": "object",
      "additionalProperties": false,
      "properties": {"x": {"$ref": "#/$defs/number"}, "y": {"$ref": "#/$defs/number"}, "z": {"$ref": "#/$defs/number"}}
    },
    "certificate": {
      "description": "A claim of symmetric nodes close to these, proved again whenever the file is read.",
      "type": "object",
      "required": ["method", "precision", "radius", "orbits"],
      "additionalProperties": false,
      "properties": {
        "method": {"const": "krawczyk"},
        "precision": {"description": "The degree of precision of the rule on the triangle.", "type": "integer", "minimum": 0, "maximum": 40},
        "radius": {"description": "How far the true coordinates lie from those of the file, at most.", "type": ["string", "number"]},
        "orbits": {
          "description": "The nodes in their order. 1: the centroid; 3: (1 - 2a, a, a), (a, 1 - 2a, a), (a, a, 1 - 2a); 6: (a, b, c), (a, c, b), (b, a, c), (b, c, a), (c, a, b), (c, b, a).",
          "type": "array",
          "minItems": 1,
          "items": {
            "type": "object",
            "required": ["size", "held"],
            "additionalProperties": false,
            "properties": {
              "size": {"enum": [1, 3, 6]},
              "held": {"description": "Whether a is a number that was chosen, and no unknown.", "type": "boolean"}
            }
          }
        }
      }
    }
  },
  "$defs": {
    "exact": {"description": "A decimal or fraction in a string; a number means the nearest double.", "type": ["number", "string"]},
    "number": {
      "type": "object",
      "required": ["polynomial", "between"],
      "additionalProperties": false,
      "properties": {
        "polynomial": {"description": "Its coefficients, the constant first.", "type": "array", "minItems": 2, "items": {"$ref": "#/$defs/exact"}},
        "between": {"description": "The ends of an interval with one zero.", "type": "array", "minItems": 2, "maxItems": 2, "items": {"$ref": "#/$defs/exact"}}
      }
    }
  }
}
)json";
}

std::string_view basis_schema() {
  return R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "What is known of bases on a triangle",
  "type": "object",
  "required": ["schema", "radcert", "command", "bases"],
  "additionalProperties": false,
  "properties": {
    "schema": {"const": "radcert/basis/1"},
    "radcert": {"description": "The version that wrote the file.", "type": "string"},
    "command": {"description": "How it was called.", "type": "string"},
    "bases": {"type": "array", "minItems": 1, "items": {"$ref": "#/$defs/basis"}}
  },
  "$defs": {
    "exact": {"description": "A fraction; or, where that is longer than 24 characters, a decimal of 60 digits, rounded to nearest: the number is within half a unit of its last digit.", "type": "string", "pattern": "^-?[0-9]+([.][0-9]+)?(e[-+]?[0-9]+)?(/[0-9]+)?$"},
    "order": {"description": "p of O(h^p).", "type": "integer", "minimum": 1},
    "precision": {
      "type": "object",
      "required": ["degree", "first_failure", "defect", "defect_radius", "proof"],
      "additionalProperties": false,
      "properties": {
        "degree": {"type": "integer", "minimum": 0},
        "first_failure": {"description": "A monomial of the next degree that the rule misses; s = x3, t = x2.", "type": "string"},
        "defect": {"description": "Rule minus integral there, a midpoint; defect_radius bounds the distance of this decimal from it.", "type": "string"},
        "defect_radius": {"type": "string"},
        "proof": {
          "description": "exact: for the nodes as they stand; algebraic: for the algebraic nodes that these approximate; certificate: for the nodes that Krawczyk's test proves beside these.",
          "enum": ["exact", "algebraic", "certificate"]
        }
      }
    },
    "basis": {
      "type": "object",
      "required": ["family", "degree", "reproduces", "alpha", "file", "space", "nodes", "weight_signs", "unisolvent", "determinant", "precision", "product_precision", "norm", "condition", "orders"],
      "additionalProperties": false,
      "properties": {
        "family": {"enum": ["inset", "symmetric", "file"]},
        "degree": {"description": "Of the functions.", "type": "integer", "minimum": 0, "maximum": 12},
        "reproduces": {"description": "All polynomials of this degree are among the functions' combinations.", "type": "integer", "minimum": 0, "maximum": 12},
        "alpha": {"description": "As it was asked for.", "type": ["string", "null"]},
        "file": {"type": ["string", "null"]},
        "space": {"description": "The functions of the file; null: all polynomials of the degree.", "type": ["array", "null"], "items": {"type": "string"}},
        "nodes": {
          "type": "array",
          "minItems": 1,
          "items": {
            "type": "object",
            "required": ["barycentric", "weight"],
            "additionalProperties": false,
            "properties": {
              "barycentric": {"type": "array", "minItems": 3, "maxItems": 3, "items": {"$ref": "#/$defs/exact"}},
              "weight": {"description": "Of the interpolatory rule; their sum is 1/2.", "$ref": "#/$defs/exact"}
            }
          }
        },
        "weight_signs": {
          "type": "object",
          "required": ["positive", "zero", "negative"],
          "additionalProperties": false,
          "properties": {
            "positive": {"type": "integer", "minimum": 0},
            "zero": {"type": "integer", "minimum": 0},
            "negative": {"type": "integer", "minimum": 0}
          }
        },
        "unisolvent": {"const": true},
        "determinant": {"description": "Of the Bernstein polynomials, or of the functions of the space, at the nodes, exact, or rounded to the nearest of 20 digits.", "type": "string"},
        "precision": {
          "description": "How far the interpolatory rule is exact on the triangle, and on the parallelogram of it and its image under a half turn.",
          "type": "object",
          "required": ["triangle", "parallelogram"],
          "additionalProperties": false,
          "properties": {"triangle": {"$ref": "#/$defs/precision"}, "parallelogram": {"$ref": "#/$defs/precision"}}
        },
        "product_precision": {
          "description": "The largest d with Int q (p - P p) = 0 for all polynomials of degrees that add up to d, which the orders follow; for all polynomials of a degree the same as precision.",
          "type": "object",
          "required": ["triangle", "parallelogram"],
          "additionalProperties": false,
          "properties": {"triangle": {"type": "integer", "minimum": 0}, "parallelogram": {"type": "integer", "minimum": 0}}
        },
        "norm": {
          "description": "Of interpolation in the maximum norm: proved bounds, and a point where the lower one is attained.",
          "type": "object",
          "required": ["lower", "upper", "near"],
          "additionalProperties": false,
          "properties": {
            "lower": {"type": "number"},
            "upper": {"type": "number"},
            "near": {"type": "array", "minItems": 3, "maxItems": 3, "items": {"type": "number"}}
          }
        },
        "condition": {"description": "The norm of the map from values at the nodes to Bernstein coefficients, rounded up; it bounds the norm.", "type": "number"},
        "orders": {
          "description": "What theory predicts for smooth data: everywhere; at the nodes of a smooth surface with a symmetric triangulation; where the kernel is smooth at P = Q as well and between distinct pieces; at the nodes where pieces meet at an angle.",
          "type": "object",
          "required": ["everywhere", "nodes_smooth", "nodes_smooth_logarithm", "nodes_smooth_kernel", "nodes_at_edges"],
          "additionalProperties": false,
          "properties": {
            "everywhere": {"$ref": "#/$defs/order"},
            "nodes_smooth": {"$ref": "#/$defs/order"},
            "nodes_smooth_logarithm": {"description": "Whether a factor |log h| may stand beside it.", "type": "boolean"},
            "nodes_smooth_kernel": {"$ref": "#/$defs/order"},
            "nodes_at_edges": {"$ref": "#/$defs/order"}
          }
        }
      }
    }
  }
}
)json";
}

}  // namespace radcert
