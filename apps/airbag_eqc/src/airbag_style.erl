%% @doc The style sheet of the airbag's report: light and dark, as the reader's system is.
-module(airbag_style).

-export([css/0]).

-spec css() -> iodata().
css() ->
    [colours(), page(), tables(), picture()].

%% Contrast of text is at least 4.5 : 1 on each of the grounds.
colours() ->
    "
:root{--ground:#fcfcfb;--card:#ffffff;--ink:#1a2233;--quiet:#566074;--edge:#d5dae3;--blue:#0a5ca8;
--blue-ground:#e7f0fa;--fault:#8f4400;--fault-ground:#fdf0e1;--bad:#b01226;--bad-ground:#fdecee;
--good:#12693a;--good-ground:#e8f6ee}
@media (prefers-color-scheme:dark){:root{--ground:#12161d;--card:#1a202a;--ink:#e6eaf1;
--quiet:#a3adbf;--edge:#3a4454;--blue:#7fbcf5;--blue-ground:#1b2c40;--fault:#f3b06c;
--fault-ground:#3a2a18;--bad:#ff8f9c;--bad-ground:#40191f;--good:#7ad3a0;--good-ground:#173526}}
".

page() ->
    "*{box-sizing:border-box}
body{margin:0;background:var(--ground);color:var(--ink);
overflow-wrap:break-word;font:15px/1.5 system-ui,'DejaVu Sans',Arial,sans-serif}
main{max-width:1040px;margin:0 auto;padding:24px 20px 60px}
h1{font-size:26px;line-height:1.25;margin:8px 0 4px}
h2{font-size:15px;margin:0 0 10px;text-transform:uppercase;letter-spacing:.05em;
color:var(--quiet)}
section{background:var(--card);border:1px solid var(--edge);border-radius:10px;padding:18px 20px;
margin-top:16px}
p{margin:0 0 6px}
.quiet{color:var(--quiet)}
.badge{display:inline-block;margin:0;padding:2px 12px;border-radius:99px;font-weight:700;
border:2px solid}
.badge.failed{color:var(--bad);background:var(--bad-ground)}
.badge.passed{color:var(--good);background:var(--good-ground)}
code,pre{font:13px/1.5 ui-monospace,'DejaVu Sans Mono',monospace}
pre{overflow-x:auto}
.scroll{overflow-x:auto}
.scroll:focus-visible,summary:focus-visible{outline:3px solid var(--blue);outline-offset:2px}
dl{display:grid;grid-template-columns:max-content 1fr;gap:4px 18px;margin:0}
dt{color:var(--quiet)}
dd{margin:0;overflow-wrap:anywhere}
summary{cursor:pointer;padding:6px 0;margin-top:8px}
".

tables() ->
    "table{border-collapse:collapse;width:100%;font-size:14px}
th{text-align:left;font-weight:600;color:var(--quiet);border-bottom:2px solid var(--edge);
padding:4px 12px 6px 0;white-space:nowrap}
td{border-bottom:1px solid var(--edge);padding:6px 12px 6px 0;vertical-align:top}
tr.bad td{background:var(--bad-ground)}
tr.bad strong{color:var(--bad)}
.byte{display:inline-block;white-space:nowrap;margin-right:6px}
small{font:12px ui-monospace,'DejaVu Sans Mono',monospace;color:var(--quiet)}
.flip{color:var(--fault);font-weight:700;text-decoration:underline;text-underline-offset:2px;
border:1px solid var(--fault);border-radius:3px;padding:0 1px}
".

picture() ->
    "svg{display:block;font:13px system-ui,'DejaVu Sans',Arial,sans-serif}
svg text{fill:var(--ink)}
svg .label,svg .quiet,svg .small{fill:var(--quiet)}
svg .small{font-size:12px}
svg .strong{font-weight:700}
svg .hex{font:14px ui-monospace,'DejaVu Sans Mono',monospace}
svg .box{fill:var(--blue-ground);stroke:var(--blue)}
svg .fault .box{fill:var(--fault-ground);stroke:var(--fault)}
svg .fault text{fill:var(--fault)}
svg .packet .box{fill:none;stroke:var(--edge)}
svg .altered .box{stroke:var(--fault);stroke-width:2;stroke-dasharray:5 3}
svg .altered .small{fill:var(--fault)}
svg tspan.flip{fill:var(--fault);font-weight:700;text-decoration:underline}
svg .notrun .box{fill:none;stroke:var(--quiet);stroke-dasharray:3 3}
svg .notrun text{fill:var(--quiet)}
svg .arrow{fill:none;stroke:var(--quiet);stroke-width:1.5}
svg .axis{stroke:var(--edge)}
svg .limit{stroke:var(--bad);stroke-dasharray:6 4}
svg .limit-text{fill:var(--bad)}
svg .count{fill:none;stroke:var(--blue);stroke-width:2.5}
svg .dot{fill:var(--blue)}
svg .fired circle,svg .cross{fill:none;stroke:var(--bad);stroke-width:2.5}
svg .fired text{fill:var(--bad)}
".
