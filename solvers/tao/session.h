#pragma once

namespace ricochet::tao {

/// PETSc in this process, initialised by the first call and never finalised: silent, without the
/// options of files and environment, with the process's signal handlers as they were, and with an
/// MPI that knows of this process alone and starts no other. Returns whether it is there. To be
/// called by one thread at a time; a process that forks must not have called it before.
bool initialised();

}  // namespace ricochet::tao
