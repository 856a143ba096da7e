// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "progress.h"
#include "radcert/formats/json/json_value.h"
#include "radcert/picture/image.h"

namespace radcert::app {

/// How a picture is wanted; what is absent is the picture's own.
struct PictureWish {
  std::size_t width = 0;
  std::size_t height = 0;
  std::size_t samples = 2;             ///< rays a pixel each way
  std::optional<double> separation{};  ///< of the sites
  std::uint64_t seed = 1;
  bool exact_direct = false;  ///< direct light as it is, not in the basis
  std::optional<double> white{};
  std::uint64_t memory = 0;  ///< bytes that may be used
};

/// A picture that is made.
struct PaperPicture {
  Image image;
  std::string shows;                                     ///< in one line of ASCII
  std::vector<std::pair<std::string, JsonValue>> facts;  ///< what it was made with, and what was found
};

/// A picture that can be made.
struct PictureKind {
  std::string_view name;
  std::string_view summary;
  std::size_t width;  ///< unless another is wanted
  std::size_t height;
  bool has_separation;  ///< whether --separation means something
  bool has_seed;
  bool has_direct;
  bool has_white;
  bool has_rays;  ///< --samples does
  PaperPicture (*make)(const PictureWish& wish, ProgressDisplay& progress);
};

/// In the order of the paper.
const std::vector<PictureKind>& picture_kinds();

}  // namespace radcert::app
