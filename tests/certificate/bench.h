// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "radcert/certificate/ball_transport.h"
#include "radcert/certificate/densities.h"
#include "radcert/certificate/line_bounds.h"
#include "radcert/certificate/occlusion/shade.h"
#include "radcert/certificate/occlusion/sight.h"
#include "radcert/certificate/polyhedron_certificate.h"
#include "radcert/certificate/scene.h"

namespace radcert::certificate::test {

/// A certificate and what its check is made of.
struct Bench {
  explicit Bench(PolyhedronCertificate given)
      : c(std::move(given)),
        scene(c),
        densities(c),
        lines(c, scene, densities),
        transport(c, scene, densities, lines),
        sight(c, scene),
        shades(c, densities) {}
  PolyhedronCertificate c;
  Scene scene;
  Densities densities;
  LineBounds lines;
  BallTransport transport;
  Sight sight;
  Shades shades;
};

}  // namespace radcert::certificate::test
