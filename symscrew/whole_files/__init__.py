"""Files and folders that are there whole or not at all, whenever a process that writes them is killed.

staging       a place beside, held by a lock as long as its process lives; what dead ones left is removed
one_file      a file made there and moved
whole_folder  a folder made there and exchanged, or moved file by file behind a marker that readers finish
given_file    a file that is read, and no pipe or device
turns         one process at a time
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.whole_files.given_file import only_file
    from symscrew.whole_files.one_file import created, destination, replaced, write_text
    from symscrew.whole_files.staging import discard, is_staging, remove_abandoned, stage
    from symscrew.whole_files.turns import LockedError, one_at_a_time
    from symscrew.whole_files.whole_folder import PENDING, finish, made_together, put_files

__all__ = [
    "PENDING",
    "LockedError",
    "created",
    "destination",
    "discard",
    "finish",
    "is_staging",
    "made_together",
    "one_at_a_time",
    "only_file",
    "put_files",
    "remove_abandoned",
    "replaced",
    "stage",
    "write_text",
]

__getattr__ = doors(__name__)
