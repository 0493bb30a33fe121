// How main.ts joins the shell with the drawing parts: the shell gives places and settings, the map
// takes what keys and buttons ask of it.

import type { Viewer } from '../model/viewer';
import type { SettingsStore } from './settings';

// What the shell asks of the map.
export interface MapControls {
  zoom(direction: 1 | -1): void; // at the centre
  fit(): void;
  toggleMeasure(): boolean; // answers whether it is now on
  measuring(): boolean;
  clear(): void; // Esc: measurement and the like
  centreOn(x: number, y: number): void; // m
  picture(): Promise<Blob>; // PNG of what is seen
  svg(): string; // the same as an SVG document
}

export interface Shell {
  readonly mapHost: HTMLElement; // position: relative; the map fills it
  readonly timelineHost: HTMLElement; // above the curves, same width
  readonly curvesHost: HTMLElement;
  attachMap(map: MapControls): void;
  notify(line: string, bad?: boolean): void; // one line, for some seconds
}

export interface CaseName {
  id: string;
  title: string;
}

// What needs the world outside of the viewer; there is no list of cases in a report.
export interface Outside {
  listCases?: () => Promise<readonly CaseName[]>; // GET /cases
  fetchCase?: (id: string) => Promise<ArrayBuffer>; // GET /cases/<id>.lcm
}

// mountShell(root, viewer, settings, outside) in shell.ts makes one.
export type MountShell = (
  root: HTMLElement,
  viewer: Viewer,
  settings: SettingsStore,
  outside: Outside,
) => Shell;
