#pragma once

namespace ricochet {

/// Lets this process open so many files, pipes and sockets besides those that it has open. Throws
/// OutputError with the system's limit if that is too low.
void allow_further_open_files(int number);

/// From now on nothing can be read from this descriptor, and what is written to it is lost.
void lead_nowhere(int descriptor);

}  // namespace ricochet
