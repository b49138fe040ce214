#!/usr/bin/env python3
"""Whether the answers that a page of documentation quotes from the studies' pages are what those pages say: in a table's row that
links to one, each further cell but the first must be a sentence of that page; and every study's page is linked to."""

import argparse
import pathlib
import re
import sys


def sentences_of(page):
    return {line[2:].strip() for line in page.read_text().splitlines() if line.startswith("- ")}


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("page", type=pathlib.Path)
    options.add_argument("--studies", type=pathlib.Path, required=True, help="folder of the studies' pages")
    given = options.parse_args()
    wrong, linked = [], set()
    for number, line in enumerate(given.page.read_text().splitlines(), 1):
        link = re.search(r"\]\((?:docs/studies/)?(\w+)\.md\)", line)
        if not line.startswith("|") or link is None or not (given.studies / f"{link[1]}.md").exists():
            continue
        linked.add(link[1])
        said = sentences_of(given.studies / f"{link[1]}.md")
        for cell in [cell.strip() for cell in line.strip("|").split("|")][1:]:
            if cell not in said:
                wrong.append(f"{given.page.name}:{number}: {link[1]}.md does not say: {cell}")
    for study in sorted(given.studies.glob("*.csv")):
        if study.stem not in linked:
            wrong.append(f"{given.page.name}: nothing leads to {study.stem}.md")
    print("\n".join(wrong) if wrong else f"{len(linked)} pages are quoted as they are")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
