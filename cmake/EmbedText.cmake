# SPDX-License-Identifier: Apache-2.0
# Writes a text file as a C++ constant:
#   cmake -D INPUT=file -D OUTPUT=file.cpp -D NAMESPACE=a::b -D NAME=k_name -P EmbedText.cmake

file(READ "${INPUT}" text)
string(FIND "${text}" ")lume_text\"" end_marker)
if(NOT end_marker EQUAL -1)
  message(FATAL_ERROR "${INPUT} holds the end marker of the string that it would become")
endif()
file(
  WRITE "${OUTPUT}"
  "#include <string_view>

namespace ${NAMESPACE} {
extern const std::string_view ${NAME};
const std::string_view ${NAME} = R\"lume_text(${text})lume_text\";
}  // namespace ${NAMESPACE}
")
