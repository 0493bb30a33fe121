import { describe, expect, it } from 'vitest';
import { type PlayContext, Playback } from './playback';

const S = 1e6;
const context = (change: Partial<PlayContext> = {}): PlayContext => ({
  source: 'file',
  fromUs: 0,
  toUs: 8 * S,
  empty: false,
  durationUs: 8 * S,
  ends: true,
  live: false,
  mayAsk: true,
  producing: false,
  stopsUs: [],
  frameTime: (tUs, frames) => Math.min(8 * S, Math.max(0, tUs + frames * 0.1 * S)),
  ...change,
});
const socket = (change: Partial<PlayContext> = {}) =>
  context({ source: 'socket', producing: true, ...change });
const at = (tUs: number, change: Partial<Playback> = {}) =>
  Object.assign(new Playback(), { tUs, following: false, ...change });

describe('from a file', () => {
  it('plays at its speed and stops at the end', () => {
    const playback = at(1 * S, { speed: 2 });
    expect(playback.play(context())).toEqual([]);
    playback.advance(0.5, context());
    expect(playback.tUs).toBe(2 * S);
    playback.advance(10, context());
    expect([playback.tUs, playback.playing]).toEqual([8 * S, false]);
  });

  it('begins again when played at the end', () => {
    const playback = at(8 * S);
    playback.play(context());
    expect([playback.tUs, playback.playing]).toEqual([0, true]);
  });

  it('loops', () => {
    const playback = at(2.9 * S, { loop: { fromUs: 2 * S, toUs: 3 * S }, playing: true });
    playback.advance(0.2, context());
    expect([playback.tUs, playback.playing]).toEqual([2 * S, true]);
  });

  it('stops at a collision, and plays on when told so', () => {
    const playback = at(4 * S, { playing: true });
    playback.advance(2, context({ stopsUs: [5 * S] }));
    expect([playback.tUs, playback.playing]).toEqual([5 * S, false]);
    playback.play(context({ stopsUs: [5 * S] }));
    playback.advance(1, context({ stopsUs: [5 * S] }));
    expect([playback.tUs, playback.playing]).toEqual([6 * S, true]);
  });

  it('runs over collisions when it shall not stop', () => {
    const playback = at(4 * S, { playing: true, stopAtCollision: false });
    playback.advance(2, context({ stopsUs: [5 * S] }));
    expect(playback.tUs).toBe(6 * S);
  });

  it('seeks inside only, and steps by frames', () => {
    const playback = at(0);
    expect(playback.seek(99 * S, context())).toEqual([]);
    expect(playback.tUs).toBe(8 * S);
    expect(playback.step(-3, context())).toEqual([]);
    expect(playback.tUs).toBe(7.7 * S);
  });

  it('keeps speeds within 0.05 and 20', () => {
    const playback = at(0);
    playback.setSpeed(100, context());
    expect(playback.speed).toBe(20);
    playback.setSpeed(0, context());
    expect(playback.speed).toBe(0.05);
  });
});

