// The wire of one mode in space: by how much its motion is enlarged, and where its points are on the screen.
//
// Next door: how it is drawn (`draw`), when it moves (`wire`).

/** Points of the wire and how far each moves, the farthest by 1; x y z each [m], the spring along z. */
export interface Moving {
  positions: Float32Array;
  windings: number;
  wireDiameter: number;
}

/** What holds for all moments. */
export interface Scene extends Moving {
  count: number;
  length: number;
  radius: number;
  /** How far the farthest point is drawn to move [m]. */
  amplitude: number;
}

/** From where it is looked at [rad]: about the upright and the level of the screen. */
export interface View {
  yaw: number;
  pitch: number;
}

/** The farthest point moves at most by so much of the length, windings come nearer by so much of their pitch and move within by so much of their radius. */
const MOST = { length: 0.1, pitch: 0.55, radius: 0.6 };

export function survey(moving: Moving): Scene {
  const { positions, windings } = moving;
  const count = positions.length / 6;
  const at = (point: number, axis: number) => positions[6 * point + axis] ?? 0;
  const length = at(count - 1, 2) - at(0, 2);
  const radius = Math.hypot(at(0, 0), at(0, 1));
  const turn = Math.max(1, Math.min(count - 1, Math.round((count - 1) / windings)));
  let [closer, within] = [0, 0];
  for (let point = 0; point + turn < count; point++) {
    closer = Math.max(closer, Math.abs(at(point + turn, 5) - at(point, 5)));
    const half = point + (turn >> 1);
    // What opposite points of a winding move against each other across the axis.
    const [x, y] = [at(half, 3) - at(point, 3), at(half, 4) - at(point, 4)];
    within = Math.max(within, Math.hypot(x, y) / 2);
  }
  const pitch = Math.abs(length) / windings;
  const amplitude = Math.min(
    MOST.length * Math.abs(length),
    (MOST.pitch * pitch) / (closer || 1e-9),
    (MOST.radius * radius) / (within || 1e-9),
  );
  return { ...moving, count, length, radius, amplitude };
}

/** Puts points on the screen: x to the right, y down, depth away from the viewer [m], from the middle of the spring. */
export function projector(
  { length }: Scene,
  { yaw, pitch }: View,
): (x: number, y: number, z: number) => [number, number, number] {
  const [sy, cy, sp, cp] = [Math.sin(yaw), Math.cos(yaw), Math.sin(pitch), Math.cos(pitch)];
  return (x, y, z) => {
    const along = z - length / 2;
    const depth = y * cy - along * sy;
    return [along * cy + y * sy, -(x * cp - depth * sp), depth * cp + x * sp];
  };
}
