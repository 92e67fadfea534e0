"""SVG by hand: elements as text, and the colours that all charts share."""

from html import escape

from raywalk.study.names import BVH, EMBREE, GRID, KDT2, KDT3, PER_RAY

CLASSES = {GRID: "c-grid", KDT3: "c-kdt3", KDT2: "c-kdt2", BVH: "c-bvh", PER_RAY: "c-ray", EMBREE: "c-embree"}
LIGHT = {
    "ink": "#1d2129",
    "faint": "#697180",
    "rule": "#dde1e8",
    "paper": "#ffffff",
    "grid": "#d97706",
    "kdt3": "#5eb5a6",
    "kdt2": "#0f766e",
    "bvh": "#1d4ed8",
    "ray": "#7c9cf5",
    "embree": "#9aa1ad",
}
DARK = {
    "ink": "#e8eaf0",
    "faint": "#9aa3b2",
    "rule": "#333a47",
    "paper": "#14171d",
    "grid": "#f59e0b",
    "kdt3": "#8fd6c9",
    "kdt2": "#2bb3a3",
    "bvh": "#5b8cff",
    "ray": "#a9c0ff",
    "embree": "#737b89",
}
MOST_GROWN = 1.3  # in a wide page
RULES = (
    "svg text{font-family:system-ui,sans-serif;fill:var(--ink);font-size:12px}"
    "svg .small{font-size:11px;fill:var(--faint)}svg .heading{font-size:14px;font-weight:600}"
    "svg .rule{stroke:var(--rule);stroke-width:1}svg .base{stroke:var(--faint);stroke-dasharray:4 4}"
    "svg .mark{stroke:var(--ink);stroke-width:2}svg .line{fill:none;stroke-width:2.5}"
) + "".join(
    f".{name}{{fill:var(--{name[2:]})}}.line.{name},.whisker.{name}{{stroke:var(--{name[2:]});fill:none}}"
    for name in CLASSES.values()
)


def variables(colours: dict[str, str]) -> str:
    return "".join(f"--{name}:{value};" for name, value in colours.items())


def standalone_style() -> str:
    """For a file of its own: the same colours, light or dark as the reader has it."""
    dark = f"@media (prefers-color-scheme:dark){{svg{{{variables(DARK)}}}}}"
    return f"<style>svg{{{variables(LIGHT)}background:var(--paper)}}{dark}{RULES}</style>"


def element(name: str, inner: str = "", **attributes: object) -> str:
    """`inner` is markup; attributes are escaped, and a trailing underscore of their names is dropped."""
    given = "".join(f' {key.rstrip("_").replace("_", "-")}="{escape(show(one))}"' for key, one in attributes.items())
    return f"<{name}{given}>{inner}</{name}>" if inner else f"<{name}{given}/>"


def show(value: object) -> str:
    return f"{value:.1f}" if isinstance(value, float) else str(value)


def words(x: float, y: float, text: str, anchor: str = "start", class_: str = "") -> str:
    attributes = {"class_": class_} if class_ else {}
    return element("text", escape(text), x=x, y=y, text_anchor=anchor, **attributes)


def line(x1: float, y1: float, x2: float, y2: float, class_: str) -> str:
    return element("line", x1=x1, y1=y1, x2=x2, y2=y2, class_=class_)


def tip(text: str) -> str:
    """What a reader sees who points at the element."""
    return element("title", escape(text))


def document(width: float, height: float, body: str, title: str, standalone: bool = False) -> str:
    """`standalone` is for a file of its own; in a page the page's style holds."""
    inner = element("title", escape(title)) + (standalone_style() if standalone else "") + body
    attributes = {"xmlns": "http://www.w3.org/2000/svg", "viewBox": f"0 0 {width:.0f} {height:.0f}", "role": "img"}
    own = {"width": f"{width:.0f}", "height": f"{height:.0f}"}
    size = own if standalone else {"style": f"max-width:{MOST_GROWN * width:.0f}px"}
    return element("svg", inner, **attributes, **size)
