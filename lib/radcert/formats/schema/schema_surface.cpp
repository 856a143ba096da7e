// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/schema/schema_texts.h"

namespace radcert {

std::string_view surface_schema() {
  return R"json({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "What radcert surface prints",
  "description": "A mesh or a surface of the catalogue, and what is decided about it. null: not known of this kind of surface, or not decided.",
  "type": "object",
  "required": [
    "schema", "radcert", "command", "name", "kind", "file", "vertices", "triangles", "angle", "smooth_components", "pieces",
    "edges", "corners", "planes", "closed", "open_edges", "open_lines", "connected_components", "euler_characteristic",
    "orientation", "defects", "containment", "unoccluded", "obstacle", "quality"
  ],
  "additionalProperties": false,
  "properties": {
    "schema": {"const": "radcert/surface/1"},
    "radcert": {"description": "The version that wrote the file.", "type": "string"},
    "command": {"description": "How it was called.", "type": "string"},
    "name": {"type": "string"},
    "kind": {"enum": ["mesh", "catalogue"]},
    "file": {
      "type": ["object", "null"],
      "required": [
        "format", "digest", "vertices", "faces", "joined_corners", "cut_faces", "bent_faces", "precision", "precision_unit",
        "mended"
      ],
      "additionalProperties": false,
      "properties": {
        "format": {"type": "string"},
        "digest": {"type": "string"},
        "vertices": {"$ref": "#/$defs/count"},
        "faces": {"$ref": "#/$defs/count"},
        "joined_corners": {"description": "Of an STL file: corners found equal to others.", "$ref": "#/$defs/count"},
        "cut_faces": {"description": "Faces of more than three corners, cut into triangles.", "$ref": "#/$defs/count"},
        "bent_faces": {"description": "Those of them that do not lie in one plane exactly.", "$ref": "#/$defs/count"},
        "precision": {"description": "How the file gives its coordinates.", "type": "string"},
        "precision_unit": {"description": "What rounding may have taken from the largest coordinate.", "type": "number", "minimum": 0},
        "mended": {"description": "What --repair changed.", "type": "array", "items": {"type": "string"}}
      }
    },
    "vertices": {"description": "Those that triangles use.", "$ref": "#/$defs/count_or_null"},
    "triangles": {"$ref": "#/$defs/count_or_null"},
    "angle": {"description": "In degrees: beyond it an edge is sharp.", "type": ["number", "null"]},
    "smooth_components": {"$ref": "#/$defs/count_or_null"},
    "pieces": {
      "description": "The smooth components, cut along the borders of groups; a problem names them.",
      "type": ["array", "null"],
      "items": {
        "type": "object",
        "required": ["name", "charts", "smooth_component"],
        "additionalProperties": false,
        "properties": {
          "name": {"type": "string"},
          "charts": {"$ref": "#/$defs/count"},
          "smooth_component": {"$ref": "#/$defs/count"}
        }
      }
    },
    "edges": {"description": "Lines of sharp edges, from corner to corner or closed.", "$ref": "#/$defs/count_or_null"},
    "corners": {"$ref": "#/$defs/places_or_null"},
    "planes": {"description": "Different planes of the triangles, exactly.", "$ref": "#/$defs/count_or_null"},
    "closed": {"type": "boolean"},
    "open_edges": {"$ref": "#/$defs/places_or_null"},
    "open_lines": {"$ref": "#/$defs/count_or_null"},
    "connected_components": {"$ref": "#/$defs/count_or_null"},
    "euler_characteristic": {"type": ["integer", "null"]},
    "orientation": {
      "type": ["object", "null"],
      "required": ["consistent", "counterclockwise_from", "known_by"],
      "additionalProperties": false,
      "properties": {
        "consistent": {"type": "boolean"},
        "counterclockwise_from": {"enum": ["outside", "inside"]},
        "known_by": {"enum": ["volume", "certificate", "convention"]}
      }
    },
    "defects": {
      "type": ["object", "null"],
      "required": [
        "duplicate_vertices", "unreferenced_vertices", "degenerate_triangles", "crossing_triangles", "disagreeing_edges",
        "crowded_edges", "pinched_vertices"
      ],
      "additionalProperties": false,
      "properties": {
        "duplicate_vertices": {"$ref": "#/$defs/places"},
        "unreferenced_vertices": {"$ref": "#/$defs/places"},
        "degenerate_triangles": {"$ref": "#/$defs/places"},
        "crossing_triangles": {"description": "At most 1000 pairs are counted.", "$ref": "#/$defs/places"},
        "disagreeing_edges": {"$ref": "#/$defs/places"},
        "crowded_edges": {"$ref": "#/$defs/places"},
        "pinched_vertices": {"$ref": "#/$defs/places"},
        "misoriented_components": {
          "description": "First triangles of the components of a closed mesh whose inner side is not the inside of the body.",
          "$ref": "#/$defs/places"
        }
      }
    },
    "containment": {
      "description": "Whether the surface lies in the boundary of a convex body, its normals pointing inwards.",
      "type": "object",
      "required": [
        "verdict", "reason", "planes", "violated_planes", "relative_depth", "within_precision", "witness", "steps", "open"
      ],
      "additionalProperties": false,
      "properties": {
        "verdict": {"enum": ["certified", "refuted", "undecided"]},
        "reason": {"type": "string"},
        "planes": {"$ref": "#/$defs/count_or_null"},
        "violated_planes": {"$ref": "#/$defs/count_or_null"},
        "relative_depth": {
          "description": "The largest distance of a vertex behind a plane, over the diagonal of the box about the surface.",
          "type": ["number", "null"]
        },
        "within_precision": {
          "description": "Whether rounding of the file's coordinates may account for it.",
          "type": ["boolean", "null"]
        },
        "witness": {
          "description": "(q - p) . inner_normal = product < 0: exactly for a mesh, in balls at exact parameters for charts.",
          "oneOf": [
            {"type": "null"},
            {
              "type": "object",
              "required": ["p", "q", "inner_normal", "product", "triangle", "vertex"],
              "additionalProperties": false,
              "properties": {
                "p": {"$ref": "#/$defs/exact_point"},
                "q": {"$ref": "#/$defs/exact_point"},
                "inner_normal": {"$ref": "#/$defs/exact_point"},
                "product": {"$ref": "#/$defs/fraction"},
                "triangle": {"$ref": "#/$defs/count"},
                "vertex": {"$ref": "#/$defs/count"}
              }
            },
            {
              "type": "object",
              "required": [
                "chart_p", "parameters_p", "chart_q", "parameters_q", "p", "q", "inner_normal", "product"
              ],
              "additionalProperties": false,
              "properties": {
                "chart_p": {"type": "string"},
                "parameters_p": {"$ref": "#/$defs/exact_parameters"},
                "chart_q": {"type": "string"},
                "parameters_q": {"$ref": "#/$defs/exact_parameters"},
                "p": {"$ref": "#/$defs/enclosed_point"},
                "q": {"$ref": "#/$defs/enclosed_point"},
                "inner_normal": {"$ref": "#/$defs/enclosed_point"},
                "product": {"type": "string"}
              }
            }
          ]
        },
        "steps": {
          "description": "Of charts: what was proved, and how; what is stated of them and was not proved.",
          "type": "array",
          "items": {
            "type": "object",
            "required": ["of", "proof"],
            "additionalProperties": false,
            "properties": {"of": {"type": "string"}, "proof": {"type": "string"}}
          }
        },
        "open": {
          "description": "Pairs of charts that are left; boxes 0: not begun.",
          "type": "array",
          "items": {
            "type": "object",
            "required": ["chart_p", "chart_q", "boxes"],
            "additionalProperties": false,
            "properties": {
              "chart_p": {"type": "string"},
              "chart_q": {"type": "string"},
              "boxes": {"$ref": "#/$defs/count"}
            }
          }
        }
      }
    },
    "unoccluded": {"description": "Whether no part of the surface hides another.", "type": ["boolean", "null"]},
    "obstacle": {"description": "Why radcert solve refuses the mesh; null: it does not.", "type": ["string", "null"]},
    "quality": {
      "type": ["object", "null"],
      "required": [
        "area", "shortest_side", "longest_side", "smallest_angle", "largest_angle", "largest_aspect", "worst_triangle"
      ],
      "additionalProperties": false,
      "properties": {
        "area": {"type": "number"},
        "shortest_side": {"type": "number"},
        "longest_side": {"type": "number"},
        "smallest_angle": {"type": "number"},
        "largest_angle": {"type": "number"},
        "largest_aspect": {"description": "1 for equal sides.", "type": "number"},
        "worst_triangle": {"$ref": "#/$defs/count"}
      }
    }
  },
  "$defs": {
    "count": {"type": "integer", "minimum": 0},
    "count_or_null": {"type": ["integer", "null"], "minimum": 0},
    "fraction": {"type": "string", "pattern": "^-?[0-9]+(/[0-9]+)?$"},
    "exact_point": {"type": "array", "minItems": 3, "maxItems": 3, "items": {"$ref": "#/$defs/fraction"}},
    "exact_parameters": {"type": "array", "minItems": 2, "maxItems": 2, "items": {"$ref": "#/$defs/fraction"}},
    "enclosed_point": {
      "description": "Each coordinate a midpoint and a radius.",
      "type": "array", "minItems": 3, "maxItems": 3, "items": {"type": "string"}
    },
    "places": {
      "type": "object",
      "required": ["count", "first"],
      "additionalProperties": false,
      "properties": {"count": {"$ref": "#/$defs/count"}, "first": {"type": "array", "maxItems": 10}}
    },
    "places_or_null": {"oneOf": [{"$ref": "#/$defs/places"}, {"type": "null"}]}
  }
}
)json";
}

}  // namespace radcert
