// Proves that each of the page's packages runs on Node.js 18, which Debian 12 has, so that the browser tests run there.
// Usage: node packages.mjs PACKAGE-LOCK
import {readFileSync} from "node:fs";

const debians = 18;
const {packages} = JSON.parse(readFileSync(process.argv[2], "utf8"));
const needed = Object.entries(packages).filter(([name]) => name).map(([name, {engines}]) => ({name, least: Number(engines?.node?.match(/>=\s*(\d+)/)?.[1] ?? 0)}));
const tooNew = needed.filter(({least}) => least > debians);
for (const {name, least} of tooNew) console.log(`FAILED: ${name} needs Node.js ${least}; take a version that runs on ${debians}`);
console.log(`${needed.length} packages looked at`);
process.exit(tooNew.length || needed.length < 5 ? 1 : 0);
