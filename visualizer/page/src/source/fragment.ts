// The page's address after #, which can be shared: #case=..&t=..&obs=.. (t in seconds).

export interface Place {
  readonly caseId: string | null;
  readonly tUs: number | null;
  readonly observer: number | null;
}

// What of a fragment (with or without #) can be understood.
export function parseFragment(fragment: string): Place {
  const words = new URLSearchParams(fragment.replace(/^#/, ''));
  const caseId = words.get('case');
  const seconds = numberIn(words.get('t'), 1e6);
  const observer = numberIn(words.get('obs'), 0x7fffffff);
  return {
    caseId: caseId !== null && /^[A-Za-z0-9_-]{1,64}$/.test(caseId) ? caseId : null,
    tUs: seconds === null ? null : Math.round(seconds * 1e6),
    observer: Number.isInteger(observer) ? observer : null,
  };
}

export function formatFragment(place: Place): string {
  const words: string[] = [];
  if (place.caseId !== null && place.caseId !== '') words.push(`case=${encodeURIComponent(place.caseId)}`);
  if (place.tUs !== null) words.push(`t=${(place.tUs / 1e6).toFixed(3)}`);
  if (place.observer !== null && place.observer >= 0) words.push(`obs=${place.observer}`);
  return words.length > 0 ? `#${words.join('&')}` : '';
}

// A number from 0 to `high`, null for anything else.
function numberIn(text: string | null, high: number): number | null {
  if (text === null || text.trim() === '') return null;
  const value = Number(text);
  return value >= 0 && value <= high ? value : null;
}
