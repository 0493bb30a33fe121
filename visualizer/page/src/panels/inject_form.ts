// The form for injecting a fault: where, which model with its parameters, from when and for how long.

import { button, el, labelled, newId, setHidden, setOptions, setText } from '../shell/dom';
import { caseParams } from './case_params';
import { type Field, fieldsOf, findModel, injection, modelsOf, probeUnit } from './fault_catalogue';
import { forkHere } from './fork';
import { objectName } from './format';
import { act, type Context, type Panel } from './panel';
import { isPosition, type Place, places } from './probes';

const classTitles: Readonly<Record<string, string>> = {
  probe: 'values',
  sensor: 'sensors',
  communication: 'communication',
};

export function injectPanel(context: Context): Panel {
  const form = new InjectForm(context);
  return {
    element: form.element,
    topics: ['source', 'status', 'case', 'world', 'selection', 'time'],
    everyMs: 200,
    update: () => form.update(),
  };
}

class InjectForm {
  readonly element: HTMLElement;
  private readonly object = el('select', {});
  private readonly probe = el('select', {});
  private readonly model = el('select', {});
  private readonly meaning = el('p', { class: 'hint' });
  private readonly parameters = el('div', { class: 'parameters' });
  private readonly unit = el(
    'select',
    {},
    el('option', { value: 's' }, 's'),
    el('option', { value: 'calls' }, 'calls'),
  );
  private readonly start = el('input', { type: 'text', inputmode: 'decimal', value: '0', size: '5' });
  private readonly length = el('input', {
    type: 'text',
    inputmode: 'decimal',
    placeholder: 'no end',
    size: '5',
  });
  private readonly inject = el('button', { type: 'submit', class: 'primary' }, 'Inject');
  private readonly clear: HTMLButtonElement;
  private readonly fork: HTMLButtonElement;
  private readonly reason = el('p', { class: 'hint', role: 'note' });
  private readonly values = new Map<string, string>();
  private fields: readonly Field[] = [];
  private shownFields = '';
  private shownModel = '';
  private places: readonly Place[] = [];
  private observer = -1;
  private timed = false; // by the user; else the probe says how long

  constructor(private readonly context: Context) {
    this.clear = button('Clear all', () => void act(context, 'clear_faults'));
    this.fork = button('Fork from here', () => void forkHere(context), {
      title: 'Continue live from this instant; it is recorded as a new case',
    });
    this.object.addEventListener('change', () => this.showProbes());
    this.probe.addEventListener('change', () => this.showModels());
    this.model.addEventListener('change', () => this.showFields());
    const timing: readonly HTMLElement[] = [this.start, this.length, this.unit];
    for (const control of timing) {
      control.addEventListener('input', () => {
        this.timed = true;
      });
      // Whoever empties what is empty wants it so; that is no input.
      control.addEventListener('keydown', ({ key }) => {
        if (key === 'Delete' || key === 'Backspace') this.timed = true;
      });
    }
    this.element = this.build();
  }

