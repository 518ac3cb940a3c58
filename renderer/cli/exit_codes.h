// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace lume::cli {

/// What `lume` tells the shell. Scripts depend on these numbers; they never change meaning.
enum class ExitCode {
  success = 0,
  differs = 1,       ///< images differ, an image test failed, a check found what it was to fail on
  usage = 2,         ///< the command line is wrong; nothing was done
  scene = 3,         ///< the scene's content is wrong or not supported
  input_output = 4,  ///< a file cannot be read or written
  size = 5,          ///< images of different size are not compared
  non_finite = 6,    ///< infinite or NaN: samples of the pictures that were written, or values of
                     ///< images that are not compared for it
  disagreement = 7,  ///< structures that should give the same answers do not
  channels = 8,      ///< images of different channels are not compared
  data_window = 9,   ///< nor are those of different data windows
  internal = 70,     ///< out of memory, or a defect of Lume
  skipped = 77,      ///< no test ran
  interrupted = 130  ///< stopped by SIGINT or SIGTERM; what was done is written
};

/// The command line asks for something that makes no sense. One line, without the program's name.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace lume::cli
