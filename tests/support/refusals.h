#pragma once

#include "ricochet/error.h"
#include "tests/support/test.h"

namespace ricochet {

/// What an error of this type says that `call` ends with; "accepted" where it ends with none.
template <class Error = InputError, class Call>
std::string complaint_of(const Call& call) {
  try {
    static_cast<void>(call());
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

/// An input that a reader must refuse, and what its message holds.
template <class Input = std::string>
struct Refusal {
  Input input;
  std::string message;
};

/// Expects that `read` refuses each input with an error of this type, whose message holds the text
/// beside the input.
template <class Error = InputError, class Input = std::string, class Read>
void expect_refusals(const Read& read, const std::vector<Refusal<Input>>& refusals) {
  for (const auto& refusal : refusals) {
    EXPECT_THAT(complaint_of<Error>([&] { return read(refusal.input); }),
                HasSubstr(refusal.message))
        << testing::PrintToString(refusal.input);
  }
}

}  // namespace ricochet
