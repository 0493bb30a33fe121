/* FC_SEED gives the default context's seed; the test is run with it set to the argument. */
#define _POSIX_C_SOURCE 200809L
#include "check.h"
#include "fc.h"

#include <stdlib.h>

static uint64_t bits_after_seed(fc_context *ctx) {
    double value = 0;
    uint64_t bits;
    fc_add_bitflip_random(ctx, "p");
    for (int call = 0; call < 32; call++)
        fc_probe_f64(ctx, "p", &value);
    memcpy(&bits, &value, 8);
    return bits;
}

static void expect(const char *text, uint64_t seed) {
    fc_options options = FC_OPTIONS_INIT;
    options.seed = seed;
    setenv("FC_SEED", text, 1);
    fc_context *ctx = fc_new(&options);
    CHECK(bits_after_seed(NULL) == bits_after_seed(ctx));
    fc_reset(NULL); /* returns to the seed of the environment */
    fc_reset(ctx);
    CHECK(bits_after_seed(NULL) == bits_after_seed(ctx));
    fc_free(ctx);
}

int main(int argc, char **argv) {
    if (argc != 3) {
        fprintf(stderr, "usage: %s TEXT SEED\n", argv[0]);
        return 2;
    }
    expect(argv[1], strtoull(argv[2], NULL, 10));
    return CHECK_RESULT();
}
