// Registry of diagnosis views, shared by report and panel: a new view is a file in this folder and a line here
// (docs/adding-a-view.md). Views are sorted by `place`.
export {view as addedVariable} from "naocal/plots/added-variable.js";
export {view as aliasMatrix} from "naocal/plots/alias-matrix.js";
export {view as effectSignature} from "naocal/plots/effect-signature.js";
export {view as driverMap} from "naocal/plots/driver-map.js";
export {view as driverCurve} from "naocal/plots/driver-curve.js";
export {view as jointCorrection} from "naocal/plots/joint-correction.js";
export {view as residualField} from "naocal/plots/residual-field.js";
export {view as boardShape} from "naocal/plots/board-shape.js";
