// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/picture/stroke_font.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/text.h"

namespace radcert {
namespace {

constexpr char first_character = ' ';
constexpr char last_character = '~';

/// A letter: its width, and strokes with a bar between them, numbers x y x y ...; ~ before a smooth stroke, o before a closed smooth one.
struct LetterText {
  double width;
  std::string_view strokes;
};

// In the order of ASCII.
constexpr std::array<LetterText, last_character - first_character + 1> letters{{
    {2, ""},
    {0, "0 8 0 2.6|0 0.1 0 0"},
    {2, "0 8 0 5.6|2 8 2 5.6"},
    {5, "1.2 0 2.2 8|3.2 0 4.2 8|0 2.7 5 2.7|0.2 5.3 5.2 5.3"},
    {5,
     "~4.8 6.3 3.9 7 2.5 7.2 0.9 6.7 0.4 5.5 1.2 4.5 2.5 4 4 3.5 4.8 2.4 4.1 1.2 2.5 0.8 1 1 0 1.8|2.5 8.2 "
     "2.5 -0.2"},
    {7,
     "6.3 8 0.7 0|o 1.5 8 0.3 7.2 0 6 0.3 4.8 1.5 4 2.7 4.8 3 6 2.7 7.2|o 5.5 4 4.3 3.2 4 2 4.3 0.8 5.5 0 "
     "6.7 0.8 7 2 6.7 3.2"},
    {6,
     "~6 0 4 2.2 1.6 5.4 1.3 6.8 2 7.8 3 8 3.9 7.4 4 6.3 3.2 5.2 1 3.7 0.1 2.4 0.4 0.9 1.8 0 3.4 0.2 4.8 1.4 "
     "5.6 3.4"},
    {0, "0 8 0 5.6"},
    {2, "~2 9 0.8 7 0.1 4.8 0 3.5 0.1 2.2 0.8 0 2 -2"},
    {2, "~0 9 1.2 7 1.9 4.8 2 3.5 1.9 2.2 1.2 0 0 -2"},
    {4, "2 7.4 2 3|0.1 6.3 3.9 4.1|0.1 4.1 3.9 6.3"},
    {5, "2.5 6.2 2.5 1.2|0 3.7 5 3.7"},
    {1, "0.6 0.4 0 -1.4"},
    {4, "0 3.4 4 3.4"},
    {0, "0 0.15 0 0"},
    {4, "0 -0.6 4 8.6"},
    {5, "o 2.5 8 0.7 6.9 0 4 0.7 1.1 2.5 0 4.3 1.1 5 4 4.3 6.9"},
    {3, "0 6.4 2.2 8 2.2 0"},
    {5, "~0.2 6 0.8 7.5 2.5 8 4.2 7.4 4.7 5.9 4 4.1 2.3 2.3 0 0|0 0 5 0"},
    {5, "~0.3 6.9 1.2 7.8 2.5 8 4.1 7.4 4.6 6 4 4.7 2 4.2|~2 4.2 4.2 3.7 5 2.2 4.3 0.7 2.5 0 1 0.3 0 1.3"},
    {5, "3.9 0 3.9 8 0 2.4 5.2 2.4"},
    {5, "4.5 8 0.8 8 0.4 4.3|~0.4 4.3 1.3 5 2.6 5.2 4.3 4.4 5 2.7 4.3 0.8 2.5 0 0.9 0.3 0 1.2"},
    {5,
     "~4.4 7.2 3.6 7.8 2.7 8 1.1 6.9 0.2 4.6 0.1 2 0.9 0.5 2.6 0 4.3 0.7 5 2.6 4.3 4.4 2.7 5.1 1.1 4.4 0.2 "
     "3"},
    {5, "0 8 5 8 1.7 0"},
    {5,
     "o 2.5 8 0.9 7.5 0.4 6.1 1 4.8 2.5 4.3 4 4.8 4.6 6.1 4.1 7.5|o 2.5 4.3 0.7 3.7 0 2.1 0.7 0.6 2.5 0 4.3 "
     "0.6 5 2.1 4.3 3.7"},
    {5,
     "~0.6 0.8 1.4 0.2 2.3 0 3.9 1.1 4.8 3.4 4.9 6 4.1 7.5 2.4 8 0.7 7.3 0 5.4 0.7 3.6 2.3 2.9 3.9 3.6 4.8 "
     "5"},
    {0, "0 5 0 4.85|0 0.15 0 0"},
    {1, "0.6 5 0.6 4.85|0.6 0.4 0 -1.4"},
    {5, "5 6.4 0 3.7 5 1"},
    {5, "0 5 5 5|0 2.4 5 2.4"},
    {5, "0 6.4 5 3.7 0 1"},
    {4, "~0.1 6.4 0.7 7.6 2 8 3.4 7.5 3.9 6.2 3.3 5 2.3 4.1 2 2.6|2 0.1 2 0"},
    {7,
     "~5.2 2.6 4.2 2 3 2.2 2.3 3.5 2.8 5 4.2 5.4 5.1 4.8|5.3 5.5 5.1 2.6|~5.1 2.6 5.8 2 6.7 2.6 7 4.2 6.3 "
     "6.6 4.6 7.9 2.6 7.8 0.9 6.4 0 4 0.7 1.4 2.4 0 4.4 0"},
    {6, "0 0 3 8 6 0|1.05 2.8 4.95 2.8"},
    {5,
     "0 0 0 8 2.6 8|~2.6 8 4.1 7.5 4.6 6.2 4.1 4.8 2.6 4.3|0 4.3 2.8 4.3|~2.8 4.3 4.4 3.7 5 2.2 4.4 0.6 2.8 "
     "0|2.8 0 0 0"},
    {6, "~6 6.4 4.9 7.6 3.3 8 1.4 7.3 0.2 5.4 0 4 0.2 2.6 1.4 0.7 3.3 0 4.9 0.4 6 1.6"},
    {5.6, "0 0 0 8 2.3 8|~2.3 8 4.3 7.3 5.4 5.6 5.6 4 5.4 2.4 4.3 0.7 2.3 0|2.3 0 0 0"},
    {4.6, "4.6 8 0 8 0 0 4.6 0|0 4.3 4 4.3"},
    {4.4, "4.4 8 0 8 0 0|0 4.3 3.8 4.3"},
    {6.2, "~6 6.5 4.9 7.6 3.3 8 1.4 7.3 0.2 5.4 0 4 0.2 2.6 1.4 0.7 3.3 0 4.9 0.4 6 1.3|6 1.3 6 3.7 3.6 3.7"},
    {5.6, "0 0 0 8|5.6 0 5.6 8|0 4.2 5.6 4.2"},
    {0, "0 0 0 8"},
    {3.6, "3.6 8 3.6 2|~3.6 2 3.2 0.6 1.8 0 0.5 0.5 0 1.7"},
    {5.2, "0 0 0 8|5 8 0 2.8|1.7 4.6 5.2 0"},
    {4.2, "0 8 0 0 4.2 0"},
    {6.6, "0 0 0 8 3.3 2 6.6 8 6.6 0"},
    {5.8, "0 0 0 8 5.8 0 5.8 8"},
    {6.6, "o 3.3 8 1.4 7.3 0.2 5.4 0 4 0.2 2.6 1.4 0.7 3.3 0 5.2 0.7 6.4 2.6 6.6 4 6.4 5.4 5.2 7.3"},
    {5, "0 0 0 8 2.8 8|~2.8 8 4.4 7.4 5 5.9 4.4 4.4 2.8 3.8|2.8 3.8 0 3.8"},
    {6.6,
     "o 3.3 8 1.4 7.3 0.2 5.4 0 4 0.2 2.6 1.4 0.7 3.3 0 5.2 0.7 6.4 2.6 6.6 4 6.4 5.4 5.2 7.3|4 2 6.6 -0.8"},
    {5.2, "0 0 0 8 2.8 8|~2.8 8 4.4 7.5 5 6 4.4 4.6 2.8 4.1|2.8 4.1 0 4.1|2.7 4.1 5.2 0"},
    {5, "~4.8 6.7 4 7.7 2.5 8 0.9 7.5 0.3 6.2 1 4.9 2.5 4.2 4.2 3.5 5 2.1 4.2 0.5 2.5 0 0.9 0.3 0 1.5"},
    {5.2, "0 8 5.2 8|2.6 8 2.6 0"},
    {5.6, "0 8 0 2.8|~0 2.8 0.7 0.8 2.8 0 4.9 0.8 5.6 2.8|5.6 2.8 5.6 8"},
    {5.8, "0 8 2.9 0 5.8 8"},
    {8, "0 8 2 0 4 7.4 6 0 8 8"},
    {5.4, "0 8 5.4 0|5.4 8 0 0"},
    {5.4, "0 8 2.7 4 5.4 8|2.7 4 2.7 0"},
    {5.2, "0 8 5.2 8 0 0 5.2 0"},
    {2, "2 9 0 9 0 -2 2 -2"},
    {4, "0 8.6 4 -0.6"},
    {2, "0 9 2 9 2 -2 0 -2"},
    {4, "0 5 2 8 4 5"},
    {5, "0 -1.6 5 -1.6"},
    {1.4, "0 8.2 1.4 6.6"},
    {4.2,
     "~0.4 4.5 1.2 5.2 2.3 5.4 3.6 4.9 4.1 3.6|4.1 3.6 4.1 0|~4.1 3.1 1.6 2.9 0.3 2.3 0 1.3 0.5 0.3 1.6 0 3 "
     "0.4 4.1 1.6"},
    {4.4, "0 8 0 0|~0 3.9 0.9 5 2.3 5.4 3.8 4.6 4.4 2.7 3.8 0.8 2.3 0 0.9 0.4 0 1.5"},
    {4, "~4 4.5 3.3 5.2 2.3 5.4 0.7 4.7 0 2.7 0.7 0.7 2.3 0 3.3 0.2 4 0.9"},
    {4.4, "4.4 8 4.4 0|~4.4 3.9 3.5 5 2.1 5.4 0.6 4.6 0 2.7 0.6 0.8 2.1 0 3.5 0.4 4.4 1.5"},
    {4.4, "0 3 4.4 3|~4.4 3 3.8 4.7 2.3 5.4 0.7 4.7 0 2.7 0.7 0.7 2.4 0 3.6 0.3 4.3 1.1"},
    {2.6, "~2.6 7.9 1.5 7.9 0.9 6.6|0.9 6.6 0.9 0|0 5.2 2.4 5.2"},
    {4.4,
     "4.4 5.4 4.4 -0.3|~4.4 -0.3 3.9 -1.8 2.3 -2.4 1 -2.1 0.2 -1.3|~4.4 3.9 3.5 5 2.1 5.4 0.6 4.6 0 2.7 0.6 "
     "0.8 2.1 0 3.5 0.4 4.4 1.5"},
    {4, "0 8 0 0|~0 3.6 0.9 4.9 2.2 5.4 3.5 4.9 4 3.4|4 3.4 4 0"},
    {0, "0 5.4 0 0|0 7.6 0 7.45"},
    {1.2, "1.2 5.4 1.2 -0.9|~1.2 -0.9 0.9 -2 0 -2.3|1.2 7.6 1.2 7.45"},
    {4, "0 8 0 0|3.8 5.4 0 1.9|1.4 3.2 4 0"},
    {1.2, "0 8 0 1.2|~0 1.2 0.3 0.2 1.2 0"},
    {6.8,
     "0 5.4 0 0|~0 3.6 0.8 4.9 1.9 5.4 3 4.9 3.4 3.4|3.4 3.4 3.4 0|~3.4 3.6 4.2 4.9 5.3 5.4 6.4 4.9 6.8 "
     "3.4|6.8 3.4 6.8 0"},
    {4, "0 5.4 0 0|~0 3.6 0.9 4.9 2.2 5.4 3.5 4.9 4 3.4|4 3.4 4 0"},
    {4.6, "o 2.3 5.4 0.7 4.7 0 2.7 0.7 0.7 2.3 0 3.9 0.7 4.6 2.7 3.9 4.7"},
    {4.4, "0 5.4 0 -2.4|~0 3.9 0.9 5 2.3 5.4 3.8 4.6 4.4 2.7 3.8 0.8 2.3 0 0.9 0.4 0 1.5"},
    {4.4, "4.4 5.4 4.4 -2.4|~4.4 3.9 3.5 5 2.1 5.4 0.6 4.6 0 2.7 0.6 0.8 2.1 0 3.5 0.4 4.4 1.5"},
    {2.4, "0 5.4 0 0|~0 3.2 0.8 4.8 2.4 5.4"},
    {3.8, "~3.6 4.6 2.9 5.2 1.9 5.4 0.7 5 0.2 4.1 0.8 3.2 1.9 2.8 3.2 2.3 3.8 1.4 3.2 0.4 1.9 0 0.7 0.2 0 1"},
    {2.6, "0.9 7.2 0.9 1.4|~0.9 1.4 1.4 0.1 2.6 0.1|0 5.2 2.5 5.2"},
    {4, "0 5.4 0 2|~0 2 0.5 0.5 1.8 0 3.1 0.5 4 1.8|4 5.4 4 0"},
    {4.2, "0 5.4 2.1 0 4.2 5.4"},
    {6, "0 5.4 1.5 0 3 5 4.5 0 6 5.4"},
    {4, "0 5.4 4 0|4 5.4 0 0"},
    {4.2, "0 5.4 2.1 0|4.2 5.4 1.4 -1.9|~1.4 -1.9 0.9 -2.4 0 -2.4"},
    {3.8, "0 5.4 3.8 5.4 0 0 3.8 0"},
    {2.4, "~2.4 9 1.4 8.4 1.2 6 1 4.2 0 3.5 1 2.8 1.2 1 1.4 -1.4 2.4 -2"},
    {0, "0 9 0 -2"},
    {2.4, "~0 9 1 8.4 1.2 6 1.4 4.2 2.4 3.5 1.4 2.8 1.2 1 1 -1.4 0 -2"},
    {5, "~0 3.1 0.6 4.2 1.5 4.5 2.5 3.7 3.5 3 4.4 3.3 5 4.3"},
}};

std::vector<double> numbers(std::string_view text) {
  std::vector<double> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const auto number = parse_double(text.substr(0, end));
    expects(number.has_value(), "a number in a letter", named("text", text));
    out.push_back(*number);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

/// A smooth line through points: Catmull and Rom's cubic between each two, eight parts each.
std::vector<ImagePoint> smooth(const std::vector<ImagePoint>& points, bool closed) {
  constexpr int parts = 8;
  const std::size_t n = points.size();
  const auto at = [&](std::size_t k, int shift) {
    const auto count = static_cast<std::ptrdiff_t>(n);
    const std::ptrdiff_t place = static_cast<std::ptrdiff_t>(k) + shift;
    return points[static_cast<std::size_t>(closed ? (place + count) % count
                                                  : std::clamp<std::ptrdiff_t>(place, 0, count - 1))];
  };
  std::vector<ImagePoint> out;
  for (std::size_t k = 0; k + (closed ? 0 : 1) < n; ++k)
    for (int part = 0; part < parts; ++part) {
      const double t = static_cast<double>(part) / parts;
      const auto cubic = [t](double a, double b, double c, double d) {
        return b + t / 2 * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
      };
      const ImagePoint p0 = at(k, -1);
      const ImagePoint p1 = at(k, 0);
      const ImagePoint p2 = at(k, 1);
      const ImagePoint p3 = at(k, 2);
      out.push_back({cubic(p0.x, p1.x, p2.x, p3.x), cubic(p0.y, p1.y, p2.y, p3.y)});
    }
  out.push_back(closed ? points.front() : points.back());
  return out;
}

StrokeLetter letter_of(const LetterText& text) {
  constexpr double between = 2;
  StrokeLetter letter{.advance = text.width + between, .strokes = {}};
  std::string_view rest = text.strokes;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('|'), rest.size());
    std::string_view stroke = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const bool open = stroke.front() == '~';
    const bool closed = stroke.front() == 'o';
    if (open) stroke.remove_prefix(1);
    if (closed) stroke.remove_prefix(2);
    const std::vector<double> xy = numbers(stroke);
    expects(xy.size() >= 4 && xy.size() % 2 == 0, "two points or more in a stroke", named("text", stroke));
    std::vector<ImagePoint> points;
    for (std::size_t k = 0; k < xy.size(); k += 2) points.push_back({xy[k], xy[k + 1]});
    letter.strokes.push_back(open || closed ? smooth(points, closed) : points);
  }
  return letter;
}

}  // namespace

const StrokeLetter& stroke_letter(char c) {
  static const std::vector<StrokeLetter> all = [] {
    std::vector<StrokeLetter> made;
    made.reserve(letters.size());
    for (const LetterText& text : letters) made.push_back(letter_of(text));
    return made;
  }();
  expects(c >= first_character && c <= last_character, "a printable character of ASCII",
          named("character", c));
  return all[static_cast<std::size_t>(c - first_character)];
}

}  // namespace radcert
