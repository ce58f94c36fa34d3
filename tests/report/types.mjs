// Proves that the scripts of report and panel fit together: TypeScript's checker reads their JSDoc types.
// It does not prove that the pages' data have the types that lib/types.d.ts gives them.
// Usage: node types.mjs WEB PANEL NODE_MODULES FOLDER; not run (77) without npm's packages
import {spawnSync} from "node:child_process";
import {existsSync, mkdirSync, writeFileSync} from "node:fs";
import {join} from "node:path";

const [, , web, panel, modules, folder] = process.argv, checker = join(modules, "typescript/bin/tsc");
if (!existsSync(checker)) {
  console.log("not run: the page's packages are not installed");
  process.exit(77);
}

// The panel's packages lie in the build folder, where its sources do not look for them.
mkdirSync(folder, {recursive: true});
const project = join(folder, "tsconfig.json"), of = name => [join(modules, name)];
writeFileSync(project, JSON.stringify({
  extends: join(panel, "tsconfig.json"),
  compilerOptions: {paths: {"naocal/*": [join(web, "*")], uplot: of("uplot"), svgcanvas: of("svgcanvas")}},
  include: [join(panel, "*.js"), join(panel, "*/*.js")],
}));
const statuses = [join(web, "tsconfig.json"), project].map(path => spawnSync(process.execPath, [checker, "-p", path, "--pretty", "false"], {stdio: "inherit"}).status);
process.exit(statuses.some(status => status !== 0) ? 1 : 0);
