import { expect, it } from 'vitest';
import { watchPointerFocus } from './focus';

it('knows whether the focus came from a pointer', () => {
  const page = new EventTarget();
  const byPointer = watchPointerFocus(page);
  const after = (...types: string[]): boolean => {
    for (const type of types) page.dispatchEvent(new Event(type));
    return byPointer();
  };
  expect(byPointer()).toBe(false);
  expect(after('pointerdown', 'focusin')).toBe(true);
  expect(after('keydown')).toBe(true); // Space: the focus is still where the click put it
  expect(after('keydown', 'focusin')).toBe(false); // Tab
  expect(after('pointerdown')).toBe(true); // on what has the focus already
});
