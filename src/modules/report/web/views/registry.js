// Registry of diagnosis views, shared by report and panel: a new view is a file in this folder and a line here
// (docs/adding-a-view.md). Views are sorted by `place`.
export {view as addedVariable} from "naocal/views/added-variable.js";
export {view as aliasMatrix} from "naocal/views/alias-matrix.js";
export {view as effectSignature} from "naocal/views/effect-signature.js";
export {view as kindErrors} from "naocal/views/kind-errors.js";
export {view as readings} from "naocal/views/readings.js";
export {view as driverMap} from "naocal/views/driver-map.js";
export {view as driverCurve} from "naocal/views/driver-curve.js";
export {view as jointCorrection} from "naocal/views/joint-correction.js";
export {view as residualField} from "naocal/views/residual-field.js";
export {view as boardShape} from "naocal/views/board-shape.js";
