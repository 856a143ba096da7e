# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages that are built: every link and anchor leads somewhere, every page has an example, nothing needs a network, nothing
tells of this machine, and the same program makes the same bytes."""
import hashlib
import html.parser
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import urllib.parse

BUILD = json.loads(os.environ["RADCERT_SITE_BUILD"])
SOURCE = pathlib.Path(os.environ["RADCERT_SOURCE"])
CHROMIUM = shutil.which("chromium")
# Pages about pages, which have nothing to show an example of; a listing of a source, which others lead to, is no page either.
WITHOUT_EXAMPLE = {"licences.html", "search.html"}
LISTINGS = "source/"
# Pages on which dollar signs are the marks of TeX.
WITH_FORMULAS = re.compile(r"index\.html|start/|theory/|tutorials/\d_")


class Page(html.parser.HTMLParser):
    """The links, anchors and examples of a page."""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.links, self.loaded, self.examples, self.twice = set(), [], [], 0, []
        self.text = text
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        given = dict(attrs)
        if "id" in given:
            if given["id"] in self.anchors:
                self.twice.append(given["id"])
            self.anchors.add(given["id"])
        if tag == "a":
            self.links.append(given.get("href") or "")
        for key in ("src", "data", "poster"):
            if given.get(key):
                self.loaded.append(given[key])
        if tag == "link":
            self.loaded.append(given["href"])
        if tag == "pre" and "example" in (given.get("class") or ""):
            self.examples += 1


def target(name, link):
    """The page and the anchor to which a link of a page leads."""
    path, _, anchor = link.partition("#")
    path = urllib.parse.unquote(path.split("?")[0])
    return os.path.normpath(os.path.join(os.path.dirname(name), path)) if path else name, urllib.parse.unquote(anchor)


def dead_links(folder, pages):
    """The links that lead nowhere, and how many lead somewhere."""
    dead, followed = [], 0
    for name, page in pages.items():
        for link in page.links + page.loaded:
            if re.match(r"(https?|mailto):", link):
                continue
            followed += 1
            to, anchor = target(name, link)
            if not (folder / to).is_file() or (anchor and anchor not in pages[to].anchors):
                dead.append(f"{name}: {link}")
    return dead, followed


def out_of_reach(pages):
    """The pages to which no way leads from the start."""
    seen, ahead = set(), ["index.html"]
    while ahead:
        name = ahead.pop()
        if name in seen:
            continue
        seen.add(name)
        ahead += [target(name, link)[0] for link in pages[name].links if not re.match(r"[a-z]+:", link)]
    return set(pages) - seen - {"search.html"}


def without_example(pages):
    return [name for name, page in pages.items()
            if not page.examples and name not in WITHOUT_EXAMPLE and not name.startswith(LISTINGS)]


def not_typeset(pages):
    """The pages that show TeX, or what KaTeX says of an error. Code may, and so may the TeX that a formula carries along."""
    found = []
    for name, page in pages.items():
        if not WITH_FORMULAS.match(name):
            continue
        text = re.sub(r"<pre.*?</pre>|<code.*?</code>|<annotation.*?</annotation>", "", page.text, flags=re.DOTALL)
        if re.search(r"katex-error|\\[a-zA-Z]{2,}|\$\$|\$[^$\s<][^$<]*\$", text):
            found.append(name)
    return found


def not_indexed(pages, identifiers):
    """The pages of which the search knows no section."""
    known = {identifier.partition("#")[0] for identifier in identifiers}
    return [name for name in pages if name not in known | WITHOUT_EXAMPLE and not name.startswith(LISTINGS)]


def missed_lines(layer, page):
    """The labelled lines of the headers of a layer that its page does not show, and how many lines there are."""
    missed, total = [], 0
    shown = re.sub(r"[\s`]+", "", html.unescape(re.sub(r"<[^>]*>", "", page.text)))
    for header in (SOURCE / "lib/radcert" / layer).rglob("*.h"):
        for line in re.findall(r"^/// (?:Maths|Source|Requires|Result|Limits) +(.*)$", header.read_text(encoding="utf-8"), re.MULTILINE):
            total += 1
            if re.sub(r"[\s`]+", "", line) not in shown:
                missed.append(f"{header.name}: {line}")
    return missed, total


def silent_names(page):
    """The public names of a layer's page of which nothing is said."""
    return [name for name, after in re.findall(r"<article><h3[^>]*><code>(.*?)</code>.*?</h3>\s*(<\w+)", page.text) if after != "<p"]


