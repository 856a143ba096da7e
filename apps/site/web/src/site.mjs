// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the site holds and in which order. A page is Markdown of the repository (`from`), or made by the build (`made`).
// `tries` are commands that a page shows with what they print; `run: false` where that takes long or tells of a time.

const example = (number, title) => ({ name: `tutorials/${number}.html`, from: `apps/examples/${number}/README.md`, short: title });

export const groups = [
  { title: "Start", pages: [
    { name: "index.html", from: "apps/site/pages/index.md", short: "Start", isPlain: true },
    { name: "start/analyst.html", from: "apps/site/pages/analyst.md", short: "For the analyst" },
    { name: "start/thermal_engineer.html", from: "apps/site/pages/thermal_engineer.md", short: "For the thermal engineer" },
    { name: "start/developer.html", from: "apps/site/pages/developer.md", short: "For the developer" },
    { name: "readme.html", from: "README.md", short: "The readme" },
  ] },
  { title: "Theory", pages: [
    { name: "theory/equation.html", from: "apps/site/pages/theory/1_equation.md", short: "The equation" },
    { name: "theory/method.html", from: "apps/site/pages/theory/2_method.md", short: "The method" },
    { name: "theory/orders.html", from: "apps/site/pages/theory/3_orders.md", short: "Orders of convergence" },
    { name: "theory/errors.html", from: "apps/site/pages/theory/4_errors.md", short: "Every error and its radius" },
    { name: "theory/proof.html", from: "apps/site/pages/theory/5_proof.md", short: "What “proved” rests on" },
    { name: "theory/notation.html", from: "papers/notation.md", short: "Notation", tries: [{ command: "radcert basis inset --degree 1 --alpha 1/6", run: false }] },
  ] },
  { title: "Tutorials", pages: [
    { name: "tutorials/index.html", from: "apps/examples/README.md", short: "All tutorials",
      tries: [{ command: "radcert example lamp_in_a_box" }] },
    { made: "notebooks" },
    example("01_solve", "Solve on a surface"),
    example("02_reference_value", "A reference value"),
    example("03_own_surface", "Your own surface"),
    example("04_own_basis", "Your own basis"),
    example("05_own_claim", "Your own claim"),
    example("06_meshless", "Meshless"),
    example("07_occluded_room", "An occluded room"),
    example("08_factors_of_an_stl", "Factors of an STL"),
    example("09_other_languages", "Other languages"),
    example("10_edges", "Edges"),
    example("11_anywhere", "Anywhere on the surface"),
    example("12_events", "Visibility events"),
    example("13_galerkin", "Galerkin's method"),
    example("14_new_nodes", "New nodes"),
    example("15_scoreboard", "The scoreboard"),
    { name: "gallery.html", made: "gallery", title: "Gallery" },
    { name: "tutorials/pictures.html", from: "apps/examples/pictures/README.md", short: "About the pictures" },
  ] },
  { title: "Look up", pages: [
    { name: "references.html", made: "references", title: "Reference values" },
    { name: "commands.html", from: "apps/radcert/README.md", short: "The command line" },
    { name: "help.html", made: "help", title: "Help texts of the commands" },
    { name: "formats.html", from: "lib/radcert/formats/README.md", short: "The file formats" },
    { name: "schema/index.html", made: "schemaIndex", title: "File types by their schemas" },
    { made: "schemas" },
    { name: "surfaces.html", made: "surfaces", title: "Surfaces of the catalogue" },
    { name: "ranks.html", from: "apps/ranks/README.md", short: "Beyond one machine" },
    { name: "limits.html", from: "lib/limits.md", short: "Limits of work", tries: [{ command: "radcert reference cube_opposite_faces --digits 1000 --quiet" }] },
    { name: "speed.html", from: "apps/bench/README.md", short: "Running times" },
    { name: "glossary.html", made: "glossary", title: "Glossary" },
  ] },
  { title: "Python", pages: [
    { name: "python.html", from: "apps/python/README.md", short: "radcert from Python" },
    { name: "api/python.html", made: "python", title: "The module radcert" },
  ] },
  { title: "C", pages: [
    { name: "c.html", from: "apps/c/README.md", short: "radcert from C" },
  ] },
  { title: "C++", pages: [
    { name: "library.html", from: "lib/README.md", short: "The library, and what is stable" },
    { made: "layers" },
    { name: "api/instantiations.html", from: "lib/instantiations.md", short: "Formulas and arithmetics",
      tries: [{ command: "python3 tests/structure/instantiations.py .", run: false }] }] },
  { title: "Papers", pages: [
    { name: "papers/verification.html", from: "verification/README.md", short: "Verdicts and numbers" },
    { made: "papers" },
  ] },
  { title: "Project", pages: [
    { name: "contributing.html", from: "CONTRIBUTING.md", short: "Contributing" },
    { name: "project/site.html", from: "apps/site/README.md", short: "About these pages" },
    { name: "project/certificates.html", from: "lib/radcert/reference/certificates/README.md", short: "Certificates of references" },
    { name: "project/mutation.html", from: "tests/mutation/README.md", short: "Faults planted" },
    { name: "project/robust.html", from: "tests/robust/README.md", short: "What was tried to break it",
      tries: [{ command: "python3 tests/robust/kills.py build/release/bin/radcert", run: false }] },
    { name: "project/fuzz.html", from: "tests/fuzz/README.md", short: "Readers under attack",
      tries: [{ command: "ctest --test-dir build/release -R fuzz", run: false }] },
    { name: "changes.html", from: "CHANGELOG.md", short: "Changes", tries: [{ command: "radcert --version" }] },
  ] },
];

