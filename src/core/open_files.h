#pragma once

namespace ricochet {

/// Lets this process have so many files, pipes and sockets open at once. Throws OutputError with
/// the system's limit if that is lower.
void allow_open_files(int number);

}  // namespace ricochet
