// SPDX-License-Identifier: GPL-3.0-or-later
//
// node report_browser.mjs PAGE PICTURES TOOLS CHROMIUM
// Opens a report from disk in a browser and looks at it as a reader would. TOOLS is the folder whose node_modules has
// playwright-core. Screenshots go to PICTURES. Ends with 0 where all is well, else says what is not.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [file, pictures, tools, executablePath] = process.argv.slice(2);
const { chromium } = createRequire(path.join(tools, "package.json"))("playwright-core");
const address = pathToFileURL(file).href;

// A machine without a graphics card draws in software.
const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"] });
const complaints = [];

async function open(options = {}) {
  const context = await browser.newContext({ viewport: { width: 1200, height: 900 }, ...options });
  const page = await context.newPage();
  page.on("console", (message) => { if (message.type() === "error") complaints.push(`console: ${message.text()}`); });
  page.on("pageerror", (error) => complaints.push(`error: ${error.stack}`));
  page.on("request", (request) => { if (/^(https?|wss?):/.test(request.url())) complaints.push(`request: ${request.url()}`); });
  await page.goto(address);
  await page.waitForSelector("h1");
  return page;
}

const shot = (page, name) => page.screenshot({ path: path.join(pictures, `${name}.png`), fullPage: true });

/** What a function makes of the pixels of a canvas, an ImageData; it runs in the page. */
const ofPixels = (page, selector, seen) => page.evaluate(`(() => {
  const canvas = document.querySelector(${JSON.stringify(selector)});
  const flat = document.createElement("canvas");
  flat.width = canvas.width;
  flat.height = canvas.height;
  const ink = flat.getContext("2d");
  ink.drawImage(canvas, 0, 0);
  return (${seen})(ink.getImageData(0, 0, flat.width, flat.height));
})()`);

/** How many different colours a canvas shows. */
const colours = (page, selector) => ofPixels(page, selector, ({ data }) => {
  const seen = new Set();
  for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 0) seen.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
  return seen.size;
});

/** What part of the height of a canvas its picture takes: its opaque pixels. */
const drawnHeight = (page, selector) => ofPixels(page, selector, ({ data, width, height }) => {
  let [top, bottom] = [height, 0];
  for (let i = 3; i < data.length; i += 4) {
    if (data[i] < 250) continue;
    const row = Math.floor((i >> 2) / width);
    [top, bottom] = [Math.min(top, row), Math.max(bottom, row)];
  }
  return (bottom - top) / height;
});

try {
  const page = await open();
  await shot(page, "index");
  const count = () => page.locator(".statements tbody tr").count();
  const all = await count();
  assert.ok(all >= 5, `${all} statements in the index`);

  // Filters: the verdicts part the statements, a word finds its statement, and nothing is lost on the way back.
  let parted = 0;
  for (const button of await page.locator("button.filter").all()) {
    await button.click();
    const left = await count();
    assert.ok(left >= 1 && left <= all);
    parted += left;
    await button.click();
  }
  assert.ok(parted >= all, "every statement has a verdict to be found by");
  assert.equal(await count(), all);
  await page.keyboard.press("/");
  await page.keyboard.type("not compact");
  assert.equal(await count(), 1);
  await page.locator("#search").fill("no statement says this");
  assert.equal(await count(), 0);
  await page.locator("#search").fill("");

  // Every statement is reached from the index, and says what it is.
  const links = await page.locator(".statements tbody th a").evaluateAll((list) => list.map((link) => link.getAttribute("href")));
  assert.equal(new Set(links).size, all);
  for (const link of links) {
    await page.locator(`.statements a[href="${link}"]`).click();
    await page.waitForSelector("p.says");
    assert.notEqual(await page.locator("h1").textContent(), "There is no such statement in this report");
    assert.equal(await page.locator(".katex-error").count(), 0, link);
    const text = await page.locator("main").innerText();
    assert.doesNotMatch(text, /e\+00|± 0(?![.\d])/, link);
    assert.ok((await page.locator("code").allTextContents()).some((text) => text.startsWith("radcert verify ")), link);
    await page.locator(".home").click();
    await page.waitForSelector(".statements");
  }

  // A statement without cells, in the dark.
  await page.goto(`${address}#/ac98/equation_37`);
  await page.waitForSelector(".formula .katex");
  assert.ok(await page.locator("p.says sub").count() > 0, "P_n stands as it is typed");
  assert.match(await page.locator("p.says").innerText(), /α/);
  await shot(page, "statement");
  await page.locator("#theme").click();
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "dark");
  await shot(page, "statement_dark");
  await page.locator("#theme").click();

  // A table beside ours, its plot, and the surface in space.
  await page.goto(`${address}#/ac98/table_4`);
  await page.waitForSelector(".plot svg");
  assert.ok(await page.locator(".plot svg circle").count() > 4, "the plot is blank");
  // One problem has two levels: one curve, one colour, and a legend that says what is its own.
  for (const plot of await page.locator(".plot svg").all()) {
    const looks = await plot.locator("g[class^=c]").evaluateAll((list) => list.map((each) => each.getAttribute("class")));
    assert.deepEqual([...new Set(looks)].length, 1);
    assert.equal(await plot.locator("text", { hasText: "order" }).count(), 1);
    assert.ok((await plot.locator("text", { hasText: "order" }).textContent()).length < 40, "the legend is long");
  }
  const ink = () => page.locator(".plot svg text").first().evaluate((text) => getComputedStyle(text).fill);
  const inkOnWhite = await ink();
  await page.locator("#theme").click();
  assert.notEqual(await ink(), inkOnWhite, "the plot does not follow the page into the dark");
  await shot(page, "table_dark");
  await page.locator("#theme").click();
  assert.equal(await page.locator("mark").count() > 0, true, "no digit of Table 4 is marked: 1.04E-4 is misprinted");
  await shot(page, "table");
  await page.locator("a[href^='#/view/']").first().click();
  await page.waitForSelector(".space canvas");
  await page.waitForTimeout(500);
  assert.ok(await colours(page, ".space canvas") > 50, "the view in space is blank");
  assert.ok(await drawnHeight(page, ".space canvas") > 0.75, "the view in space is small");
  await shot(page, "space");
  const before = await page.locator(".space canvas").screenshot();
  await page.locator(".space canvas").focus();
  for (let i = 0; i < 5; ++i) await page.keyboard.press("ArrowLeft");
  await page.waitForTimeout(200);
  assert.notDeepEqual(await page.locator(".space canvas").screenshot(), before, "the arrow keys do not turn the view");
  await page.locator("input[name=colouring]").nth(1).check();
  await shot(page, "space_error");

  // The keyboard alone: the first stop is the link past the header.
  await page.goto(`${address}#/`);
  await page.reload();
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Skip to the content");

  const phone = await open({ viewport: { width: 390, height: 800 }, colorScheme: "dark" });
  assert.ok(await phone.evaluate(() => document.documentElement.scrollWidth <= innerWidth + 1), "a phone has to scroll sideways");
  await shot(phone, "phone");
  await phone.goto(`${address}#/ac98/table_4`);
  await phone.waitForSelector(".cards .chip");
  for (const chip of await phone.locator(".cards .chip").all()) {
    const box = await chip.boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= 390, "a verdict is beside the screen of a phone");
  }
  await shot(phone, "phone_table");
  const paper = await open();
  await paper.emulateMedia({ media: "print" });
  assert.equal(await paper.locator(".filters").first().isVisible(), false);

  assert.deepEqual(complaints, []);
} finally {
  await browser.close();
}
