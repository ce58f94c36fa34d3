// The registered views in display order.
import * as registry from "naocal/views/registry.js";

/** @import {View} from "naocal/lib/types.js" */

/** @type {View[]} */
export const views = Object.values(registry).sort((a, b) => a.place - b.place);
