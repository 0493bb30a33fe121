// A step of the page's build: renames the built file, and puts a content security policy into it that lists the
// hashes of its inline scripts and styles.
import { createHash } from 'node:crypto';
import type { Plugin } from 'vite';

// The text of each inline <style> or <script> that runs; a script with a data type is not run.
function inlineTexts(html: string, tag: 'script' | 'style'): string[] {
  const elements = html.matchAll(new RegExp(`<${tag}(\\s[^>]*)?>([\\s\\S]*?)</${tag}>`, 'g'));
  return [...elements]
    .filter(([, attributes]) => !/type="(?!module")/.test(attributes ?? ''))
    .map(([, , text]) => text ?? '');
}

const hashes = (texts: string[]): string =>
  texts.map((text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`).join(' ') || "'none'";

// The policy that allows exactly what is in this page, and the WebSocket of where it came from.
export function policyOf(html: string): string {
  return [
    "default-src 'none'",
    `script-src ${hashes(inlineTexts(html, 'script'))}`,
    `style-src ${hashes(inlineTexts(html, 'style'))}`,
    "connect-src 'self'",
    "img-src 'self' blob: data:",
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');
}

const withPolicy = (html: string): string =>
  html.replace(
    /<meta charset="utf-8"\s*\/?>/i,
    (charset) => `${charset}\n<meta http-equiv="Content-Security-Policy" content="${policyOf(html)}">`,
  );

export function contentSecurity(fileName: string): Plugin {
  return {
    name: 'content-security',
    enforce: 'post',
    generateBundle: {
      order: 'post',
      handler(_options, bundle) {
        const page = bundle['index.html'];
        if (page?.type !== 'asset') throw new Error('the build made no index.html');
        const html = withPolicy(page.source.toString());
        if (!html.includes('Content-Security-Policy'))
          throw new Error('index.html has no <meta charset="utf-8">');
        delete bundle['index.html'];
        this.emitFile({ type: 'asset', fileName, source: html });
      },
    },
  };
}
