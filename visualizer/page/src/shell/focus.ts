// What the focused element does with keys itself.

import type { Focus } from './keys';

const typed = new Set(['text', 'number', 'search', 'email', 'url', 'password', 'tel']);

export function focusOf(element: Element | null): Focus {
  if (element === null) return 'none';
  if (element instanceof HTMLSelectElement || element instanceof HTMLTextAreaElement) return 'typing';
  if (element instanceof HTMLInputElement) return typed.has(element.type) ? 'typing' : 'button';
  if (element instanceof HTMLElement && element.isContentEditable) return 'typing';
  const role = element.getAttribute('role');
  if (role === 'slider' || role === 'tab') return 'arrows';
  return element.matches('button, summary, a[href]') ? 'button' : 'none';
}
