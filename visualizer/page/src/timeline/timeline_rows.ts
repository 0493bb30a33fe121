// Draws the rows above the curves: commands, faults, avoidance, verdict.

import type { CaseInfo } from '../../../codec/messages';
import { ON_FAULT, FAULT_COLORS, type Palette } from '../map/palette';
import type { Surface } from '../map/surface';
import type { Avoiding } from '../model/avoidance';
import { faultLetter, faultText } from '../model/faults';
import { marks } from '../model/time_axis';
import type { Collision } from '../model/viewer';
import { type Bar, laneCount } from './lanes';
import { LEFT, type PlotArea, RIGHT, spacingUs, timeToX } from './plot_area';

export interface Rows {
  readonly palette: Palette;
  readonly caseInfo: CaseInfo | null;
  readonly currentCommand: number;
  readonly failingCommand: number;
  readonly bars: readonly Bar[];
  readonly avoiding: readonly Avoiding[];
  readonly collisions: readonly Collision[];
  readonly failureUs: number | null;
  readonly heldUs: { readonly fromUs: number; readonly toUs: number }; // what the buffer has
  readonly loop: { readonly fromUs: number; readonly toUs: number } | null;
}

export const ROW = 18; // CSS pixels
const TOP = 4;
const OVERHANG = 6; // of triangles and crosses at the ends of the axis
const LANES_SHOWN = 5; // so many at full height; more lanes are lower

export function rowsHeight(bars: readonly Bar[]): number {
  return TOP + 2 * ROW + lanesHeight(bars) + 2;
}

export function laneHeight(bars: readonly Bar[]): number {
  return Math.min(ROW - 2, (LANES_SHOWN * (ROW - 2)) / Math.max(laneCount(bars), 1));
}

function lanesHeight(bars: readonly Bar[]): number {
  return Math.max(laneCount(bars), 1) * laneHeight(bars);
}

// Where the rows begin, from above.
export function rowTops(bars: readonly Bar[]): { commands: number; faults: number; avoidance: number } {
  return { commands: TOP, faults: TOP + ROW, avoidance: TOP + ROW + lanesHeight(bars) };
}

export function drawRows(surface: Surface, area: PlotArea, rows: Rows): void {
  const height = rowsHeight(rows.bars);
  drawGround(surface, area, rows, height);
  drawCommands(surface, area, rows);
  drawFaults(surface, area, rows);
  drawAvoidance(surface, area, rows);
  drawEnds(surface, area, rows);
  hideBeyond(surface, area, rows.palette, height);
  drawNames(surface, rows);
}

function drawGround(surface: Surface, area: PlotArea, { palette, heldUs, loop }: Rows, height: number): void {
  fillRect(surface, palette.panel, 0, 0, area.width, height);
  const held = timeToX(area, heldUs.fromUs);
  if (held > LEFT) fillRect(surface, palette.background, LEFT, 0, held - LEFT, height);
  const until = timeToX(area, heldUs.toUs);
  if (until < area.width - RIGHT) {
    fillRect(surface, palette.background, until, 0, area.width - RIGHT - until, height);
  }
  surface.beginPath();
  for (const tUs of marks(area.span, spacingUs(area)).timesUs) {
    const x = Math.round(timeToX(area, tUs)) + 0.5;
    surface.moveTo(x, 0);
    surface.lineTo(x, height);
  }
  surface.strokeStyle = palette.grid;
  surface.lineWidth = 1;
  surface.stroke();
  if (loop === null) return;
  surface.globalAlpha = 0.18;
  const x = timeToX(area, loop.fromUs);
  fillRect(surface, palette.accent, x, 0, timeToX(area, loop.toUs) - x, height);
  surface.globalAlpha = 1;
}

function drawNames(surface: Surface, { palette, bars }: Rows): void {
  const tops = rowTops(bars);
  surface.font = `11px ${palette.font}`;
  surface.textAlign = 'left';
  surface.textBaseline = 'middle';
  surface.fillStyle = palette.soft;
  surface.fillText('commands', 6, tops.commands + ROW / 2);
  surface.fillText('faults', 6, (tops.faults + tops.avoidance) / 2);
  surface.fillText('avoidance', 6, tops.avoidance + ROW / 2);
}

