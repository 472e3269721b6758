#pragma once

namespace ricochet {

/// Lets this process have so many files, pipes and sockets open at once. Throws OutputError with
/// the system's limit if that is lower.
void allow_open_files(int number);

/// From now on nothing can be read from this descriptor, and what is written to it is lost.
void lead_nowhere(int descriptor);

}  // namespace ricochet
