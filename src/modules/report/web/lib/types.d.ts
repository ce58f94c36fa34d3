// The data that plots show, as src/modules/report/*Data.cpp writes it of RESULT.json and DIAGNOSIS.json.

/** Joint readings as they were reported, or moved within their noise. */
export type Layer = "reported" | "fitted";

/** A point that can be pointed at [px]. */
export interface Target {
  x: number;
  y: number;
  /** The text beside the pointer. */
  tip: () => string;
  click?: () => void;
  /** The picture that it belongs to. */
  picture?: any;
}

export type Draw = (context: CanvasRenderingContext2D, width: number, height: number) => Target[] | void;

/** A board in a picture: corners' u, v and errors du, dv in turn [px]. */
export interface BoardView {
  board: string;
  ids: number[];
  measured: number[];
  reported: number[];
  fitted: number[];
  weight?: number[];
}

/** What a capture is called; without a camera no picture was taken. */
export interface CaptureName {
  set: string;
  capture: number;
  pose: string;
  repeat?: number;
  camera: string;
  /** [s] */
  time: number;
}

/** A capture, with its joints' readings in the units that people read. */
export interface ReadCapture extends CaptureName {
  angles?: Record<string, number>;
  /** In the panel: its place in lists of drivers. */
  index?: number;
}

export interface Picture extends ReadCapture {
  width: number;
  height: number;
  boards: BoardView[];
  /** An address of the photograph. */
  photograph?: string;
  /** In the panel: whether there is a photograph. */
  kept?: boolean;
}

/** A corner where it was measured, and how far its prediction misses it [px]. */
export interface Corner {
  id: number;
  board: string;
  picture: Picture;
  u: number;
  v: number;
  du: number;
  dv: number;
  weight: number;
}

/** A tracker's reading or a contact, in the axes of the world: where it lies [m], and how far its prediction misses it [unit of its series]. */
export interface Reading {
  /** Its capture's place in the list of captures or pictures. */
  of: number;
  /** The marker or frame. */
  target: string;
  /** That was touched; empty for trackers. */
  place: string;
  at: [number, number, number];
  reported: [number, number, number];
  fitted: [number, number, number];
}

/** Readings of one instrument in one unit. */
export interface ReadingSeries {
  title: string;
  unit: string;
  /** Noise per axis, one standard deviation. */
  sigma: number;
  /** Whether the set says it; else it is estimated. */
  given: boolean;
  /** Errors are lengths. */
  isPlace: boolean;
  points: Reading[];
}

/** Errors of one kind of measurement in its own unit; `noise`: what readings alone would leave. */
export interface KindErrors {
  title: string;
  unit: string;
  noise: number | null;
  rungs: {name: string, rms: number | null, heldOut: number | null}[];
}

/** A found or needed size of an effect's unknown. */
export interface Size {
  name: string;
  unit: string;
  /** Whether the captures determine it. */
  told?: boolean;
  value: number | null;
  sigma: number | null;
  /** Smallest that would be noticed in 9 of 10 cases. */
  detectable: number | null;
}

/** An added-variable plot: points [pose, signature, residual], in standard errors of noise. */
export interface AddedVariable {
  of: string;
  unit: string;
  slope: number;
  sigma: number;
  like: string;
  points: [number | null, number, number][];
}

/** What an effect would do to the captures: corners [u, v, du, dv, left, down]. */
export interface Signature {
  found: boolean;
  sizes: {name: string, value: number, unit: string}[];
  before: number;
  after: number;
  imitator: string;
  pictures: SignaturePicture[];
}
export interface SignaturePicture {
  picture: number;
  before: number;
  after: number;
  corners: [number, number, number, number, number, number][];
}

export interface Candidate {
  label: string;
  state: string;
  /** The state whose words are shown. */
  shown: string;
  why: string;
  /** A suspected set-up: it has a reason and no numbers. */
  setUp: boolean;
  /** Unit of the held-out errors. */
  errorUnit: string;
  sizes: Size[];
  power: number | null;
  kept: number | null;
  evidence: number | null;
  pValue: number | null;
  predictedDrop: number | null;
  realDrop: number | null;
  before: number | null;
  after: number | null;
  step: number;
  plausible: boolean;
  equivalent: string[];
  added: AddedVariable | null;
  imprint: Signature | null;
}

/** A model on the ladder of errors, in the unit of the captures' errors; null: not known yet. */
export interface Rung {
  name: string;
  dropped?: string[];
  rms: number;
  heldOut: number | null;
  floor: number | null;
  alarm: number | null;
  /** The rung it was made from; without it the one before. */
  from?: number | null;
}

/** A step of a diagnosis. */
export interface Step {
  added: string;
  dropped: string[];
  rms: number;
  heldOut: number | null;
  floor: number;
  alarm: number;
}

