// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/schema/schema_texts.h"

namespace radcert {

std::string_view problem_schema() {
  return R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "A problem of radcert",
  "description": "u(P) - rho(P)/pi Int_S G(P,Q) u(Q) dS_Q = E(P) on a surface S, solved by collocation, or with a meshless basis, at several levels. A string is exact; a JSON number means the nearest double.",
  "type": "object",
  "required": ["schema", "surface", "triangulation", "basis", "reflectivity"],
  "oneOf": [
    {"required": ["solution"], "not": {"required": ["emission"]}},
    {"required": ["emission"], "not": {"required": ["solution"]}}
  ],
  "additionalProperties": false,
  "properties": {
    "schema": {"const": "radcert/problem/1"},
    "surface": {
      "description": "A surface of the catalogue and its parameters, see radcert list surfaces; or a mesh.",
      "type": "object",
      "oneOf": [
        {"required": ["name"]},
        {
          "required": ["file"],
          "properties": {
            "file": {
              "description": "A mesh: .off, .obj, .ply or .stl, relative to the folder of this file. It must be certified to lie in the boundary of a convex body.",
              "type": "string",
              "minLength": 1
            },
            "angle": {
              "description": "In degrees, from 0 to 180: an edge whose triangles' normals make a larger one parts two pieces. Default 30.",
              "$ref": "#/$defs/exact"
            },
            "repair": {
              "description": "What may be mended; without it nothing is.",
              "type": "array",
              "items": {"enum": ["triangulate", "vertices", "faces", "orientation", "manifold", "crossings", "holes"]}
            },
            "digest": {"description": "SHA-256 of the file's bytes; where given, another file is refused.", "type": "string", "pattern": "^sha256-[0-9a-f]{64}$"}
          },
          "additionalProperties": false
        }
      ],
      "properties": {"name": {
        "enum": [
          "two_squares", "two_piece", "cube", "box", "sphere", "ellipsoid", "spherical_cap", "cylinder", "cone",
          "paraboloid_cap", "tetrahedron", "octahedron"
        ]
      }},
      "allOf": [
        {
          "if": {"required": ["name"], "properties": {"name": {
            "enum": ["two_squares", "cube", "sphere", "paraboloid_cap", "tetrahedron", "octahedron"]
          }}},
          "then": {"properties": {"name": true}, "additionalProperties": false}
        },
        {
          "if": {"required": ["name"], "properties": {"name": {"const": "two_piece"}}},
          "then": {
            "properties": {"name": true, "p": {"description": "p >= 1", "$ref": "#/$defs/exact"}},
            "additionalProperties": false
          }
        },
        {
          "if": {"required": ["name"], "properties": {"name": {"enum": ["box", "ellipsoid"]}}},
          "then": {
            "properties": {
              "name": true,
              "a": {"$ref": "#/$defs/exact"},
              "b": {"$ref": "#/$defs/exact"},
              "c": {"$ref": "#/$defs/exact"}
            },
            "additionalProperties": false
          }
        },
        {
          "if": {"required": ["name"], "properties": {"name": {"const": "spherical_cap"}}},
          "then": {
            "properties": {
              "name": true,
              "fraction": {"description": "Of the sphere's area, in [1/1000, 999/1000].", "$ref": "#/$defs/exact"}
            },
            "additionalProperties": false
          }
        },
        {
          "if": {"required": ["name"], "properties": {"name": {"const": "cylinder"}}},
          "then": {
            "properties": {
              "name": true,
              "radius": {"$ref": "#/$defs/exact"},
              "height": {"$ref": "#/$defs/exact"}
            },
            "additionalProperties": false
          }
        },
        {
          "if": {"required": ["name"], "properties": {"name": {"const": "cone"}}},
          "then": {
            "properties": {
              "name": true,
              "radius": {"$ref": "#/$defs/exact"},
              "top": {"description": "The radius of the upper end; the cone is truncated.", "$ref": "#/$defs/exact"},
              "height": {"$ref": "#/$defs/exact"}
            },
            "additionalProperties": false
          }
        }
      ]
    },
    "triangulation": {
      "type": "object",
      "required": ["levels"],
      "additionalProperties": false,
      "properties": {
        "levels": {
          "description": "Numbers of symmetric refinements, strictly ascending; 0 is the coarse triangulation.",
          "type": "array",
          "minItems": 1,
          "uniqueItems": true,
          "items": {"type": "integer", "minimum": 0, "maximum": 30}
        },
        "pattern": {
          "description": "Which diagonal cuts each square: main from (0,0) to (1,1), anti from (1,0) to (0,1).",
          "default": "published",
          "oneOf": [
            {"enum": ["published", "main", "anti"]},
            {"type": "object", "minProperties": 1, "additionalProperties": {"enum": ["main", "anti"]}}
          ]
        },
        "grading": {"description": "Exponent >= 1 towards the edges.", "default": 1, "$ref": "#/$defs/exact"}
      }
    },
    "geometry": {
      "description": "exact for meshless bases. What the collocation integrals are taken over: S itself, or its interpolant of a degree, element by element.",
      "default": "exact",
      "oneOf": [
        {"const": "exact"},
        {
          "type": "object",
          "required": ["interpolated"],
          "additionalProperties": false,
          "properties": {
            "interpolated": {"type": "integer", "minimum": 1, "maximum": 6},
            "data": {
              "description": "Where reflectivity, emission and solution are taken, and Ku: on S at the nodes' true places, or on the interpolant.",
              "default": "surface",
              "enum": ["surface", "interpolant"]
            }
          }
        }
      ]
    },
    "basis": {
      "oneOf": [
        {
          "type": "object",
          "required": ["family", "degree"],
          "additionalProperties": false,
          "if": {"properties": {"degree": {"minimum": 1}}},
          "then": {"required": ["alpha"]},
          "properties": {
            "family": {"const": "inset"},
            "degree": {"type": "integer", "minimum": 0, "maximum": 8},
            "alpha": {
              "description": "How far the nodes are pulled in from the corners: 0 <= alpha < 1/3, or superconvergent at degrees 1 and 3: the one that gains a degree of precision. At degree 0 it may be left out and has no effect.",
              "oneOf": [{"const": "superconvergent"}, {"$ref": "#/$defs/exact"}]
            }
          }
        },
        {
          "type": "object",
          "required": ["family", "degree"],
          "additionalProperties": false,
          "properties": {
            "family": {"const": "symmetric"},
            "degree": {"type": "integer", "minimum": 1, "maximum": 6}
          }
        },
        {
          "type": "object",
          "required": ["file"],
          "additionalProperties": false,
          "properties": {
            "file": {
              "description": "A file of nodes, relative to the folder of this file: see radcert schema nodes.",
              "type": "string"
            },
            "digest": {"description": "SHA-256 of the file's bytes; where given, another file is refused.", "type": "string", "pattern": "^sha256-[0-9a-f]{64}$"}
          }
        },
        {"description": "A meshless basis with all defaults.", "enum": ["shepard", "gaussian", "lehtinen"]},
        {
          "description": "Shepard's basis, psg10 (16).",
          "type": "object",
          "required": ["family"],
          "additionalProperties": false,
          "properties": {
            "family": {"const": "shepard"},
            "sites": {"$ref": "#/$defs/sites"},
            "weights": {"$ref": "#/$defs/weights"},
            "coefficients": {"$ref": "#/$defs/coefficients"}
          }
        },
        {
          "description": "Gaussian elements, psg10 (17), or Lehtinen's basis, (18).",
          "type": "object",
          "required": ["family"],
          "additionalProperties": false,
          "properties": {
            "family": {"enum": ["gaussian", "lehtinen"]},
            "radius": {"$ref": "#/$defs/neighbour"},
            "sites": {"$ref": "#/$defs/sites"},
            "weights": {"$ref": "#/$defs/weights"},
            "coefficients": {"$ref": "#/$defs/coefficients"}
          }
        },
        {
          "description": "A basis of one's own: mother function, site distance, radius rule and normalisation, psg10 sections V and VI.",
          "type": "object",
          "required": ["family", "mother"],
          "additionalProperties": false,
          "if": {"properties": {"mother": {"enum": ["spline", "shepard"]}}},
          "then": {"properties": {"support": false}},
          "properties": {
            "family": {"const": "meshless"},
            "mother": {
              "description": "gaussian, spline, shepard, or an expression in r, the distance over the radius.",
              "type": "string",
              "minLength": 1,
              "maxLength": 4096
            },
            "support": {
              "description": "The r beyond which the elements are 0, or none. Default 4 for gaussian, none for an expression.",
              "anyOf": [{"const": "none"}, {"$ref": "#/$defs/exact"}]
            },
            "distance": {
              "default": "normal_sensitive",
              "enum": ["normal_sensitive", "euclidean_with_normal_factor", "euclidean"]
            },
            "radius": {
              "description": "The unit of r about a site: the distance of a neighbour, or absolute, which is 1.",
              "default": {"neighbour": 10},
              "anyOf": [{"const": "absolute"}, {"$ref": "#/$defs/neighbour"}]
            },
            "normalise": {"default": "partition_of_unity", "enum": ["none", "partition_of_unity"]},
            "sites": {"$ref": "#/$defs/sites"},
            "weights": {"$ref": "#/$defs/weights"},
            "coefficients": {"$ref": "#/$defs/coefficients"}
          }
        }
      ]
    },
    "reflectivity": {"description": "rho, from 0 to 1.", "$ref": "#/$defs/piecewise"},
    "solution": {"description": "u; the emission is then E = u - Ku.", "$ref": "#/$defs/piecewise"},
    "emission": {
      "description": "E, the power emitted per area, not the material constant 1 - rho.",
      "$ref": "#/$defs/piecewise"
    },
    "quadrature": {
      "type": "object",
      "default": {"tolerance": "1e-13"},
      "required": ["tolerance"],
      "additionalProperties": false,
      "properties": {
        "tolerance": {
          "description": "Without effect for meshless bases. Of an entry of the collocation matrix, relative to its row's integral of |G|: from 1e-13, what double can hold, to 1e-2.",
          "$ref": "#/$defs/exact"
        }
      }
    },
    "solver": {
      "type": "object",
      "default": {"name": "direct"},
      "required": ["name"],
      "additionalProperties": false,
      "properties": {
        "name": {
          "description": "direct or neumann for meshless bases. verified encloses every number on the way: errors at the nodes with a guaranteed radius, on surfaces in the boundary of a convex body.",
          "enum": ["direct", "gmres", "neumann", "verified"]
        },
        "tolerance": {
          "description": "Of gmres and neumann: what the solver may leave of the linear system's error, as a part of max |u_n|, from 2^-51 to below 1. rounding: as little as double holds.",
          "default": "rounding",
          "anyOf": [{"const": "rounding"}, {"$ref": "#/$defs/exact"}]
        }
      },
      "if": {"properties": {"name": {"enum": ["direct", "verified"]}}},
      "then": {"properties": {"tolerance": false}}
    }
  },
  "$defs": {
    "neighbour": {
      "description": "The radius of a site is the distance of its neighbour of this number. too_few: what to do where fewer others are at a finite distance.",
      "type": "object",
      "required": ["neighbour"],
      "additionalProperties": false,
      "properties": {
        "neighbour": {"type": "integer", "minimum": 1, "maximum": 1000000},
        "too_few": {"default": "refuse", "enum": ["refuse", "farthest"]}
      }
    },
    "sites": {
      "description": "Of level 0. At level k sites are separation/2^k apart, or 4^k times as many; the seed is the same.",
      "type": "object",
      "default": {"uniform": 400, "seed": 1},
      "oneOf": [{"required": ["poisson_disk"]}, {"required": ["uniform"]}],
      "additionalProperties": false,
      "properties": {
        "poisson_disk": {"description": "The least distance of two sites, > 0; there are as many as find room.", "$ref": "#/$defs/exact"},
        "uniform": {"description": "The number of sites, each anywhere by area.", "type": "integer", "minimum": 1, "maximum": 9007199254740992},
        "seed": {"description": "Of the random numbers; the same seed gives the same sites on every machine.", "default": 1, "type": "integer", "minimum": 0, "maximum": 18446744073709551615}
      }
    },
    "weights": {
      "description": "The brightness w_j of the light at a site: the integral of its element, or an estimate of psg10 section VII.",
      "default": "integrated",
      "enum": ["integrated", "plane", "neighbours", "mean_density"]
    },
    "coefficients": {
      "description": "How values at the sites become coefficients: taken as they are (R = N), or such that u_n has them at the sites (R = A^-1 N).",
      "default": "as_values",
      "enum": ["as_values", "interpolated"]
    },
    "exact": {
      "description": "A number, or a decimal or a fraction in a string.",
      "anyOf": [
        {"type": "number"},
        {
          "type": "string",
          "maxLength": 1000,
          "pattern": "^-?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?(/([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?)?$"
        }
      ]
    },
    "expression": {
      "description": "x, y, z, pi, + - * / ^ (right-associative, above unary minus), sqrt, exp, log, sin, cos, tan, atan, abs, min, max.",
      "anyOf": [{"type": "number"}, {"type": "string", "minLength": 1, "maxLength": 4096}]
    },
    "piecewise": {
      "description": "An expression, or one a piece, * for the rest.",
      "anyOf": [
        {"$ref": "#/$defs/expression"},
        {"type": "object", "minProperties": 1, "additionalProperties": {"$ref": "#/$defs/expression"}}
      ]
    }
  }
}
)json";
}

}  // namespace radcert
