// What is flown for the measurements, by coptersim_stream: copters on a grid, 3 m apart; each second one of them gets a
// command, which is an event.

import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('../..', import.meta.url));
export const streamProgram = join(root, '_build/native/bin/coptersim_stream');

const spacing = 3; // m

function scenario(copters: number, seconds: number) {
  const side = Math.ceil(Math.sqrt(copters));
  const ids = Array.from({ length: copters }, (_, i) => i + 1);
  const every = Array.from({ length: Math.ceil(seconds) }, (_, i) => i);
  return {
    format: 'coptersim-scenario/1',
    dt_us: 8333, // two steps a frame of 60 Hz
    duration_us: seconds * 1_000_000,
    altitude: 1,
    halt_on_collision: false,
    world: {
      lines: [{ id: 1, p1: [-5, -5], p2: [side * spacing + 5, -5] }],
      anchors: [
        { id: 1, pos: [-4, -4, 2] },
        { id: 2, pos: [side * spacing, -4, 2] },
        { id: 3, pos: [-4, side * spacing, 2] },
        { id: 4, pos: [side * spacing, side * spacing, 2] },
      ],
    },
    copters: ids.map((id) => ({
      id,
      pos: [((id - 1) % side) * spacing, Math.floor((id - 1) / side) * spacing],
      yaw: 0,
    })),
    events: every.map((second) => ({
      t_us: second * 1_000_000,
      type: 'command',
      copter: 1 + (second % copters),
      roll: 0,
      pitch: 0,
      yaw: 0,
    })),
  };
}

// The file of a scenario in `folder`.
export function writeScenario(folder: string, copters: number, seconds: number): string {
  const file = join(folder, `grid_${copters}_${seconds}.json`);
  writeFileSync(file, JSON.stringify(scenario(copters, seconds)));
  return file;
}

// The log of a scenario, as the simulator writes it.
export function recorded(folder: string, copters: number, seconds: number): Buffer {
  const log = join(folder, `grid_${copters}_${seconds}.lcm`);
  const run = spawnSync(streamProgram, ['--log', log, writeScenario(folder, copters, seconds)], {
    encoding: 'utf8',
  });
  if (run.status !== 0) throw new Error(`coptersim_stream: ${run.stderr}`);
  return readFileSync(log);
}
