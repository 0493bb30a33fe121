// What one picture of the map shows, gathered from viewer and settings.

import type { Faults, Ranges, World } from '../../../codec/messages';
import type { PackedFrame } from '../model/packed_frame';
import type { PackedRisk } from '../model/packed_risk';
import type { TimeBuffer } from '../model/time_buffer';
import type { Collision } from '../model/viewer';
import type { LayerName, Trail } from '../shell/settings';
import type { Palette } from './palette';
import type { Stamps } from './stamps';
import type { Ground } from './tile_layer';
import type { View } from './view';

export interface Measure {
  readonly fromX: number; // m
  readonly fromY: number;
  readonly toX: number;
  readonly toY: number;
}

export interface Scene {
  readonly view: View;
  readonly palette: Palette;
  readonly layers: Readonly<Record<LayerName, boolean>>;
  readonly trail: Trail;
  readonly unit: 'm' | 'mm'; // of lengths
  readonly tUs: number;
  readonly world: World | null;
  readonly frames: TimeBuffer<PackedFrame>;
  readonly frame: PackedFrame | null;
  readonly risk: PackedRisk | null;
  readonly ranges: Ranges | null;
  readonly faults: Faults | null;
  readonly collisions: readonly Collision[];
  readonly observer: number;
  readonly pinned: readonly number[];
  readonly measure: Measure | null;
  readonly stamps: Stamps | null; // copies of copters, where they can be had
  readonly ground: Ground | null; // map tiles, likewise
}