def digests(folder):
    return {str(file.relative_to(folder)): hashlib.sha256(file.read_bytes()).hexdigest()
            for file in folder.rglob("*") if file.is_file()}


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if (pathlib.Path(BUILD[1]).parent / "installed").read_text(encoding="utf-8") != "yes":
            raise unittest.SkipTest("npm could not install what the pages are made with")
        cls.temporary = pathlib.Path(tempfile.mkdtemp(prefix="radcert-site-test-"))
        cls.addClassCleanup(shutil.rmtree, cls.temporary)
        cls.folder = cls.temporary / "site"
        cls.build(cls.folder)
        cls.pages = {str(file.relative_to(cls.folder)): Page(file.read_text(encoding="utf-8"))
                     for file in sorted(cls.folder.rglob("*.html"))}

    @classmethod
    def build(cls, folder):
        done = subprocess.run([*BUILD, "--out", folder, "--quick"], capture_output=True, text=True, timeout=500, check=False)
        if done.returncode:
            raise AssertionError(done.stderr)

    def test_every_link_and_anchor_leads_somewhere(self):
        self.assertGreater(len(self.pages), 100)
        dead, followed = dead_links(self.folder, self.pages)
        self.assertEqual(dead, [])
        self.assertGreater(followed, 1000)

    def test_no_page_has_an_anchor_twice(self):
        self.assertEqual({name: page.twice for name, page in self.pages.items() if page.twice}, {})

    def test_every_page_can_be_reached_from_the_start(self):
        self.assertEqual(out_of_reach(self.pages), set())

    def test_no_page_without_an_example(self):
        self.assertGreater(len([name for name in self.pages if not name.startswith(LISTINGS)]), 90)
        self.assertEqual(without_example(self.pages), [])

    def test_every_formula_is_typeset(self):
        self.assertGreater(len([name for name in self.pages if WITH_FORMULAS.match(name)]), 13)
        self.assertEqual(not_typeset(self.pages), [])
        self.assertGreater(sum(page.text.count("class=\"katex\"") for page in self.pages.values()), 100)

    def test_the_search_knows_every_page(self):
        self.assertEqual(not_indexed(self.pages, self.identifiers()), [])

    def identifiers(self):
        """The pages and anchors in the index of the search."""
        text = (self.folder / "search_index.js").read_text(encoding="utf-8")
        return json.loads(text.removeprefix("window.radcertIndex = ").rstrip(";\n"))["documentIds"].values()

    def test_each_of_these_checks_sees_a_fault(self):
        layer, name = "kernel", "api/cpp/kernel.html"
        text, start = self.pages[name].text, self.pages["index.html"].text

        def with_page(name, text):
            return {**self.pages, name: Page(text)}

        for planted in ('<a href="nowhere.html">', '<a href="glossary.html#nowhere">', '<a href="#nowhere">', '<img src="files/nowhere.svg">'):
            self.assertEqual(len(dead_links(self.folder, with_page("index.html", start + planted))[0]), 1, planted)
        self.assertEqual(out_of_reach(with_page("lost.html", start)), {"lost.html"})
        self.assertEqual(without_example(with_page(name, text.replace('class="example', 'class="signature'))), [name])
        for planted in (r"\frac{1}{2}", "$x^2$", "$$x$$", '<span class="katex-error">'):
            self.assertEqual(not_typeset(with_page("index.html", start + planted)), ["index.html"], planted)
        for formula, code in ((r"\frac{1}{2}", 0), (r"\frac{1}", 1), (r"\nosuch{x}", 1), (r"x^{2", 1)):
            done = subprocess.run([BUILD[0], "--input-type=module", "-e", f"import {{ formula }} from {json.dumps(str(pathlib.Path(BUILD[1]).parent / 'src/markdown.mjs'))};"
                                   f"formula({json.dumps(formula)}, true);"], capture_output=True, check=False)
            self.assertEqual(done.returncode, code, formula)
        known = list(self.identifiers())
        self.assertEqual(not_indexed(self.pages, [each for each in known if not each.startswith(name + "#")]), [name])
        wordless = re.sub(r"(<article><h3[^>]*>.*?</h3>\s*)<p>.*?</p>", r"\1", text, count=1, flags=re.DOTALL)
        self.assertEqual((silent_names(Page(text)), len(silent_names(Page(wordless)))), ([], 1))
        lines, total = missed_lines(layer, self.pages[name])
        self.assertEqual((lines, total > 5), ([], True))
        self.assertEqual(len(missed_lines(layer, Page(""))[0]), total)

    def test_nothing_comes_from_a_network(self):
        for name, page in self.pages.items():
            for loaded in page.loaded:
                self.assertNotRegex(loaded, r"^([a-z]+:)?//", name)
        for file in [self.folder / "style.css", *self.folder.rglob("*.svg")]:
            text = file.read_text(encoding="utf-8")
            self.assertEqual(re.findall(r"url\((?!\"?data:|#)[^)]*\)|@import[^;]*;|href=\"https?:[^\"]*\"", text), [], file.name)
        script = (self.folder / "site.js").read_text(encoding="utf-8")
        self.assertEqual(re.findall(r"XMLHttpRequest|WebSocket|sendBeacon|https?://", script), [])
        client = (SOURCE / "apps/site/web/src/client.js").read_text(encoding="utf-8")
        self.assertEqual(re.findall(r"\bfetch\(|\bimport\(", client), [])

    def test_no_page_tells_of_this_machine(self):
        words = [str(SOURCE), str(self.temporary), os.path.expanduser("~"), os.uname().nodename, "radcert-site-"]
        for file in self.folder.rglob("*"):
            if file.suffix in (".html", ".js", ".css", ".svg"):
                text = file.read_text(encoding="utf-8")
                for word in words:
                    if len(word) > 4:
                        self.assertNotIn(word, text, file.name)

    def test_all_that_the_program_names_has_its_place(self):
        def program(*words):
            done = subprocess.run([os.environ["RADCERT"], *words, "--json", "-", "--quiet"], capture_output=True, check=True)
            return [entry["name"] for entry in json.loads(done.stdout)["entries"]]

        for name in program("list", "references"):
            if name != "sphere_over_disk":
                self.assertIn(name, self.pages["references.html"].anchors)
        for name in program("list", "surfaces"):
            self.assertIn(name, self.pages["surfaces.html"].anchors)
        for claim in program("list", "claims"):
            paper, label = claim.split("/")
            self.assertIn(label.split(".")[0], self.pages[f"papers/{paper}_statements.html"].anchors)
        for schema in (SOURCE / "lib/radcert/formats/schema").glob("*.json"):
            self.assertIn(f"schema/{schema.stem}.html", self.pages)

    def test_every_labelled_line_of_a_public_header_is_on_its_page(self):
        """A header's own lines, put together as they stand, against the page that shows them."""
        missed, total = [], 0
        for layer in sorted(path.name for path in (SOURCE / "lib/radcert").iterdir() if path.is_dir()):
            self.assertIn(f"api/cpp/{layer}.html", self.pages)
            lines, count = missed_lines(layer, self.pages[f"api/cpp/{layer}.html"])
            missed += lines
            total += count
        self.assertGreater(total, 2000)
        self.assertEqual(missed, [])

    def test_every_header_says_whether_it_is_stable_and_every_public_name_what_it_is(self):
        included = set(re.findall(r'^#include "radcert/(.+)"$', (SOURCE / "lib/radcert/all.h").read_text(encoding="utf-8"), re.MULTILINE))
        stable, silent, headers = set(), [], 0
        for layer in sorted(path.name for path in (SOURCE / "lib/radcert").iterdir() if path.is_dir()):
            page = self.pages[f"api/cpp/{layer}.html"].text
            marks = re.findall(r"<code>radcert/([^<]*)</code></a><a [^>]*>#</a></h2>\s*<p class=\"quiet\">(Stable|Internal)", page)
            headers += len(marks)
            stable |= {header for header, mark in marks if mark == "Stable"}
            self.assertEqual([mark for _, mark in marks], sorted((mark for _, mark in marks), reverse=True), layer)
            silent += [f"{layer}: {name}" for name in silent_names(self.pages[f"api/cpp/{layer}.html"])]
        self.assertGreater(headers, 200)
        self.assertEqual(stable, included)
        self.assertEqual(silent, [])

    def test_view_factor_and_form_factor_lead_to_configuration_factor(self):
        page = self.pages["glossary.html"].text
        for other in ("view factor", "form factor"):
            self.assertRegex(page, rf"{other}<a class=\"here\"[^>]*>#</a></h3>\s*<p>see <a href=\"#configuration-factor\">")
        if CHROMIUM is None:
            self.skipTest("no browser: the search was not tried")
        done = subprocess.run([CHROMIUM, "--headless", "--no-sandbox", f"--user-data-dir={self.temporary / 'browser'}", "--virtual-time-budget=5000",
                               "--dump-dom", f"file://{self.folder}/search.html?q=view+factor"],
                              capture_output=True, text=True, timeout=120, check=True)
        results = done.stdout.split('id="results"')[1]
        self.assertIn("glossary.html#view-factor", results.split("</li>")[0])
        self.assertIn("glossary.html#configuration-factor", results)

    def test_the_same_program_makes_the_same_bytes(self):
        again = self.temporary / "again"
        self.build(again)
        self.assertEqual(digests(again), digests(self.folder))


if __name__ == "__main__":
    unittest.main()
