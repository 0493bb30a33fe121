// Light or dark: as chosen, or as the system prefers.

import type { SettingsStore } from './settings';

export type Theme = 'light' | 'dark';

const prefersDark = '(prefers-color-scheme: dark)';

export function themeOf(chosen: 'auto' | Theme, systemIsDark: boolean): Theme {
  if (chosen !== 'auto') return chosen;
  return systemIsDark ? 'dark' : 'light';
}

// Keeps the theme on the root element, which theme.css looks at. To be called before any other part
// listens to the settings, so that they find the new colours.
export function followTheme(settings: SettingsStore): void {
  const query = window.matchMedia(prefersDark);
  const apply = (): void => {
    document.documentElement.dataset.theme = themeOf(settings.value.theme, query.matches);
  };
  apply();
  settings.listen(apply);
  query.addEventListener('change', () => settings.update({}));
}

export function otherTheme(settings: SettingsStore): Theme {
  const now = themeOf(settings.value.theme, window.matchMedia(prefersDark).matches);
  return now === 'dark' ? 'light' : 'dark';
}