  private build(): HTMLElement {
    const form = el(
      'form',
      { novalidate: true },
      el('div', { class: 'two' }, labelled('Object', this.object), labelled('Probe', this.probe)),
      labelled('Model', this.model, 'field beside'),
      this.meaning,
      this.parameters,
      el(
        'div',
        { class: 'three' },
        labelled('Start in', this.start),
        labelled('For', this.length),
        labelled('Counted in', this.unit),
      ),
      el('p', { class: 'row' }, this.inject, this.clear, this.fork),
      this.reason,
    );
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.submit();
    });
    return el(
      'section',
      { class: 'section', 'aria-label': 'Inject fault' },
      el('h2', {}, 'Inject fault'),
      form,
    );
  }

  update(): void {
    const { state } = this.context.viewer;
    const objects = state.frame?.objects ?? [];
    this.places = places(caseParams(state.caseInfo), objects, state.world);
    const named = objects.filter((o) => this.places.some((place) => place.object === o.id));
    const options = named.map((o) => ({ value: String(o.id), label: objectName(o) }));
    const others = this.places.some(
      (place) => place.object < 0 || !objects.some((o) => o.id === place.object),
    );
    const chosen = state.observer !== this.observer ? String(state.observer) : undefined;
    this.observer = state.observer;
    const all = others || options.length === 0 ? [...options, { value: '', label: 'others' }] : options;
    setOptions(this.object, all, all.some((o) => o.value === chosen) ? chosen : undefined);
    this.showProbes();
    const { controlAllowed, controlReason } = state;
    const nowhere = this.probe.value === '';
    this.inject.disabled = !controlAllowed || nowhere;
    this.clear.disabled = !controlAllowed;
    this.fork.disabled = !this.mayFork();
    const why = controlReason === '' && nowhere ? 'No probe is known yet.' : controlReason;
    setText(this.reason, why);
    setHidden(this.reason, why === '');
  }

  // A fork makes a replay live, so it is not refused for being one; the player has the last word.
  private mayFork(): boolean {
    const { connection, status } = this.context.viewer.state;
    return (
      connection.kind === 'socket' && connection.connected && status?.mode === 2 && status.controlAllowed
    );
  }

  private showProbes(): void {
    const id = this.object.value === '' ? null : Number(this.object.value);
    const { frame } = this.context.viewer.state;
    const known = new Set((frame?.objects ?? []).map((o) => o.id));
    const shown = this.places.filter((p) => (id === null ? !known.has(p.object) : p.object === id));
    setOptions(
      this.probe,
      shown.map(({ name, where }) => ({
        value: name,
        label: name,
        group: where === 'probe' ? 'probes' : 'channels',
      })),
    );
    this.showModels();
  }

  private where(): Place['where'] {
    return this.places.find((place) => place.name === this.probe.value)?.where ?? 'probe';
  }

  private showModels(): void {
    const before = this.model.value;
    setOptions(
      this.model,
      modelsOf(this.where()).map(({ name, class: of }) => ({
        value: name,
        label: name.replaceAll('_', ' '),
        group: classTitles[of] ?? of,
      })),
    );
    if (!this.timed) this.proposeLength();
    if (before === '' && this.where() === 'probe') this.model.value = 'offset';
    this.showFields();
  }

  private proposeLength(): void {
    const once = isPosition(this.probe.value);
    this.length.value = once ? '1' : '';
    this.unit.value = once ? 'calls' : 's';
  }

  private showFields(): void {
    const model = findModel(this.where(), this.model.value);
    const unit = probeUnit(this.probe.value);
    const applied = this.values.get('apply') ?? '';
    const key = [this.where(), this.model.value, unit, applied].join();
    if (key === this.shownFields) return;
    this.shownFields = key;
    this.fields = model === null ? [] : fieldsOf(model, unit, applied);
    setText(this.meaning, model === null ? '' : `${model.meaning} (${model.standard})`);
    const chosen = `${this.model.value} ${applied}`;
    for (const field of this.fields) {
      const typed = this.values.get(field.name);
      this.values.set(
        field.name,
        chosen === this.shownModel ? (typed ?? field.initial) : valueFor(field, typed),
      );
    }
    this.shownModel = chosen;
    this.keepingFocus(() =>
      this.parameters.replaceChildren(...this.fields.map((field) => this.input(field))),
    );
  }

  // New inputs take the place of those that somebody may be typing into.
  private keepingFocus(replace: () => void): void {
    const focused = document.activeElement;
    const isInput = focused instanceof HTMLInputElement || focused instanceof HTMLSelectElement;
    const name = isInput && this.parameters.contains(focused) ? focused.name : '';
    const caret = focused instanceof HTMLInputElement ? focused.selectionStart : null;
    replace();
    if (name === '') return;
    const next = this.parameters.querySelector<HTMLElement>(`[name="${name}"]`);
    next?.focus();
    if (next instanceof HTMLInputElement) next.setSelectionRange(caret, caret);
  }

  private input(field: Field): HTMLElement {
    const control = field.kind === 'choice' ? el('select', {}) : el('input', { type: 'text', size: '8' });
    control.name = field.name;
    if (control instanceof HTMLSelectElement) {
      setOptions(
        control,
        field.choices.map((c) => ({ value: c, label: c === '' ? '–' : c })),
      );
    } else if (field.kind !== 'text') control.setAttribute('inputmode', 'decimal');
    control.value = this.values.get(field.name) ?? field.initial;
    control.addEventListener('input', () => {
      this.values.set(field.name, control.value);
      if (field.name === 'apply') this.showFields();
    });
    const row = labelled(field.label, control, 'field beside');
    if (field.hint !== '') {
      const hint = el('span', { class: 'unit', id: newId('unit') }, field.hint);
      control.setAttribute('aria-describedby', hint.id);
      row.append(hint);
    }
    return row;
  }

  private async submit(): Promise<void> {
    const model = findModel(this.where(), this.model.value);
    if (model === null) return;
    const timing = {
      unit: this.unit.value === 'calls' ? ('calls' as const) : ('s' as const),
      from: this.start.value.trim(),
      length: this.length.value.trim(),
    };
    const made = injection(this.probe.value, model, this.fields, this.values, timing);
    if (!made.ok) this.context.notify(made.error, true);
    else await act(this.context, 'inject', Number(this.object.value || -1), [], made.text);
  }
}

// What was typed for another model is kept where it is right for this one.
function valueFor(field: Field, before: string | undefined): string {
  return before !== undefined && before !== '' && field.check(before) === '' ? before : field.initial;
}
