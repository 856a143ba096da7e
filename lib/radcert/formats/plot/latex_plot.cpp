// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/plot/latex_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "radcert/core/text.h"
#include "radcert/formats/table/latex_table.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {

namespace {

// Five marks and eight colours, so that forty curves differ.
constexpr std::array<std::string_view, 5> marks = {"*", "square*", "triangle*", "diamond*", "pentagon*"};

/// The colours that the curves of a plot take.
std::string defined_colours(const Plot& plot) {
  std::string out;
  std::size_t count = 0;
  for (std::size_t i = 0; i < plot.curves.size(); ++i) count = std::max(count, plot.number_of(i) + 1);
  for (std::size_t i = 0; i < std::min(count, curve_colours.size()); ++i)
    out += "\\definecolor{radcert" + std::to_string(i) + "}{HTML}{" + std::string(curve_colours[i].on_white) +
           "}\n";
  return out;
}

std::string place(double x, double y) { return "(axis cs:" + shortest(x) + "," + shortest(y) + ")"; }

std::string triangle_text(const SlopeTriangle& triangle) {
  const double along = std::sqrt(triangle.x[0] * triangle.x[1]);
  const double up = std::sqrt(triangle.y[0]) * std::sqrt(triangle.y[1]);
  const auto [side, level] = triangle.right_angle();
  return "\\draw " + place(triangle.x[0], triangle.y[0]) + " -- " + place(triangle.x[1], triangle.y[1]) +
         " -- " + place(side, level) + " -- cycle;\n\\node[" + (triangle.above ? "above" : "below") +
         ",font=\\scriptsize] at " + place(along, level) + " {$1$};\n\\node[" +
         (side == triangle.x[0] ? "left" : "right") + ",font=\\scriptsize] at " + place(side, up) + " {$" +
         nearest_text(std::abs(triangle.exponent), DecimalForm::fixed(2)) + "$};\n";
}

/// A name as LaTeX.
std::string latex_name(const std::string& latex, const std::string& name) {
  return latex.empty() ? latex_escaped(name) : latex;
}

/// "5e-7" as a product.
std::string latex_tick(double tick) {
  std::string text = tick_text(tick);
  if (const std::size_t e = text.find('e'); e != std::string::npos)
    text = text.substr(0, e) + "\\cdot10^{" + text.substr(e + 1) + "}";
  return text;
}

/// The ticks of the horizontal axis: those of the SVG, which are no odd powers of ten where there is less
/// than a decade.
std::string ticks(const Plot& plot) {
  const auto [least, largest] = shown_range(plot).x;
  std::string places;
  std::string names;
  for (const double tick : axis_ticks(least, largest, plot.x.logarithmic)) {
    places += (places.empty() ? "" : ",") + shortest(tick);
    names += (names.empty() ? "$" : ",$") + latex_tick(tick) + "$";
  }
  return "  xtick={" + places + "},xticklabels={" + names + "},xminorticks=false,\n";
}

/// The ends of an axis that has a range of its own.
std::string ends(const std::string& axis, const std::optional<std::pair<double, double>>& range) {
  return range ? "  " + axis + "min=" + shortest(range->first) + "," + axis +
                     "max=" + shortest(range->second) + ",\n"
               : std::string();
}

/// Many short names stand side by side.
std::string legend_columns(const Plot& plot) {
  constexpr std::size_t many = 6;
  constexpr std::size_t is_short = 20;  // characters, three times which with their marks fit a line
  const bool fit = std::all_of(plot.curves.begin(), plot.curves.end(),
                               [](const PlotCurve& curve) { return curve.name.size() <= is_short; });
  return plot.curves.size() > many && fit ? ",legend columns=3" : "";
}

std::string environment(const Plot& plot) {
  if (plot.x.logarithmic) return plot.y.logarithmic ? "loglogaxis" : "semilogxaxis";
  return plot.y.logarithmic ? "semilogyaxis" : "axis";
}

std::string look(const PlotCurve& curve, std::size_t i) {
  const std::string colour = "radcert" + std::to_string(i % curve_colours.size());
  switch (curve.style) {
    case CurveStyle::thin: return colour + ",mark=none";
    case CurveStyle::bold: return "black,thick,mark=none";
    case CurveStyle::dots: return "black,only marks,mark=*";
    case CurveStyle::marked: break;
  }
  return colour + ",mark=" + std::string(marks[i % marks.size()]);
}

/// A point a line, so that lines stay short.
std::string points_of(const PlotCurve& curve) {
  std::string out = "coordinates {";
  for (const PlotPoint& at : curve.points) out += "\n  (" + shortest(at.x) + "," + shortest(at.y) + ")";
  return out + "}";
}

/// A dotted line from the lower edge to the upper one.
std::string mark_text(const PlotMark& mark) {
  const std::string x = shortest(mark.x);
  return "\\draw[dotted] ({axis cs:" + x + ",1}|-{rel axis cs:0,0}) -- ({axis cs:" + x +
         ",1}|-{rel axis cs:0,1})\n  node[pos=0.96,right,font=\\scriptsize] {" + latex_escaped(mark.name) +
         "};\n";
}

/// Its width is that of a line, with the names of both axes.
std::string picture(const Plot& plot) {
  const std::string axis = environment(plot);
  std::string out = "\\begin{tikzpicture}\n\\begin{" + axis + "}[title={" + latex_escaped(plot.title) +
                    "},title style={font=\\footnotesize,text width=0.8\\linewidth,align=center},\n" +
                    ticks(plot) + ends("x", plot.x.range) + ends("y", plot.y.range) + "  xlabel={" +
                    latex_name(plot.x.latex, plot.x.name) + "},ylabel={" +
                    latex_name(plot.y.latex, plot.y.name) +
                    "},log basis x=10,log basis y=10,width=0.88\\linewidth,height=0.62\\linewidth,\n"
                    "  clip=false,legend cell align=left,\n"
                    "  legend style={font=\\footnotesize,at={(0.5,-0.2)},anchor=north,draw=none" +
                    legend_columns(plot) + "}]\n";
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    const PlotCurve& curve = plot.curves[i];
    out += "\\addplot[" + look(curve, plot.number_of(i)) + "] " + points_of(curve) + ";\n\\addlegendentry{" +
           latex_name(curve.latex, curve.name) + "}\n";
  }
  for (const PlotMark& mark : plot.marks) out += mark_text(mark);
  for (const SlopeTriangle& triangle : slope_triangles(plot)) out += triangle_text(triangle);
  return out + "\\end{" + axis + "}\n\\end{tikzpicture}";
}

constexpr std::string_view needs = "% Needs \\usepackage{pgfplots}\\pgfplotsset{compat=1.18}.\n";

}  // namespace

std::string latex_plot_text(const Plot& plot) {
  return std::string(needs) + "\\begingroup\n" + defined_colours(plot) + picture(plot) + "\\endgroup\n";
}

std::string latex_plots_text(std::span<const Plot> plots) {
  std::string out(needs);
  for (const Plot& plot : plots)
    out +=
        "\\par\\medskip\\noindent\n\\begingroup\n" + defined_colours(plot) + picture(plot) + "\\endgroup\n";
  return out + "\\par\\medskip\n";
}

}  // namespace radcert
