// Messages of the bridge about the open captures, and the state that views share.
import type {Diagnosis, EstimateGroup, Fact, Finding, Layer, Picture, ReadCapture, ReadingSeries} from "naocal/lib/types.js";

/** A user effect, as model files define it. */
export interface UserEffect {
  name: string;
  at: string;
  correction: string;
  unknowns: Record<string, {unit: string, sigma: number}>;
}

/** "set": the open captures, and what models of them can have. */
export interface SetMessage {
  names: string[];
  /** File of the opened result, or of the opened recording; or "". */
  result: string;
  robot: string;
  headId: string;
  bodyId: string;
  pictures: number;
  poses: number;
  corners: number;
  /** Of trackers, and contacts. */
  readings: number;
  /** Else next poses are listed as angles: the panel neither draws nor plays them. */
  isNao: boolean;
  joints: string[];
  own: UserEffect[];
  effects: {name: string, what: string, formula: string, own: boolean, unknowns: {name: string, unit: string, sigma: number}[]}[];
}

/** "ladder": all models so far; `at`: the present one; `from`: the one that each was made from. */
export interface LadderMessage {
  at: number;
  /** Of all errors. */
  unit: string;
  rungs: {step: string, from: number | null, with: string[], without: string[], rms: number, heldOut?: number, floor?: number, alarm?: number}[];
}

/** A quantity recorded with each picture. */
export interface RecordedDriver {
  name: string;
  what: string;
  unit: string;
  values: number[];
}

/** "fit": the present model's result. */
export interface FitMessage {
  usable: boolean;
  verdict: string;
  headline: string;
  sentence: string;
  findings: Finding[];
  facts: Fact[];
  groups: EstimateGroup[];
  pictures: (Picture & {index: number, kept: boolean})[];
  readings: ReadingSeries[];
  /** The captures of the readings. */
  captures: (ReadCapture & {index: number})[];
  drivers: RecordedDriver[];
  /** What a robot can take over: offsets [°], mounts [rad]; `untold`: joints whose offsets the captures do not determine. */
  compensation: {offsets: {joint: string, value: number}[], untold: string[], mounts: {camera: string, rotation: [number, number, number]}[]};
  with: string[];
  without: string[];
  labels: string[];
  /** Number of effects that are tested. */
  candidates: number;
}

/** "next": suggested poses. */
export interface NextMessage {
  /** `angles`: of motors, for display. */
  poses: {id: string, joints: Record<string, number>, supportFoot: string, observes: string[], secondsToReach?: number, angles: {joint: string, value: number, unit: string}[]}[];
  why: string;
  whyNone: string;
  /** How much stronger the evidence becomes with them. */
  whatTheyTell: string;
  /** What a person does to measure in them. */
  howToTake: string;
  /** Of a NAO: joint error that they are safe for [rad]. */
  assumptions: {jointError?: number};
}

interface Distances {
  rmsPx: number;
  medianPx: number;
  corners: number;
}

interface ReadingErrors {
  rms: number;
  mean: number;
  median: number;
  max: number;
  points: number;
}

/** "compared": prediction errors in other captures. */
export interface ComparedMessage {
  names: string[];
  /** Each kind of measurement in its own unit; `nominal`: with the drawing alone. */
  kinds: {title: string, unit: string, count: number, rms: number, median: number, nominal: number | null}[];
  /** By tracker and marker or frame [m]. */
  byMarker?: Record<string, Record<string, ReadingErrors>>;
  byBoard: Record<string, Distances>;
  byCamera: Record<string, Distances>;
  byPose: Record<string, Distances>;
}

/** A robot's key, as it lists it. */
export interface ListedKey {
  key: string;
  value?: any;
  isImage?: boolean;
  filename?: string;
}

export interface RobotEntry {
  connected: boolean;
  sentence: string;
  list: ListedKey[];
  mounts: ListedKey[];
  /** By mount; null: requested. */
  keys: Map<string, ListedKey[] | null>;
}

