#pragma once

#include <stdexcept>

namespace ricochet {

/// The user's input is at fault. The message is one line that names what is wrong, where, and what
/// is allowed. The command line ends with exit code 2 and has written nothing.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace ricochet
