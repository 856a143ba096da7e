// SPDX-License-Identifier: GPL-3.0-or-later
import "./style.css";
import { claimView } from "./claim_view.js";
import { experiment, licences, paper, pictures, report, spoken, statement } from "./data.js";
import { element } from "./dom.js";
import { errataView } from "./errata_view.js";
import { experimentView } from "./experiment_view.js";
import { indexView } from "./index_view.js";
import { surfaceView } from "./surface_view.js";

const content = document.getElementById("content");
const trail = document.getElementById("trail");

/** What a place in the page's address stands for: its title and its parts. */
function page(route) {
  if (experiment) return { title: experiment.name, parts: experimentView };
  if (route === "") return { title: "All statements", parts: indexView };
  const [first, ...rest] = route.split("/");
  if (first === "view" && pictures[Number(rest[0])]) return { title: report.problems[Number(rest[0])].name, parts: () => surfaceView(Number(rest[0])) };
  if (rest[0] === "errata" && paper(first).errata) return { title: `Errata of ${first}`, parts: () => errataView(first) };
  const entry = statement(route);
  if (entry) return { title: `${first}: ${spoken(entry.label)}`, parts: () => claimView(entry) };
  return { title: "Not here", parts: () => [element("h1", {}, "There is no such statement in this report"), element("p", {}, element("a", { href: "#/" }, "All statements"))] };
}

let scrolled = 0;
let last = null;
function show() {
  const route = decodeURIComponent(location.hash.replace(/^#\/?/, ""));
  if (route === "content") return;
  if (last === "") scrolled = scrollY;
  const { title, parts } = page(route);
  document.title = `${title} · radcert report`;
  trail.replaceChildren(...(route === "" ? [] : [element("a", { href: "#/" }, "All statements"), element("span", { "aria-current": "page" }, title)]));
  content.replaceChildren(...parts().flat().filter(Boolean));
  // A reader who listens hears where the link has led; the first page is read from its top.
  if (last !== null) content.focus({ preventScroll: true });
  scrollTo(0, route === "" ? scrolled : 0);
  last = route;
}

function themeButton() {
  const button = document.getElementById("theme");
  const wanted = matchMedia("(prefers-color-scheme: dark)");
  const apply = (dark) => {
    document.documentElement.dataset.theme = dark ? "dark" : "light";
    button.setAttribute("aria-pressed", String(dark));
  };
  apply(wanted.matches);
  wanted.addEventListener("change", () => apply(wanted.matches));
  button.addEventListener("click", () => apply(document.documentElement.dataset.theme !== "dark"));
}

function footer() {
  document.getElementById("footer").append(
    element("details", {}, element("summary", {}, "Libraries in this page and their licences"),
      licences.map((library) => element("details", {}, element("summary", {}, `${library.name} ${library.version}, ${library.licence}`),
        element("pre", {}, library.text)))));
}

addEventListener("hashchange", show);
addEventListener("keydown", (event) => {
  if (event.key !== "/" || event.target.matches("input, select, textarea")) return;
  const search = document.getElementById("search");
  if (!search) return;
  event.preventDefault();
  search.focus();
});
themeButton();
footer();
show();
