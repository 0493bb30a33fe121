// Timeline and curves as one SVG document.

import { SvgSurface } from '../map/svg_surface';
import type { Viewer } from '../model/viewer';
import type { Timeline } from '../timeline/timeline';
import type { Curves } from './curves';

export function timeSvg(timeline: Timeline, curves: Curves, viewer: Viewer): string {
  const surface = new SvgSurface();
  const rows = timeline.draw(surface);
  const height = curves.draw(surface, rows.height);
  const name = viewer.state.caseInfo?.caseId ?? 'curves';
  return surface.document(rows.width, rows.height + height, name);
}
