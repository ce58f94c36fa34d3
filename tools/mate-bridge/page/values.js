// What a robot last told under each key, and what the bridge worked out of it.
const known = new Map(); // by robot

export const of = robot => {
  if (!known.has(robot)) known.set(robot, {values: new Map(), scene: null, before: null, pictures: {series: 0, places: []}});
  return known.get(robot);
};
export const valueOf = (robot, key) => of(robot).values.get(key) ?? null;
