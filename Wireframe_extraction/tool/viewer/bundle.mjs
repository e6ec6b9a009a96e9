// Puts the scripts of the page and what they need of three.js into one file.
// usage: node bundle.mjs NODE_MODULES OUT.js

import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const [modules, output] = process.argv.slice(2).map(name => resolve(name));
const { buildSync } = createRequire(join(modules, "any.js"))("esbuild");
buildSync({
  entryPoints: [join(dirname(fileURLToPath(import.meta.url)), "main.js")],
  nodePaths: [modules], // they are not beside the sources
  outfile: output,
  bundle: true,
  minify: true,
  format: "iife",
  legalComments: "eof",
  logLevel: "warning"
});
