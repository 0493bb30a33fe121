// Any bytes as a recording: read as text, compared with themselves and with a part of themselves.
#include "fc.h"

#include <cstdlib>

namespace {

void ignore_line(void *, const char *) {}
void ignore_divergence(void *, const fc_divergence *) {}
void ignore_error(void *, const fc_error *) {}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fc_set_error_callback(nullptr, ignore_error, nullptr);
    const int text = fc_record_text(data, size, ignore_line, nullptr);
    const int same = fc_compare(data, size, data, size, nullptr, ignore_divergence, nullptr);
    if ((text == FC_OK) != (same >= 0) || same > 0)
        std::abort(); // both readers agree, and nothing differs from itself
    fc_compare(data, size, data, size / 2, nullptr, ignore_divergence, nullptr);
    return 0;
}