/** A joint over a driver. */
export interface MapCell {
  joint: string;
  driver: string;
  evidence: number;
  pValue: number;
}

/** A joint's deflection over a driver: points [x, y, standard error]. */
export interface Curve {
  joint: string;
  driver: string;
  what: string;
  unit: string;
  valueUnit: string;
  title?: string;
  amplitude: number;
  evidence: number;
  expression: string;
  points: [number, number, number][];
  model: {define: any[]} | null;
}

export interface Aliases {
  candidates: string[];
  correlations: number[][];
  confusable: [string, string][];
  sentence: string;
}

/** Something recorded, with its value at each picture. */
export interface Driver {
  what: string;
  unit: string;
  joint: string;
  values: number[];
}

/** Poses and pictures of a diagnosis, by their places in the lists. */
export interface Taken {
  poses: {set: string, name: string, pictures: number[]}[];
  pictures: {capture: number, camera: string, pose: number}[];
}

/** What a model leaves over. */
export interface Left {
  /** Per joint [pictures, deflection, standard error] [unit]. */
  whatIf: {joint: string, unit: string, points: [number[], number, number][]}[];
  within: {
    noise: number;
    cells: {camera: string, u: number, v: number, du: number, dv: number, sigma: number, corners: number, worst: number}[];
    boards: {picture: number, board: string, distance: number, rms: number}[];
  };
  shapes: Shape[];
  readings: ReadingSeries[];
}

/** Partial residuals of a cause: `own` is its part, `left` what the model with it leaves; `own + left` is the misfit without it. */
export interface Cause {
  /** Of the effect. */
  label: string;
  /** The joint that is off; empty: displacements in the direction of the effect. */
  error: string;
  /** What drives it; empty: the effect's own displacement. */
  over: string;
  unit: string;
  overUnit: string;
  /** Root mean squares without and with the effect. */
  before: number;
  after: number;
  points: {pictures: number[], over: number, own: number, left: number, sigma: number}[];
}

/** A board's corners: places [m], and how far off they lie [mm]. */
export interface Shape {
  board: string;
  p: number;
  corners: {id: number, place: [number, number, number], off: [number, number, number], sigma: [number, number, number]}[];
}

export interface Diagnosis extends Taken {
  verdict: string;
  headline: string;
  sentence: string;
  /** Of the captures' errors. */
  unit: string;
  /** Empty where the ladder says it all. */
  kinds: KindErrors[];
  floorName: string;
  suggested: string[];
  /** What is suggested "may be" missing: poses come first. */
  tentative: boolean;
  /** Labels of captures that findings advise to leave out. */
  leaveOut: string[];
  /** Of the first finding: "stop", "act", "note"; "" in files of earlier versions. */
  level: string;
  own: boolean;
  findings: Finding[];
  facts: Fact[];
  steps: Step[];
  candidates: Candidate[];
  cameras: Record<string, {width: number, height: number}>;
  aliases: Aliases | null;
  map: MapCell[];
  curves: Curve[];
  /** Of what is suggested, or of the unnamed curve. */
  causes: Cause[];
  drivers: Driver[];
  left: {asGiven?: Left, withSuggested?: Left};
  next?: {poses: number, why: string};
}

export interface Fact {
  figure: string;
  sentence: string;
}

/** Estimates of one effect in one unit, with 95 % intervals. */
export interface EstimateGroup {
  title: string;
  unit: string;
  rows: {name: string, value: number, sigma: number, low: number, high: number, learned: number}[];
}

/** What a person should know, beyond the head's sentence. */
export interface Finding {
  level: "stop" | "act" | "note";
  sentence: string;
}

export interface Result {
  robot: string;
  verdict: string;
  headline: string;
  sentence: string;
  sets: string[];
  findings: Finding[];
  missing: string[];
  facts: Fact[];
  groups: EstimateGroup[];
  pictures: Picture[];
  readings: ReadingSeries[];
  /** The captures of the readings. */
  captures: ReadCapture[];
  /** Of joints that do not read in degrees. */
  jointUnits: Record<string, string>;
  pixelNoise: number;
}

/** What a page offers to the views of a diagnosis. */
export interface ViewTools {
  /** Shows a picture, by its place in the list. */
  open?: (picture: number) => void;
  /** What stands below a curve that an expression follows; without it a text to copy. */
  ownEffect?: (curve: Curve) => Node | null;
}

/** A view of a diagnosis. `show` is a pure function of the data: parts of a section, or null where there is nothing. */
export interface View {
  /** Views stand in the order of their places. */
  place: number;
  title: string;
  /** What it helps to judge: candidates, or what the model leaves over. */
  about: "candidates" | "misfit";
  show: (data: Diagnosis, tools: ViewTools) => (Node | null)[] | null;
  /** Of one candidate. */
  ofCandidate?: (candidate: Candidate, data: Diagnosis, tools: ViewTools) => (Node | null)[] | null;
}
