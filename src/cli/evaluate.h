#pragma once

#include <string>

namespace ricochet::cli {

struct EvaluateOptions {
  std::string question;
  std::string scene_file;    ///< asked of this machine; empty for the paper's and the literature's
  std::string form;          ///< its name; empty: as it is judged
  int instance = 0;          ///< 0: the question as stated
  bool derivatives = false;  ///< tell them, too, where a line does not say
  bool replay = false;       ///< evaluate every point twice, and compare
  bool describe = false;     ///< say what is asked, and evaluate nothing
};

/// Evaluates the question for an optimiser outside: a line of JSON on standard input for each
/// point, a line of JSON on standard output with what there is to say of it. Returns the exit code:
/// 1 where a line was bad, or where a point evaluated twice had two answers.
int evaluate(const EvaluateOptions& options);

}  // namespace ricochet::cli
