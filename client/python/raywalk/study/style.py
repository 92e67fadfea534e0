"""The style of the report's page: light and dark, narrow and wide, on paper."""

from raywalk.study.svg import DARK, LIGHT, RULES, variables

PAGE_LIGHT = "--back:#f5f6f9;--card:#fff;--yes:#0a7d44;--no:#b3261e;--open:#8a6100;--link:#1d4ed8;"
PAGE_DARK = "--back:#0e1116;--card:#171b22;--yes:#46c285;--no:#ff7b72;--open:#e3b341;--link:#8ab4ff;"

CSS = (
    f":root{{color-scheme:light dark;{variables(LIGHT)}{PAGE_LIGHT}}}"
    f"@media (prefers-color-scheme:dark){{:root{{{variables(DARK)}{PAGE_DARK}}}}}"
    + RULES
    + """
*{box-sizing:border-box}
body{margin:0;background:var(--back);color:var(--ink);font:16px/1.55 system-ui,-apple-system,"Segoe UI",sans-serif}
main{max-width:1140px;margin:0 auto;padding:0 20px 64px}
header{padding:56px 0 12px}
h1{font-size:clamp(26px,4.2vw,40px);line-height:1.18;margin:0 0 14px;letter-spacing:-.02em;text-wrap:balance}
h2{font-size:25px;margin:52px 0 12px;letter-spacing:-.01em}
h3{font-size:16px;margin:26px 0 8px}
p{margin:0 0 12px;max-width:76ch}
a{color:var(--link)}
code{font:13px/1.4 ui-monospace,"DejaVu Sans Mono",monospace;background:color-mix(in srgb,var(--ink) 8%,transparent);
padding:1px 5px;border-radius:4px;overflow-wrap:anywhere}
.over{font-size:13px;letter-spacing:.08em;text-transform:uppercase;color:var(--faint);margin-bottom:10px}
.lead{font-size:19px;color:var(--ink)}
.faint,li{color:var(--faint);font-size:14px}
ul{margin:8px 0 16px;padding-left:20px}
li{margin:3px 0;max-width:96ch}
nav{display:flex;flex-wrap:wrap;gap:6px 18px;padding:12px 0;border-top:1px solid var(--rule);
border-bottom:1px solid var(--rule);font-size:15px}
nav a{text-decoration:none}
dl{display:grid;grid-template-columns:repeat(auto-fit,minmax(210px,1fr));gap:14px 24px;margin:22px 0}
dt{font-size:12px;letter-spacing:.06em;text-transform:uppercase;color:var(--faint)}
dd{margin:0;overflow-wrap:anywhere}
.notice{border-left:4px solid var(--open);background:var(--card);padding:10px 16px;border-radius:0 8px 8px 0}
.notice ul{margin:0}
.cards{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,330px),1fr));gap:16px}
.card,figure,.box{background:var(--card);border:1px solid var(--rule);border-radius:12px}
.card{padding:18px 20px;break-inside:avoid}
.card h3{margin:8px 0 8px;font-size:17px;line-height:1.35}
.card p{font-size:14.5px;margin-bottom:8px}
.card .large{font-size:34px;line-height:1.1;font-weight:650;letter-spacing:-.02em;margin:2px 0 10px}
.wins small{display:block;color:var(--faint);padding-left:18px}
.chip{display:inline-block;font-size:12.5px;font-weight:600;border-radius:99px;padding:2px 11px;
border:1px solid currentColor}
.yes{color:var(--yes)}.no{color:var(--no)}.open{color:var(--open)}.plain{color:var(--faint)}
details{font-size:14px}
summary{cursor:pointer;color:var(--link)}
details table{margin-top:8px}
.scroll{overflow-x:auto;background:var(--card);border:1px solid var(--rule);border-radius:12px;padding:4px 8px}
table{border-collapse:collapse;font-size:13.5px;font-variant-numeric:tabular-nums}
.scroll>table{min-width:100%}
th,td{padding:5px 9px;text-align:right;white-space:nowrap;font-weight:400}
thead th{color:var(--faint);border-bottom:1px solid var(--rule)}
thead th.group{text-align:center;color:var(--ink);font-weight:600;border-left:1px solid var(--rule)}
.left,tbody th{text-align:left}
tbody th{position:sticky;left:0;background:var(--card)}
tr.section th,tr.section td{border-top:1px solid var(--rule)}
tr.theirs th,tr.theirs td{color:var(--faint)}
tr.theirs th{padding-left:24px}
.best{font-weight:700;color:var(--yes)}
.wins td{text-align:left}
.wins b{font-weight:650}
.dot{display:inline-block;width:11px;height:11px;border-radius:3px;margin-right:7px}
.box{padding:14px 16px;overflow-x:auto;margin:14px 0}
.box svg{display:block;width:100%;min-width:620px;height:auto}
.two .box svg{min-width:440px}
.two{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,480px),1fr));gap:16px}
.gallery{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,300px),1fr));gap:16px}
figure{margin:0;overflow:hidden;break-inside:avoid}
figure img{display:block;width:100%;height:auto}
figcaption{padding:10px 14px 14px;font-size:14px;color:var(--faint)}
figcaption b{color:var(--ink);font-size:16px;margin-right:8px}
footer{margin-top:56px;padding-top:16px;border-top:1px solid var(--rule)}
@media (max-width:600px){header{padding-top:32px}h2{font-size:22px}.lead{font-size:17px}main{padding:0 14px 40px}}
@media print{
"""
    + f":root{{color-scheme:light;{variables(LIGHT)}{PAGE_LIGHT}--back:#fff}}"
    + """
body{font-size:10.5pt}nav,summary{display:none}main{max-width:none;padding:0}header{padding-top:0}
h2,h3{break-after:avoid}.scroll,.box{overflow:visible;break-inside:avoid}table{font-size:7pt}th,td{padding:2px 3px}
.box svg{min-width:0}tbody th{position:static}.gallery{grid-template-columns:repeat(3,1fr)}
}
"""
)
