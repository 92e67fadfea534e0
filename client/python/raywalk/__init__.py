"""Client of the Raywalk daemon: scenes, structures, frames, rays and benchmarks over HTTP."""
