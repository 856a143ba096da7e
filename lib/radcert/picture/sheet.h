// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "radcert/picture/image.h"
#include "radcert/picture/rendering.h"

namespace radcert {

/// A sheet of panels: a raster, and the words and the scale of colours that stand around it.
/// Maths     columns by rows of equal panels; with words each has its title above, and a scale stands to the
///           right of all
/// Requires  1 <= columns, rows; sides that an Image takes, else ContractViolation
/// Result    `image` is as large as the sheet, its margins white. Without words there is no room for titles
///           and scale, and a single panel is the whole sheet
class Sheet {
public:
  struct Layout {
    std::size_t width = 0;
    std::size_t height = 0;
    std::size_t columns = 1;
    std::size_t rows = 1;
    bool has_words = true;
    bool has_scale = false;
  };
  explicit Sheet(const Layout& layout);

  /// Where the panel of a place is, to be drawn by the caller.
  ImageRegion panel(std::size_t column, std::size_t row, std::string_view title);
  /// A scale beside a panel, linear from its low to its high.
  void add_scale(const ImageRegion& beside, const ColourScale& scale);

  /// The titles of the panels, in the order in which they were asked for.
  [[nodiscard]] std::vector<std::string> titles() const;

  /// The sheet as SVG, the raster within it as PNG.
  /// Source    SVG 1.1
  /// Requires  a description of printable ASCII, else ContractViolation
  /// Result    well-formed XML that asks for no other file
  /// Limits    black on white, whatever the reader prefers: so are the pictures
  [[nodiscard]] std::string svg_text(const std::string& description) const;

  Image image;

private:
  struct Titled {
    ImageRegion region;
    std::string title;
  };
  struct Scale {
    ImageRegion bar;
    ColourScale colours;
  };
  Layout layout_;
  double text_;        ///< the size of letters; 0 without words
  std::size_t gap_;    ///< between panels
  std::size_t above_;  ///< a panel, for its title
  std::size_t strip_;  ///< to the right, for the scale
  std::vector<Titled> titled_;
  std::optional<Scale> scale_;
};

}  // namespace radcert
