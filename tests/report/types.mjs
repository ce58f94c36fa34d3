// Type-checks the scripts of report and panel with TypeScript, by their JSDoc types.
// Does not prove that the pages' data have the types declared in lib/types.d.ts.
// Usage: node types.mjs WEB PANEL NODE_MODULES FOLDER; skipped (77) without npm's packages
import {spawnSync} from "node:child_process";
import {existsSync, mkdirSync, writeFileSync} from "node:fs";
import {join} from "node:path";

const [, , web, panel, modules, folder] = process.argv, checker = join(modules, "typescript/bin/tsc");
if (!existsSync(checker)) {
  console.log("not run: the page's packages are not installed");
  process.exit(77);
}

// Paths to the panel's packages, which are in the build folder.
mkdirSync(folder, {recursive: true});
const project = join(folder, "tsconfig.json"), of = name => [join(modules, name)];
writeFileSync(project, JSON.stringify({
  extends: join(panel, "tsconfig.json"),
  compilerOptions: {paths: {"naocal/*": [join(web, "*")], uplot: of("uplot"), svgcanvas: of("svgcanvas")}},
  include: [join(panel, "*.js"), join(panel, "*/*.js")],
}));
const statuses = [join(web, "tsconfig.json"), project].map(path => spawnSync(process.execPath, [checker, "-p", path, "--pretty", "false"], {stdio: "inherit"}).status);
process.exit(statuses.some(status => status !== 0) ? 1 : 0);
