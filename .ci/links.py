"""Whether whatever the pages of a folder link to or show is there, with its anchor. Nothing is fetched: what is elsewhere, is."""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    """The anchors of a page, and where it leads."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.anchors: set[str] = set()
        self.targets: set[str] = set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        for name, value in attrs:
            if name in ("id", "name") and value:
                self.anchors.add(value)
            if name in ("href", "src") and value:
                self.targets.add(value)


folder = Path(sys.argv[1])
pages = {path.resolve(): Page(path) for path in sorted(folder.rglob("*.html"))}
dead = []
for path, page in pages.items():
    for target in sorted(page.targets):
        there = urlsplit(target)
        # The page of what is not found begins at the root of a server.
        if there.scheme or there.netloc or path.name == "404.html":
            continue
        file = (path.parent / unquote(there.path)).resolve() if there.path else path
        anchor = unquote(there.fragment)
        if not file.exists():
            dead.append(f"{path.name}: {target} is not there")
        elif anchor and file in pages and anchor not in pages[file].anchors:
            dead.append(f"{path.name}: {target} has no such anchor")
print(f"{len(pages)} pages, {sum(len(page.targets) for page in pages.values())} links, {len(dead)} of them dead")
if dead or not pages:
    sys.exit("\n".join(dead))
