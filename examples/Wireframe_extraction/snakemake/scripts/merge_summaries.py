"""Makes one table of those of the jobs; Snakemake calls this."""

import csv
import pathlib
import sys

header, rows = None, []
for name in snakemake.input.tables:
    with open(name, newline="", encoding="utf-8") as stream:
        table = list(csv.reader(stream))
    if header not in (None, table[0]):
        sys.exit(f"{name}: has other columns than the parts before; remove it, and run this again")
    header = table[0]
    rows += table[1:]
if len(rows) != snakemake.params.number_of_clouds:
    sys.exit(f"{snakemake.input.list}: names {snakemake.params.number_of_clouds} clouds, but its parts have {len(rows)} rows; "
             "run this again with --forcerun extract")
with open(snakemake.output[0], "w", newline="", encoding="utf-8") as stream:
    csv.writer(stream, lineterminator="\n").writerows([header] + rows)
failed = sum(row[header.index("status")] == "failed" for row in rows)
print(f"{len(rows)} clouds, {failed} of them failed: see {snakemake.output[0]}")