/** "start": what the start page offers. */
export interface StartMessage {
  /** With its version. */
  program: string;
  recent: {paths: string[], name: string, folder: string, what: string, opened: number}[];
  /** Why the list of recent files is not kept. */
  problem: string;
  /** Addresses of robots to look for. */
  robots: string[];
  search: {
    searching: boolean;
    searched: boolean;
    listed: {address: string, state: "asking" | "answers" | "silent", sentence: string}[];
    announced: {name: string, address: string}[];
    note: string;
  };
  sample: {state: "none" | "making" | "made" | "failed", sentence: string};
  robot: {state: "off" | "running" | "ending" | "failed", address: string, sentence: string};
  /** What may be dropped: endings of names (all, and those of a capture set's files), limits, and what is expected in words. */
  drop: {endings: string[], endingsOfSet: string[], endingOfTruth: string, mostFiles: number, mostBytes: number, expected: string};
}

/** A file to import: the name of a dropped one, or a path on this computer; and the dropped ones to choose from. */
export interface ImportSource {
  chosen: string;
  found: string[];
}

/** "import": a table or a URDF that was dropped; null: it was imported, or given up. */
export interface DroppedTable {
  files: Record<"table" | "robot" | "columns" | "cameraModel" | "boards" | "pictures", ImportSource>;
  cameraLink: string;
  boardLink: string;
  /** Folder for the set; empty: a temporary one. */
  output: string;
  links: string[];
  /** Null without a table; no meanings without a robot. `map`: the text of the column map. */
  columns: {
    list: {name: string, examples: string[]}[];
    meanings: {id: string, words: string, column: string, units: string[], unit: string}[];
    map: string;
  } | null;
  hasPictures: boolean;
  isReady: boolean;
  sentence: string;
  /** Why something was refused; may be empty. */
  problem: string;
  /** Dropped files that are nothing of this. */
  ignored: string[];
  /** The set is being written or opened. */
  busy: boolean;
}

/** A run as it is recorded: a calibration, or a result that was applied. */
export interface RecordedRun {
  id: string;
  /** "2026-02-14T10:05:00Z" */
  time: string;
  robot: {body: string, head: string, bodyId: string, headId: string};
  kind: string;
  by: string;
  /** What became of its numbers. */
  words: string;
  undone: string | null;
  /** [px] */
  errorBefore?: number;
  errorAfter?: number;
  heldOut?: boolean;
  captures?: string;
  result?: string;
  offsets?: Record<string, {offset: number, sigma: number}>;
}

/** A joint's offset over time [rad]. */
export interface JointOffsets {
  joint: string;
  sentence: string;
  offsets: {run: string, time: string, offset: number, sigma: number, compared: boolean,
    change?: {since: string, value: number, sigma: number, pValueOfAllJoints: number, jump: boolean, afterFall: boolean, words: string}}[];
}

export interface RobotRuns {
  body: string;
  name: string;
  sentence: string;
  runs: RecordedRun[];
  falls: string[];
  joints: JointOffsets[];
}

/** "history": the runs of all robots. */
export interface HistoryMessage {
  rule: string;
  folder: string;
  broken: string[];
  robots: RobotRuns[];
}

/** "missing": captures that were not found; `paths` or `run` is what was to be opened. */
export interface MissingMessage {
  sentence: string;
  paths?: string[];
  run?: string;
}

/** Messages are null until the bridge has sent them; the panel shows a view of the captures only with set, ladder and fit. */
export interface PanelState {
  analysis: boolean;
  set: SetMessage;
  ladder: LadderMessage;
  fit: FitMessage;
  /** Null while it is searched for. */
  diagnosis: Diagnosis | null;
  /** Why there is none. */
  unsearched: {sentence: string} | null;
  /** Answers for the previous model. */
  earlier: Diagnosis | null;
  /** Why there is no fit. */
  unfitted: {sentence: string} | null;
  next: NextMessage | null;
  compared: ComparedMessage | null;
  start: StartMessage | null;
  history: HistoryMessage | null;
  missing: MissingMessage | null;
  /** The bridge's present task. */
  work: string | null;
  robots: Map<string, RobotEntry>;
  layer: Layer;
  /** The picture that was clicked on. */
  chosen: Picture | null;
}
