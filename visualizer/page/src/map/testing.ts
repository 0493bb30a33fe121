// For tests of drawings: a scene with nothing in it, on which a test puts what it is about.

import { packFrame } from '../model/packed_frame';
import { anObject } from '../model/testing';
import { TimeBuffer } from '../model/time_buffer';
import type { PackedFrame } from '../model/packed_frame';
import type { VizObject } from '../../../codec/messages';
import { readPalette } from './palette';
import type { Scene } from './scene';

const shown = {
  grid: false,
  terrain: false,
  risk: false,
  comfort: false,
  trails: false,
  perceived: false,
  anchors: false,
  ranges: false,
  labels: false,
  tiles: false,
};

// Each colour is its property's name, so that a test can tell what was drawn with which.
export const testPalette = readPalette((property) => property);

export function aScene(objects: readonly VizObject[] = [anObject(1)], change: Partial<Scene> = {}): Scene {
  const frames = new TimeBuffer<PackedFrame>(1e6);
  const frame = packFrame({ tUs: 1e6, run: 1, seq: 1, objects: [...objects] }, null);
  frames.add(frame);
  return {
    view: { x: 0, y: 0, scale: 100, size: { width: 400, height: 300 } },
    palette: testPalette,
    layers: shown,
    trail: 2,
    unit: 'm',
    tUs: 1e6,
    world: null,
    frames,
    frame,
    risk: null,
    ranges: null,
    faults: null,
    collisions: [],
    observer: -1,
    pinned: [],
    measure: null,
    stamps: null,
    ground: null,
    ...change,
  };
}

export function withLayers(...names: readonly (keyof typeof shown)[]): Scene['layers'] {
  return { ...shown, ...Object.fromEntries(names.map((name) => [name, true])) };
}