describe('from a socket', () => {
  it('follows the trailing edge', () => {
    const playback = at(0, { following: true, playing: true });
    playback.advance(0.016, socket());
    expect(playback.tUs).toBe(8 * S);
  });

  it('pausing asks the player only while it produces', () => {
    expect(at(1 * S, { playing: true }).pause(socket())).toEqual([{ verb: 'pause', args: [] }]);
    expect(at(1 * S, { playing: true }).pause(socket({ producing: false }))).toEqual([]);
  });

  it('plays what is held without the player, then lets it go on', () => {
    const paused = socket({ producing: false, durationUs: 20 * S });
    const playback = at(5 * S);
    expect(playback.play(paused)).toEqual([]);
    expect(playback.advance(1, paused)).toEqual([]);
    expect(playback.tUs).toBe(6 * S);
    expect(playback.advance(5, paused)).toEqual([{ verb: 'play', args: [] }]);
    expect(playback.following).toBe(true);
  });

  it('at the end of the case it stops instead of asking', () => {
    const ended = socket({ producing: false, durationUs: 8 * S });
    const playback = at(7 * S, { playing: true });
    expect(playback.advance(5, ended)).toEqual([]);
    expect(playback.playing).toBe(false);
    expect(playback.play(ended)).toEqual([]);
    expect([playback.tUs, playback.playing, playback.following]).toEqual([0, true, false]);
  });

  it('a paused live flight goes on when played', () => {
    const paused = socket({ producing: false, ends: false, live: true });
    const playback = at(8 * S);
    expect(playback.play(paused)).toEqual([{ verb: 'play', args: [] }]);
    expect([playback.playing, playback.following, playback.tUs]).toEqual([true, true, 8 * S]);
    const behind = at(7 * S, { playing: true });
    expect(behind.advance(5, paused)).toEqual([{ verb: 'play', args: [] }]);
    expect(behind.following).toBe(true);
  });

  it('a live flight that is over plays what is held', () => {
    const over = socket({ producing: false, live: true, fromUs: 2 * S });
    const playback = at(8 * S);
    expect(playback.play(over)).toEqual([]);
    expect([playback.playing, playback.tUs]).toEqual([true, 2 * S]);
  });

  it('a replay of which only the end is held is shown again by the player', () => {
    const late = socket({ producing: false, fromUs: 7.9 * S });
    const playback = at(8 * S);
    expect(playback.play(late)).toEqual([
      { verb: 'restart', args: [] },
      { verb: 'play', args: [] },
    ]);
    expect([playback.playing, playback.following]).toEqual([true, true]);
  });

  it('without control what is held of it plays', () => {
    const late = socket({ producing: false, fromUs: 5 * S, mayAsk: false });
    const playback = at(8 * S);
    expect(playback.play(late)).toEqual([]);
    expect([playback.playing, playback.tUs]).toEqual([true, 5 * S]);
    const moment = socket({ producing: false, fromUs: 8 * S, mayAsk: false });
    expect(at(8 * S).play(moment)).toEqual([{ verb: 'restart', args: [] }]);
  });

  it('never seeks a live flight by the player', () => {
    const playback = at(8 * S);
    expect(playback.seek(1 * S, socket({ live: true, fromUs: 2 * S }))).toEqual([]);
    expect(playback.tUs).toBe(2 * S);
    expect(playback.seek(9 * S, socket({ live: true, durationUs: 9 * S }))).toEqual([]);
    expect([playback.tUs, playback.following]).toEqual([8 * S, true]);
  });

  it('seeks inside the buffer by itself, outside by the player', () => {
    const playback = at(0, { following: true });
    expect(playback.seek(3 * S, socket({ fromUs: 2 * S }))).toEqual([]);
    expect([playback.tUs, playback.following]).toEqual([3 * S, false]);
    expect(playback.seek(1 * S, socket({ fromUs: 2 * S }))).toEqual([{ verb: 'seek', args: [1] }]);
    expect(playback.following).toBe(true);
    expect(playback.seek(30 * S, socket({ durationUs: 20 * S }))).toEqual([{ verb: 'seek', args: [20] }]);
  });

  it('steps beyond what is held by the player', () => {
    const playback = at(8 * S);
    expect(playback.step(1, socket({ producing: false }))).toEqual([{ verb: 'step', args: [1] }]);
    expect(playback.following).toBe(true);
  });

  it('does not stop at what lies before the place it was sent to', () => {
    const playback = at(1 * S, { following: true });
    playback.seek(7 * S, socket({ toUs: 2 * S }));
    playback.reset(true); // the player begins a run anew
    playback.advance(0.016, socket({ toUs: 6.9 * S, stopsUs: [5 * S, 7.5 * S] }));
    expect([playback.tUs, playback.playing]).toEqual([6.9 * S, true]);
    playback.advance(0.016, socket({ stopsUs: [5 * S, 7.5 * S] }));
    expect([playback.tUs, playback.playing]).toEqual([7.5 * S, false]);
  });

  it('goes back to live', () => {
    const playback = at(2 * S);
    expect(playback.toLive(socket())).toEqual([]);
    expect([playback.tUs, playback.following, playback.playing]).toEqual([8 * S, true, true]);
  });

  it('pauses the player when a followed replay collides', () => {
    const playback = at(7.99 * S, { following: true, playing: true });
    expect(playback.advance(0.016, socket({ stopsUs: [8 * S] }))).toEqual([{ verb: 'pause', args: [] }]);
    expect([playback.tUs, playback.playing]).toEqual([8 * S, false]);
  });
});
