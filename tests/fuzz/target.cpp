// What libFuzzer calls: the format is named by the build, one program each.
#include "tests/fuzz/formats.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const raywalk::Format& format = raywalk::fuzz::format_named(RAYWALK_FUZZ_TARGET);
  raywalk::fuzz::try_load(format, {data, size});
  return 0;
}
