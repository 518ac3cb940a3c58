// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace lume::cli {

/// What `lume` tells the shell. Scripts depend on these numbers; they never change meaning.
enum class ExitCode {
  success = 0,
  internal = 1,      ///< out of memory, or a defect of Lume
  usage = 2,         ///< the command line is wrong; nothing was done
  scene = 3,         ///< the scene's content is wrong or not supported
  input_output = 4,  ///< a file cannot be read or written
  non_finite = 6,    ///< the pictures are written, but some samples were infinite or NaN
  disagreement = 7,  ///< structures that should give the same answers do not
  interrupted = 130  ///< stopped by SIGINT or SIGTERM; what was done is written
};

/// The command line asks for something that makes no sense. One line, without the program's name.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace lume::cli
