// SPDX-License-Identifier: Apache-2.0
#include "io/encode.h"

#include "io/error.h"
#include "io/one_line.h"
#include "lume_version.h"

#include <OpenImageIO/filesystem.h>

namespace lume::io {

Bytes encode(const std::string& format, const OIIO::ImageSpec& spec, const std::string& name,
             const std::function<bool(OIIO::ImageOutput&)>& write) {
  const auto fail = [&](const std::string& reason) {
    throw Error(ErrorKind::input_output, name, "", one_line("cannot encode: " + reason));
  };
  Bytes bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create(format);
  if (!output) fail(OIIO::geterror());
  if (!output->set_ioproxy(&memory)) fail("the writer of " + format + " cannot write to memory");
  if (!output->open("picture." + format, spec)) fail(output->geterror());
  if (!write(*output) || !output->close()) fail(output->geterror());
  return bytes;
}

std::string software_name() { return "Lume " + std::string(k_version); }

}  // namespace lume::io
