// The log inside a report: gzip and base64 in a script element that no browser runs
// (docs/visualizer.md, "A report").

export interface EmbeddedLog {
  readonly name: string;
  readonly bytes: ArrayBuffer;
}

// A report that unpacks to more than this is refused.
export const MAX_UNPACKED_BYTES = 512 * 2 ** 20;

// The log of this page, null when it is no report; rejects with one line.
export async function embeddedLog(page: Document): Promise<EmbeddedLog | null> {
  const element = page.querySelector('script[type="application/gzip"]#log');
  if (!(element instanceof HTMLElement)) return null;
  const name = element.dataset.name ?? 'report';
  return { name, bytes: await unpacked(element.textContent ?? '', MAX_UNPACKED_BYTES) };
}

// Bytes of base64 of gzip; rejects with one line when it is neither, or unpacks to more than `limit`.
export async function unpacked(base64: string, limit: number): Promise<ArrayBuffer> {
  const packed = bytesOfBase64(base64.replace(/\s+/g, ''));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  const reader = stream.getReader();
  const parts: Uint8Array<ArrayBuffer>[] = [];
  let size = 0;
  try {
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
      size += part.value.byteLength;
      if (size > limit) throw new RangeError(`the log in this report unpacks to over ${limit} bytes`);
      parts.push(part.value);
    }
  } catch (error) {
    if (error instanceof RangeError) throw error;
    throw new Error('the log in this report is damaged: it is not whole gzip');
  }
  return new Blob(parts).arrayBuffer();
}

function bytesOfBase64(base64: string): Uint8Array<ArrayBuffer> {
  let binary: string;
  try {
    binary = atob(base64);
  } catch {
    throw new Error('the log in this report is damaged: it is not base64');
  }
  const bytes = new Uint8Array(binary.length);
  for (let index = 0; index < binary.length; index++) bytes[index] = binary.charCodeAt(index);
  return bytes;
}
