// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "radcert/formats/json/json_value.h"
#include "radcert/formats/plot/plot.h"
#include "radcert/picture/sheet.h"

namespace radcert::verification::psg10 {

/// How a figure is wanted; what is absent is the figure's own.
struct FigureWish {
  std::size_t width = 0;
  std::size_t height = 0;
  std::size_t samples = 2;             ///< rays a pixel each way
  std::optional<double> separation{};  ///< of the sites
  std::uint64_t seed = 1;
  bool exact_direct = false;  ///< direct light as it is, not in the basis
  std::optional<double> white{};
  std::uint64_t memory = 0;  ///< bytes that may be used
  bool has_words = true;     ///< titles and scales around the panels
};

/// Told from time to time which part of the work is done, and what begins now.
using FigureProgress = std::function<void(double part, const std::string& begins)>;

/// A figure that is made.
struct Figure {
  std::string shows;                                     ///< in one line of ASCII
  std::vector<std::pair<std::string, JsonValue>> facts;  ///< what it was made with, and what was found
  std::optional<Sheet> sheet{};                          ///< a picture; absent: it is plots
  std::vector<Plot> plots{};
};

/// A figure that can be made.
struct FigureKind {
  std::string_view name;
  std::string_view summary;
  std::size_t width;  ///< unless another is wanted; of plots none
  std::size_t height;
  bool has_separation;  ///< whether --separation means something
  bool has_seed;
  bool has_direct;
  bool has_white;
  bool has_rays;  ///< --samples and --size do: it is a picture, else plots
  Figure (*make)(const FigureWish& wish, const FigureProgress& progress);
};

/// The figures of [psg10] as radcert makes them, in the order of the paper.
/// Maths     the scene of figures 3, 5, 7 and 8 is lit_room(), for the paper gives none
/// Source    [psg10, figures 3-9]
/// Result    InputError where sites or a basis refuse the separation that was wanted, or where memory does
///           not do
[[nodiscard]] const std::vector<FigureKind>& figure_kinds();

}  // namespace radcert::verification::psg10
