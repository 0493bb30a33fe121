// Files in and out: choosing, dropping, saving.

import { el } from './dom';

// Opens the browser's dialog for a file.
export function filePicker(onFile: (file: File) => void): { element: HTMLElement; open(): void } {
  const input = el('input', {
    type: 'file',
    accept: '.lcm,.html',
    hidden: true,
    'aria-label': 'A log or a report',
  });
  input.addEventListener('change', () => {
    const file = input.files?.[0];
    input.value = '';
    if (file !== undefined) onFile(file);
  });
  return { element: input, open: () => input.click() };
}

// Takes files dropped anywhere on the page; `target' says so while one is held over it.
export function acceptDrops(target: HTMLElement, onFile: (file: File) => void): void {
  let depth = 0;
  const show = (change: number): void => {
    depth = Math.max(0, depth + change);
    target.classList.toggle('dropping', depth > 0);
  };
  const hasFile = (event: DragEvent): boolean => event.dataTransfer?.types.includes('Files') ?? false;
  document.addEventListener('dragenter', (event) => hasFile(event) && show(1));
  document.addEventListener('dragleave', (event) => hasFile(event) && show(-1));
  document.addEventListener('dragover', (event) => hasFile(event) && event.preventDefault());
  document.addEventListener('drop', (event) => {
    depth = 0;
    show(0);
    const file = event.dataTransfer?.files[0];
    if (file === undefined) return;
    event.preventDefault();
    onFile(file);
  });
}

export function save(name: string, content: Blob): void {
  const url = URL.createObjectURL(content);
  const link = el('a', { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
