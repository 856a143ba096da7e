// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/plot/latex_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "radcert/core/text.h"
#include "radcert/formats/table/latex_table.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {

namespace {

// Those of svg_text on paper; five marks and eight colours, so that forty curves differ.
constexpr std::array<std::string_view, 8> colours = {"0072B2", "D55E00", "008A64", "B8588F",
                                                     "3D9FD6", "B98000", "6A4FA3", "6B6B6B"};
constexpr std::array<std::string_view, 5> marks = {"*", "square*", "triangle*", "diamond*", "pentagon*"};

std::string defined_colours() {
  std::string out;
  for (std::size_t i = 0; i < colours.size(); ++i)
    out += "\\definecolor{radcert" + std::to_string(i) + "}{HTML}{" + std::string(colours[i]) + "}\n";
  return out;
}

/// Copies the table without what stands between quotes. \readline gives characters alone, whatever they are.
std::string copied_table(const std::string& file) {
  return R"tex(\ifdefined\radcertin\else\newread\radcertin\newwrite\radcertout\fi
\def\radcertstop{\radcertstop}%
\def\radcertplain#1"#2"#3\radcertend{#1\ifx\radcertstop#3\else\radcertplain#3\radcertend\fi}%
\endlinechar=-1
\immediate\openin\radcertin=\radcertdata )tex" +
         file + R"tex(
\immediate\openout\radcertout=\jobname-)tex" +
         file + R"tex(
\loop\unless\ifeof\radcertin
\readline\radcertin to\radcertline
\immediate\write\radcertout{\expandafter\radcertplain\radcertline""\radcertstop\radcertend}%
\repeat
\immediate\closein\radcertin
\immediate\closeout\radcertout
\endlinechar=13
\catcode35=12 \catcode37=12
)tex";
}

std::string place(double x, double y) { return "(axis cs:" + shortest(x) + "," + shortest(y) + ")"; }

std::string triangle_text(const SlopeTriangle& triangle) {
  const double along = std::sqrt(triangle.x[0] * triangle.x[1]);
  const double up = std::sqrt(triangle.y[0]) * std::sqrt(triangle.y[1]);
  const bool rises = triangle.y[0] < triangle.y[1];
  const double level = triangle.above == rises ? triangle.y[1] : triangle.y[0];
  const double side = triangle.above == rises ? triangle.x[0] : triangle.x[1];
  return "\\draw " + place(triangle.x[0], triangle.y[0]) + " -- " + place(triangle.x[1], triangle.y[1]) +
         " -- " + place(side, level) + " -- cycle;\n\\node[" + (triangle.above ? "above" : "below") +
         ",font=\\scriptsize] at " + place(along, level) + " {$1$};\n\\node[" +
         (triangle.above == rises ? "left" : "right") + ",font=\\scriptsize] at " + place(side, up) + " {$" +
         nearest_text(triangle.order, DecimalForm::fixed(2)) + "$};\n";
}

/// The ticks of the horizontal axis: those of the SVG, which are no odd powers of ten where there is less than a decade.
std::string ticks(const ConvergencePlot& plot) {
  double least = 0;
  double largest = 0;
  for (const ConvergenceCurve& curve : plot.curves)
    for (const PlotPoint& at : curve.points) {
      least = least == 0 ? at.x : std::min(least, at.x);
      largest = std::max(largest, at.x);
    }
  constexpr double least_length = 1.001;  // what axis_ticks takes, and more
  if (!(largest > least * least_length)) return {};
  std::string places;
  std::string names;
  for (const double tick : axis_ticks(least, largest, false)) {
    places += (places.empty() ? "" : ",") + shortest(tick);
    names += (names.empty() ? "$" : ",$") +
             (plot.axis == PlotAxis::unknowns ? std::to_string(std::llround(tick)) : shortest(tick)) + "$";
  }
  return "  xtick={" + places + "},xticklabels={" + names + "},xminorticks=false,\n";
}

/// Many short names stand side by side.
std::string legend_columns(const ConvergencePlot& plot) {
  constexpr std::size_t many = 6;
  constexpr std::size_t is_short = 20;  // characters, three times which with their marks fit a line
  const bool fit = std::all_of(plot.curves.begin(), plot.curves.end(),
                               [](const ConvergenceCurve& curve) { return curve.name.size() <= is_short; });
  return plot.curves.size() > many && fit ? ",legend columns=3" : "";
}

std::string picture(const ConvergencePlot& plot, const std::string& file) {
  std::string out = "\\begin{tikzpicture}\n\\begin{loglogaxis}[title={" + latex_escaped(plot.title) +
                    "},title style={font=\\footnotesize,text width=0.9\\linewidth,align=center},\n" +
                    ticks(plot) + "  xlabel={" +
                    (plot.axis == PlotAxis::mesh_size ? "mesh size $h$" : "unknowns $N$") +
                    "},ylabel={error},log basis x=10,log basis y=10,width=0.8\\linewidth,\n"
                    "  clip=false,legend cell align=left,\n"
                    "  legend style={font=\\footnotesize,at={(0.5,-0.18)},anchor=north,draw=none" +
                    legend_columns(plot) + "}]\n";
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    const ConvergenceCurve& curve = plot.curves[i];
    out += "\\addplot[radcert" + std::to_string(i % colours.size()) +
           ",mark=" + std::string(marks[i % marks.size()]) +
           "] table[col sep=comma,x=" + (plot.axis == PlotAxis::mesh_size ? "mesh_size" : "unknowns") +
           ",y=" + curve.column;
    if (curve.row) {
      const std::string number = std::to_string(*curve.row);
      out += ",restrict expr to domain={\\thisrow{" + plot.key + "}}{" + number + ":" + number + "}";
    }
    out += "]{\\jobname-" + file + "};\n\\addlegendentry{" +
           (curve.latex.empty() ? latex_escaped(curve.name) : curve.latex) + "}\n";
  }
  for (const SlopeTriangle& triangle : slope_triangles(plot)) out += triangle_text(triangle);
  return out + "\\end{loglogaxis}\n\\end{tikzpicture}\n";
}

}  // namespace

std::string latex_plots_text(std::span<const ConvergencePlot> plots, const std::string& file) {
  std::string out =
      "% Needs \\usepackage{pgfplots}\\pgfplotsset{compat=1.18}. Reads " + file +
      "; where that is not in the folder\n% of the document, say \\def\\radcertdata{path/} before.\n"
      "\\begingroup\n\\providecommand\\radcertdata{}%\n" +
      defined_colours() + copied_table(file);
  for (const ConvergencePlot& plot : plots) out += picture(plot, file) + "\\par\\medskip\n";
  return out + "\\endgroup\n";
}

}  // namespace radcert
