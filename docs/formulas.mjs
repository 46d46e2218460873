// Renders every $$ block of the chapters with KaTeX, and fails at the first that KaTeX does not understand.
//
//   npm install --prefix DIR katex
//   node docs/formulas.mjs DIR/node_modules/katex [OUT.html]
//
// With OUT.html the formulas are written as a page to look at. Not a part of the tests, which need no network.
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const [folder, page] = process.argv.slice(2);
if (!folder) {
  console.error("usage: node docs/formulas.mjs DIR/node_modules/katex [OUT.html]");
  process.exit(2);
}
const { default: katex } = await import(pathToFileURL(join(resolve(folder), "dist", "katex.mjs")));
const docs = dirname(fileURLToPath(import.meta.url));
let html = "";
let count = 0;
for (const name of readdirSync(docs).filter((name) => name.endsWith(".md")).sort()) {
  const text = readFileSync(join(docs, name), "utf8");
  for (const [, formula] of text.matchAll(/^\$\$\n([^]*?)\n\$\$$/gm)) {
    try {
      html += `<p>${katex.renderToString(formula, { displayMode: true, throwOnError: true, strict: "error" })}</p>\n`;
    } catch (error) {
      console.error(`docs/${name}: ${formula}\n${error.message}`);
      process.exit(1);
    }
    count += 1;
  }
}
if (page) {
  const style = pathToFileURL(join(resolve(folder), "dist", "katex.min.css"));
  writeFileSync(page, `<!doctype html><meta charset="utf-8"><link rel="stylesheet" href="${style}">\n${html}`);
}
console.log(`KaTeX ${katex.version}: ${count} formulas`);
