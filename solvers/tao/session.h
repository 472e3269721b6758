#pragma once

namespace ricochet::tao {

/// Initialises PETSc on the first call; it is never finalised. PETSc prints nothing, reads no
/// options from files or the environment, leaves the process's signal handlers as they were, and
/// its MPI knows this process only and starts no other. Returns whether PETSc is available. Only
/// one thread at a time may call this; a process that forks must not have called it before.
bool initialised();

}  // namespace ricochet::tao