// A bar for the time a command runs; a triangle where it injects a fault.
function drawCommands(surface: Surface, area: PlotArea, rows: Rows): void {
  const { palette, caseInfo, currentCommand, failingCommand } = rows;
  const commands = caseInfo?.commands ?? [];
  const top = rowTops(rows.bars).commands;
  commands.forEach((command, index) => {
    if (isFault(command.name)) return;
    const x = timeToX(area, command.tUs);
    const until = timeToX(area, commands[index + 1]?.tUs ?? rows.heldUs.toUs);
    const color = index === failingCommand ? palette.bad : palette.accent;
    surface.globalAlpha = index === currentCommand || index === failingCommand ? 0.95 : 0.4;
    fillRect(surface, color, x, top + 5, Math.max(until - x - 1, 2), ROW - 10);
  });
  surface.globalAlpha = 1;
  surface.beginPath();
  for (const command of commands) {
    if (!isFault(command.name)) continue;
    const x = timeToX(area, command.tUs);
    surface.moveTo(x, top + 1);
    surface.lineTo(x + 6, top + ROW - 3);
    surface.lineTo(x - 6, top + ROW - 3);
    surface.closePath();
  }
  surface.fillStyle = FAULT_COLORS.P ?? palette.warn;
  surface.fill();
  surface.strokeStyle = palette.warn;
  surface.lineWidth = 1;
  surface.stroke();
}

// Whether a command injects a fault, by its name.
export function isFault(name: string): boolean {
  return /fault|inject|arm/i.test(name);
}

function drawFaults(surface: Surface, area: PlotArea, rows: Rows): void {
  const top = rowTops(rows.bars).faults;
  const height = laneHeight(rows.bars);
  surface.textAlign = 'left';
  surface.textBaseline = 'middle';
  for (const { fault, lane, toUs } of rows.bars) {
    const letter = faultLetter(fault);
    const x = Math.max(timeToX(area, fault.fromUs), LEFT);
    const until = Math.min(timeToX(area, toUs), area.width - RIGHT);
    const y = top + lane * height;
    if (until < LEFT || x > area.width - RIGHT) continue;
    fillRect(
      surface,
      FAULT_COLORS[letter] ?? rows.palette.warn,
      x,
      y + 1,
      Math.max(until - x, 3),
      height - 2,
    );
    if (height < 10) continue;
    surface.fillStyle = ON_FAULT;
    surface.font = `bold 11px ${rows.palette.font}`;
    if (until - x > 12) surface.fillText(letter, x + 4, y + height / 2);
    surface.font = `11px ${rows.palette.font}`;
    const text = fitting(faultText(fault), until - x - 26);
    if (text !== '') surface.fillText(text, x + 19, y + height / 2);
  }
}

// As much of a text as fits into so many pixels, at a width that letters of 11 pixels seldom exceed.
function fitting(text: string, px: number): string {
  const letters = Math.floor(px / 6.2);
  if (text.length <= letters) return text;
  return letters >= 4 ? `${text.slice(0, letters - 1)}…` : '';
}

function drawAvoidance(surface: Surface, area: PlotArea, { palette, bars, avoiding }: Rows): void {
  const top = rowTops(bars).avoidance;
  for (const { fromUs, toUs } of avoiding) {
    const x = timeToX(area, fromUs);
    fillRect(surface, palette.accent, x, top + 4, Math.max(timeToX(area, toUs) - x, 2), ROW - 8);
  }
}

// A cross at each collision and where the verdict fell.
function drawEnds(surface: Surface, area: PlotArea, { palette, bars, collisions, failureUs }: Rows): void {
  const y = rowTops(bars).avoidance + ROW / 2;
  const times = new Set(collisions.map((collision) => collision.tUs));
  if (failureUs !== null) times.add(failureUs);
  surface.beginPath();
  for (const tUs of times) {
    const x = timeToX(area, tUs);
    surface.moveTo(x - 5, y - 5);
    surface.lineTo(x + 5, y + 5);
    surface.moveTo(x - 5, y + 5);
    surface.lineTo(x + 5, y - 5);
  }
  surface.strokeStyle = palette.bad;
  surface.lineWidth = 3;
  surface.stroke();
}

// What a zoomed axis pushed out of the plot must not stand in the margins.
function hideBeyond(surface: Surface, area: PlotArea, palette: Palette, height: number): void {
  fillRect(surface, palette.panel, 0, 0, LEFT - OVERHANG, height);
  fillRect(surface, palette.panel, area.width - RIGHT + OVERHANG, 0, RIGHT - OVERHANG, height);
}

function fillRect(
  surface: Surface,
  color: string,
  x: number,
  y: number,
  width: number,
  height: number,
): void {
  surface.beginPath();
  surface.rect(x, y, width, height);
  surface.fillStyle = color;
  surface.fill();
}
