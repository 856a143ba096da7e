// SPDX-License-Identifier: GPL-3.0-or-later

/** How the pages are searched; the build writes the index and the browser reads it, by the same rules. */
export const indexing = {
  fields: ["title", "page", "text"],
  storeFields: ["title", "page", "start"],
  searchOptions: {
    boost: { title: 4, page: 2 },
    prefix: (term) => term.length > 2,
    fuzzy: (term) => (term.length > 5 ? 0.15 : false),
    combineWith: "AND",
    boostDocument: (id) => (id.startsWith("glossary") ? 3 : id.startsWith("api/cpp") || id.startsWith("source") ? 0.5 : 1),
  },
};
