// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/plot/svg_elements.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/text.h"
#include "radcert/formats/json/json_document.h"

namespace radcert::svg {

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : as_utf8(text)) switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      // No other control character may stand in XML.
      default: out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  return out;
}

std::string coordinate(double value) { return shortest(std::round(value * 100) / 100); }

std::string attribute(std::string_view name, double value) {
  return " " + std::string(name) + "=\"" + coordinate(value) + "\"";
}

std::string head(double width, double height, std::string_view title, std::string_view description,
                 std::string_view style) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:xlink=\"http://www.w3.org/1999/xlink\" class=\"radcert\"" +
         attribute("width", width) + attribute("height", height) + " viewBox=\"0 0 " + coordinate(width) +
         " " + coordinate(height) + "\" role=\"img\">\n  <title>" + escaped(title) + "</title>\n  <desc>" +
         escaped(description) + "</desc>\n  <style>" + std::string(style) +
         "  </style>\n  <rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n";
}

std::string line(double x1, double y1, double x2, double y2, std::string_view of) {
  return "  <line" + attribute("x1", x1) + attribute("y1", y1) + attribute("x2", x2) + attribute("y2", y2) +
         " class=\"" + std::string(of) + "\"/>\n";
}

std::string text(double x, double y, std::string_view words, std::string_view more) {
  return "  <text" + attribute("x", x) + attribute("y", y) + std::string(more) + ">" + escaped(words) +
         "</text>\n";
}

double text_width(std::string_view words, double size) {
  constexpr double a_letter = 0.55;
  return a_letter * size * static_cast<double>(std::count_if(words.begin(), words.end(), [](char c) {
           return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
         }));
}

}  // namespace radcert::svg
