"""The wireframes of all clouds of a folder, on several machines, with Dask.
 Without --scheduler, workers are started on this machine. A cloud that has its wireframe already is skipped, and the
cloud of a worker that dies goes to another one: nothing is lost, also if this program is stopped and started again.
"""

import argparse
import collections
import os
import pathlib
import sys

import distributed

import wireframe_extraction


def extract(cloud, output):
    """Writes one wireframe. It runs on a worker, which has to see both folders."""
    wireframe = wireframe_extraction.extract(cloud, threads=1)
    beside = f"{output}.{os.getpid()}.json"
    wireframe.write(beside)
    os.replace(beside, output)   # so that no other worker, nor the next run, sees half of it
    return len(wireframe.curves)


def outputs_of(clouds, folder):
    """Returns the file of each wireframe: a.json for a.ply, but a.ply.json where there is a.stl as well."""
    stems = collections.Counter(cloud.stem for cloud in clouds)
    return {cloud: folder / f"{cloud.stem if stems[cloud.stem] == 1 else cloud.name}.json" for cloud in clouds}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("input", type=pathlib.Path, help="the folder of the clouds")
    parser.add_argument("output", type=pathlib.Path, help="the folder of the wireframes")
    parser.add_argument("--pattern", default="*.ply", help="which files are clouds (default %(default)s)")
    parser.add_argument("--scheduler", help="the address of a running scheduler, tcp://HOST:8786")
    parser.add_argument("--workers", type=int, default=2, help="how many are started without one (default %(default)s)")
    arguments = parser.parse_args()

    clouds = outputs_of(sorted(arguments.input.glob(arguments.pattern)), arguments.output)
    if not clouds:
        parser.error(f"{arguments.input} has no {arguments.pattern}" if arguments.input.is_dir()
                     else f"there is no folder {arguments.input}")
    arguments.output.mkdir(parents=True, exist_ok=True)
    todo = {cloud: output for cloud, output in clouds.items() if not output.exists()}
    print(f"{len(clouds)} clouds, {len(clouds) - len(todo)} of them done before")
    if not todo:
        return 0

    if arguments.scheduler:
        client = distributed.Client(arguments.scheduler)
    else:
        client = distributed.Client(n_workers=arguments.workers, threads_per_worker=1, dashboard_address=None)
    number_of_failed = 0
    with client:
        futures = {client.submit(extract, str(cloud.resolve()), str(output.resolve()), pure=False): cloud
                   for cloud, output in todo.items()}
        for future in distributed.as_completed(futures):
            error = future.exception()
            number_of_failed += error is not None
            result = f"{future.result()} curves" if error is None else f"failed: {error}"
            print(f"{futures[future].name}: {result}", flush=True)
    return 1 if number_of_failed > 0 else 0


if __name__ == "__main__":
    sys.exit(main())
