#pragma once

#include <stdexcept>

namespace ricochet {

/// An error in the user's input. The message is one line that names what is wrong, where, and what
/// is allowed. The command line ends with exit code 2 and has written nothing.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace ricochet
