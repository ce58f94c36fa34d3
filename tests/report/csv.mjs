// Proves that a table saved as CSV holds numbers as they are and no formula: names come from files of others.
import assert from "node:assert/strict";
import {csv} from "../../src/modules/report/web/lib/dom.js";

for (const formula of ["=HYPERLINK(0)", "@SUM(A1)", "+1+cmd|' /C calc'!A0", "-A1", " =1", "\t=1", "\r=1", "\n@x"]) {
  const [cell] = csv([[formula]]).replace(/^"/, "");
  assert.equal(cell, "'", formula);
}
for (const plain of ["", "KneePitch", "-0.25", "+3e-4", "-0.25 ± 0.01", "-1.5°", "-2 mm", "a=b"]) {
  assert.equal(csv([[plain]]), plain + "\n");
}
assert.equal(csv([[-1.5, null, undefined, 2]]), "-1.5,,,2\n");
assert.equal(csv([["a\rb", 'say "x"', "a,b"]]), '"a\rb","say ""x""","a,b"\n');
