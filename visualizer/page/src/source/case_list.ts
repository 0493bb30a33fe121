// The bridge's list of stored cases: GET /cases.

import type { CaseName } from '../shell/parts';

// What of the answer is a list of cases; entries of another shape are left out.
export function parseCases(answer: unknown): CaseName[] {
  if (!Array.isArray(answer)) return [];
  const cases: CaseName[] = [];
  for (const entry of answer as unknown[]) {
    if (typeof entry === 'string') cases.push({ id: entry, title: entry });
    if (typeof entry !== 'object' || entry === null) continue;
    const { id, title } = entry as { id?: unknown; title?: unknown };
    if (typeof id === 'string') cases.push({ id, title: typeof title === 'string' ? title : id });
  }
  return cases;
}

// Rejects with one line.
export async function listCases(base: string): Promise<CaseName[]> {
  const answer = await fetch(`${base}/cases`);
  if (!answer.ok) throw new Error(`${base}/cases: the bridge answers ${answer.status}`);
  return parseCases(await answer.json());
}
