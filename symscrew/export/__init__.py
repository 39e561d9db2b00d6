"""Printers: one small module per target language, over one shared traversal, without algebra.

`symscrew.export.listing` walks a program; `c`, `casadi`, `numpy` and `latex` say how an operation looks.
Nothing here writes files: `symscrew.generation` does.
"""

from typing import TYPE_CHECKING

from symscrew.doors import doors

if TYPE_CHECKING:
    from symscrew.export.c import print_c
    from symscrew.export.c_form import USUAL_FORM, Form, library_sources, readable_sources
    from symscrew.export.c_interface import interface
    from symscrew.export.c_precision import DOUBLE, PRECISIONS, SINGLE, Precision
    from symscrew.export.c_single import rounded, single_errors
    from symscrew.export.casadi import TABLE, casadi_functions, program_function
    from symscrew.export.casadi_external import jacobians_model, print_external
    from symscrew.export.casadi_hessians import hessians_model, print_hessians
    from symscrew.export.cpp import print_cpp
    from symscrew.export.cuda import CUDA_THREADS, print_cuda, print_device
    from symscrew.export.drive_kinematics import DriveKinematics, find_drive_kinematics, tool_name
    from symscrew.export.drive_kinematics_c import axes_text, print_drive_host
    from symscrew.export.example import print_cmake, print_example
    from symscrew.export.hash_file import HASHES, FileHash, file_hash, print_hashes, read_hashes
    from symscrew.export.javascript import print_javascript, print_script
    from symscrew.export.jax import print_jax
    from symscrew.export.linuxcnc import print_linuxcnc
    from symscrew.export.listing import banner, decimal, live_instructions, model_hash, packed, plain, wrapped
    from symscrew.export.manifest_file import (
        OutputError,
        effect_from_json,
        manifest,
        read_form,
        read_json,
        read_port,
    )
    from symscrew.export.markdown import print_markdown
    from symscrew.export.modelica import print_modelica
    from symscrew.export.numpy import print_numpy
    from symscrew.export.pivots import pivot_text
    from symscrew.export.readme import print_readme
    from symscrew.export.reduced import configuration_function, ode_function, print_reduced
    from symscrew.export.reload_limit import SPILLS
    from symscrew.export.ros2 import print_ros2
    from symscrew.export.rust import print_rust
    from symscrew.export.rust_names import RustNames
    from symscrew.export.simulink import print_simulink
    from symscrew.export.structured_text import block_ports, print_structured_text
    from symscrew.export.structured_text_drives import print_structured_text_drives
    from symscrew.export.written_folder import MANIFEST, own_files, read_manifest

__all__ = [
    "CUDA_THREADS",
    "DOUBLE",
    "HASHES",
    "MANIFEST",
    "PRECISIONS",
    "SINGLE",
    "SPILLS",
    "TABLE",
    "USUAL_FORM",
    "DriveKinematics",
    "FileHash",
    "Form",
    "OutputError",
    "Precision",
    "RustNames",
    "axes_text",
    "banner",
    "block_ports",
    "casadi_functions",
    "configuration_function",
    "decimal",
    "effect_from_json",
    "file_hash",
    "find_drive_kinematics",
    "hessians_model",
    "interface",
    "jacobians_model",
    "library_sources",
    "live_instructions",
    "manifest",
    "model_hash",
    "ode_function",
    "own_files",
    "packed",
    "pivot_text",
    "plain",
    "print_c",
    "print_cmake",
    "print_cpp",
    "print_cuda",
    "print_device",
    "print_drive_host",
    "print_example",
    "print_external",
    "print_hashes",
    "print_hessians",
    "print_javascript",
    "print_jax",
    "print_linuxcnc",
    "print_markdown",
    "print_modelica",
    "print_numpy",
    "print_readme",
    "print_reduced",
    "print_ros2",
    "print_rust",
    "print_script",
    "print_simulink",
    "print_structured_text",
    "print_structured_text_drives",
    "program_function",
    "read_form",
    "read_hashes",
    "read_json",
    "read_manifest",
    "read_port",
    "readable_sources",
    "rounded",
    "single_errors",
    "tool_name",
    "wrapped",
]

__getattr__ = doors(__name__)
