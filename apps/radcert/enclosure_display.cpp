// SPDX-License-Identifier: GPL-3.0-or-later
#include "enclosure_display.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "radcert/scalar/enclosing_text.h"

namespace radcert::app {

namespace {

double seconds_since(std::chrono::steady_clock::time_point from) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

}  // namespace

EnclosureDisplay::EnclosureDisplay(bool quiet) : display_(quiet) { display_.at(0, "the first mesh"); }

void EnclosureDisplay::mesh_done(const GuaranteeProgress& now) {
  const std::scoped_lock lock(mutex_);
  const std::string layers = now.layers > 0 ? "layers " + std::to_string(now.layers) + ", " : "";
  display_.note(layers + "degree " + std::to_string(now.degree) + ": " + std::to_string(now.unknowns) +
                " unknowns, " + std::to_string(now.samples) + " points; width " + upper_text(now.width) +
                " after " + nearest_text(seconds_since(start_), DecimalForm::fixed(0)) + " s");
  display_.at(0, "what comes after degree " + std::to_string(now.degree));
}

void EnclosureDisplay::at(const MeshProgress& now) {
  const std::scoped_lock lock(mutex_);
  const std::string layers = std::to_string(now.layers) + " layers: ";
  if (now.cells == 0) {
    layers_ = -1;
    display_.at(0, now.planned == 0 ? layers + "functions of degree " + std::to_string(now.degree)
                                    : layers + "cells planned on " + std::to_string(now.planned) + "/" +
                                          std::to_string(now.elements) + " elements");
    return;
  }
  // Cells are told by several threads: the last to speak need not have done the most.
  if (layers_ != now.layers) {
    layers_ = now.layers;
    cells_begin_ = Clock::now();
    cells_before_ = now.cells_done;
  }
  const auto all = static_cast<double>(now.cells);
  const auto done = static_cast<double>(now.cells_done);
  const double measured = done - static_cast<double>(cells_before_);
  const double left = measured > 0 ? seconds_since(cells_begin_) * (all - done) / measured : 0;
  const std::string width = std::isfinite(now.width) ? ", width " + upper_text(now.width) : "";
  display_.at(std::min(1.0, done / all),
              layers + std::to_string(now.cells_done) + "/" + std::to_string(now.cells) + " cells" + width,
              left);
}

}  // namespace radcert::app
