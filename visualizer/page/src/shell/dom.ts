// Making elements. Text comes in as text nodes only; there is no way here to set markup or styles.

type Attributes = Readonly<Record<string, string | boolean | undefined>>;

// `true' sets an empty attribute, `false' and undefined none.
export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: readonly (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === true) element.setAttribute(name, '');
    else if (typeof value === 'string') element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

export function button(label: string, onClick: () => void, attributes: Attributes = {}): HTMLButtonElement {
  const made = el('button', { type: 'button', ...attributes }, label);
  made.addEventListener('click', onClick);
  return made;
}

// Sets text only when it differs, so that screen readers and selections are left alone.
export function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

export function setClass(element: Element, name: string, on: boolean): void {
  element.classList.toggle(name, on);
}

export function setHidden(element: HTMLElement, hidden: boolean): void {
  if (element.hidden !== hidden) element.hidden = hidden;
}

let ids = 0;
export function newId(prefix: string): string {
  ids += 1;
  return `${prefix}-${ids}`;
}

// A label above or beside its control; they know of each other.
export function labelled(text: string, control: HTMLElement, className = 'field'): HTMLElement {
  if (control.id === '') control.id = newId('f');
  return el('div', { class: className }, el('label', { for: control.id }, text), control);
}

export interface Option {
  value: string;
  label: string;
  group?: string;
}

// Refills a select only when its options changed; keeps the choice where it still exists.
export function setOptions(select: HTMLSelectElement, options: readonly Option[], chosen?: string): void {
  const signature = JSON.stringify(options);
  if (select.dataset.signature !== signature) {
    const before = select.value;
    select.dataset.signature = signature;
    select.replaceChildren(...optionNodes(options));
    if (options.some((o) => o.value === before)) select.value = before;
  }
  if (chosen !== undefined && select.value !== chosen) select.value = chosen;
}

function optionNodes(options: readonly Option[]): Node[] {
  const nodes: Node[] = [];
  const groups = new Map<string, HTMLOptGroupElement>();
  for (const { value, label, group } of options) {
    const node = el('option', { value }, label);
    if (group === undefined) {
      nodes.push(node);
      continue;
    }
    let parent = groups.get(group);
    if (parent === undefined) {
      parent = el('optgroup', { label: group });
      groups.set(group, parent);
      nodes.push(parent);
    }
    parent.append(node);
  }
  return nodes;
}
