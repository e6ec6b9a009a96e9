"""Lists the clouds of a folder, or takes over a list; Snakemake calls this."""

import os
import pathlib
import sys


def line_of(folder, path):
    """A cloud as a line of a list, in which not every name can stand."""
    name = str(path)
    if name != name.strip() or "\n" in name or "\r" in name:
        sys.exit(f"{folder / path}: names with line breaks, or blanks at their ends, cannot be listed; rename it")
    return "./" + name if name.startswith("#") else name


def clouds_of_folder(folder, extensions):
    endings = {"." + extension.lower().lstrip(".") for extension in extensions}
    names, visited = [], set()
    for place, folders, files in os.walk(folder, followlinks=True):
        if os.path.realpath(place) in visited:   # links may lead in circles
            folders.clear()
            continue
        visited.add(os.path.realpath(place))
        folders[:] = [name for name in folders if not name.startswith(".")]
        paths = (pathlib.Path(place, name) for name in files)
        names += [path.relative_to(folder) for path in paths if path.suffix.lower() in endings]
    if not names:
        sys.exit(f"{folder}: there is no cloud in this folder, nor below it; known are " + " ".join(sorted(endings)))
    return sorted(line_of(folder, path) for path in names)


clouds = pathlib.Path(snakemake.params.clouds)
if clouds.is_dir():
    text = "".join(line + "\n" for line in clouds_of_folder(clouds, snakemake.params.extensions))
else:
    text = clouds.read_text(encoding="utf-8-sig")
pathlib.Path(snakemake.output[0]).write_text(text, encoding="utf-8")