/** What a schema's page shows of such a file. */
export const schemaExamples = {
  basis: { command: "radcert basis inset --degree 1 --alpha 1/6 --json - --quiet" },
  certificate: { command: "radcert solve room.json --guarantee 0.1 --certificate room.certificate.json", run: false },
  check: { command: "radcert check room.certificate.json --json -", run: false },
  experiment: { command: "radcert example experiment" },
  experiment_result: { command: "radcert experiment apps/examples/experiments/inset_alpha_sweep.json --json -", run: false },
  factors: { command: "radcert factors cube --json - --quiet" },
  list: { command: "radcert list solvers --json -" },
  manifest: { command: "radcert reference --all --out values", run: false },
  nodes: { command: "cat apps/examples/nodes/symmetric_1.json" },
  picture: { command: "radcert picture figure_6 --out figure_6.svg --json -" },
  problem: { command: "radcert example problem" },
  provenance: { command: "radcert solve apps/examples/01_solve/1_two_piece.json --out results", run: false },
  reference: { command: "radcert reference cube_opposite_faces --json -" },
  references: { command: "radcert reference --all --json -", run: false },
  scoreboard: { command: "radcert experiment scoreboard --json -", run: false },
  solution: { command: "radcert solve apps/examples/01_solve/1_two_piece.json --json -", run: false },
  surface: { command: "radcert surface apps/examples/07_occluded_room/room.obj --json -" },
  verification: { command: "radcert verify ac98/table_1.alpha_1_6.n4 --json -", run: false },
};

/** Words for which readers look, and where they find what they mean. */
export const alsoKnownAs = {
  "configuration factor": ["view factor", "form factor", "shape factor", "angle factor"],
  "closure, row sum": ["summation rule", "enclosure rule"],
  "guaranteed, proved": ["rigorous", "validated numerics", "verified computing"],
  "inset, alpha": ["offset of the nodes"],
  "ball": ["interval", "enclosure of a number"],
  "collocation point, node": ["evaluation point"],
  "superconvergence": ["supraconvergence"],
  "mother function": ["radial basis function", "RBF"],
};

/** The gallery: each picture with the command that makes it. Slow are those that take more than three seconds. */
export const pictures = [
  { name: "room.png", title: "A room by a meshless basis", command: "radcert picture figure_8_lehtinen --size 640x480 --samples 3 --out room.png",
    says: "All of the light of a lamp under a shade, by Lehtinen's basis on scattered sites (figure 8 of [psg10](papers/psg10/README.md))." },
  { name: "superconvergence/node_error_against_h.svg", title: "Superconvergence", isSlow: true,
    command: "radcert experiment apps/examples/pictures/superconvergence.json --out superconvergence",
    says: "Errors at the nodes of an ellipsoid against the mesh size: what [ac98](papers/ac98/README.md) is about. The first notebook tells why." },
  { name: "alpha/node_error_against_alpha.svg", title: "Which inset is best?", isSlow: true,
    command: "radcert experiment apps/examples/experiments/inset_alpha_sweep.json --out alpha",
    says: "The error at the nodes against the place of the nodes. It dips near 1/6, where the rule gains a degree of precision." },
  { name: "bases/node_error_against_unknowns.svg", title: "Bases of one's own at equal cost",
    command: "radcert experiment apps/examples/04_own_basis/experiment.json --out bases",
    says: "Five bases against the number of unknowns, three of them from [files of nodes](apps/examples/04_own_basis/README.md)." },
  { name: "figure_3.svg", title: "Sites on a scene", command: "radcert picture figure_3 --out figure_3.svg",
    says: "A room and a thousand sites about which meshless elements are centred." },
  { name: "figure_5.svg", title: "Two distances of sites", command: "radcert picture figure_5 --out figure_5.svg",
    says: "How far a site is, through the air and along the surface, as 1/(1 + d)." },
  { name: "figure_6.svg", title: "Three mother functions", command: "radcert picture figure_6 --out figure_6.svg",
    says: "Elements of the three meshless bases on a line, and what interpolates four values." },
  { name: "figure_7.svg", title: "A column of a transfer matrix", command: "radcert picture figure_7 --out figure_7.svg",
    says: "What a point light at one site does at all others." },
  { name: "figure_9.svg", title: "A sphere over a disk", command: "radcert picture figure_9 --out figure_9.svg",
    says: "The scene whose solution psg10 knows in closed form, and its sites." },
];
