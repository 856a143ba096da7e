// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace radcert {

/// The parts that SVG files are written with.
/// Source    SVG 1.1
/// Requires  UTF-8
/// Result    each a line, two spaces in; texts are escaped; lengths to a hundredth of a unit
/// Limits    text is measured by its number of characters
namespace svg {

/// The root element as far as its contents, with title and desc. `style` is CSS: its rules begin with
/// .radcert, the root's class, for a page may hold several. A link of the namespace xlink may stand within.
[[nodiscard]] std::string head(double width, double height, std::string_view title,
                               std::string_view description, std::string_view style);
inline constexpr std::string_view foot = "</svg>\n";

/// A length as text.
[[nodiscard]] std::string coordinate(double value);
/// " name=\"value\"".
[[nodiscard]] std::string attribute(std::string_view name, double value);
/// A text as it stands between tags or quotes.
[[nodiscard]] std::string escaped(std::string_view text);

/// A line from (x1, y1) to (x2, y2); `of` is its class in CSS.
[[nodiscard]] std::string line(double x1, double y1, double x2, double y2, std::string_view of);
/// A text from its lower left; `more` are further attributes.
[[nodiscard]] std::string text(double x, double y, std::string_view words, std::string_view more = {});

/// About how wide a text is, for letters of that size in the usual fonts.
[[nodiscard]] double text_width(std::string_view words, double size);

}  // namespace svg
}  // namespace radcert
