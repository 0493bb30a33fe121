// What the focused element does with keys itself.

import type { Focus } from './keys';

const typed = new Set(['text', 'number', 'search', 'email', 'url', 'password', 'tel']);

export function focusOf(element: Element | null): Focus {
  if (element === null) return 'none';
  if (element instanceof HTMLSelectElement) return 'select';
  if (element instanceof HTMLTextAreaElement) return 'text';
  if (element instanceof HTMLInputElement) return typed.has(element.type) ? 'text' : 'button';
  if (element instanceof HTMLElement && element.isContentEditable) return 'text';
  const role = element.getAttribute('role');
  if (role === 'slider' || role === 'tab') return 'arrows';
  return element.matches('button, summary, a[href]') ? 'button' : 'none';
}

// Answers whether a pointer gave the focus to what has it now, rather than Tab or a program.
export function watchPointerFocus(page: EventTarget): () => boolean {
  let pointerLast = false; // of pointer and keyboard
  let byPointer = false;
  const listen = (type: string, callback: () => void): void => page.addEventListener(type, callback, true);
  listen('pointerdown', () => {
    pointerLast = true;
    byPointer = true; // what has the focus already gets no event
  });
  listen('keydown', () => {
    pointerLast = false;
  });
  listen('focusin', () => {
    byPointer = pointerLast;
  });
  return () => byPointer;
}
