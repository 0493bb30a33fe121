// The bridge's stored cases: GET /cases answers {"cases": [{"id", ...}]}, GET /cases/<id>.lcm a log.

import type { CaseName } from '../shell/parts';

// What of the answer is a list of cases; entries of another shape are left out.
export function parseCases(answer: unknown): CaseName[] {
  const listed = typeof answer === 'object' && answer !== null && 'cases' in answer ? answer.cases : answer;
  if (!Array.isArray(listed)) return [];
  const cases: CaseName[] = [];
  for (const entry of listed as unknown[]) {
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

// Rejects with one line.
export async function fetchCase(base: string, id: string): Promise<ArrayBuffer> {
  const answer = await fetch(`${base}/cases/${encodeURIComponent(id)}.lcm`);
  if (!answer.ok) throw new Error(`case ${id}: the bridge answers ${answer.status}`);
  return answer.arrayBuffer();
}
