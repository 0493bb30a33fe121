/* stub_callback.h: how a stub that is compiled into a library under test asks Erlang for its
 * answer.
 *
 * The port program exports cb_stub_call(). It sends `{0, callback, Name, Args}` and waits for
 * `{callback, Value}`. If Value does not fit what the stub asks for, the call of the library
 * function that led to the stub ends with
 * `{callback, Name, {bad_type | out_of_range, CType, Value}}` and does not return to the stub.
 * Threads: only the thread that serves the port may come here. */
#ifndef CB_STUB_CALLBACK_H
#define CB_STUB_CALLBACK_H

#ifdef __cplusplus
extern "C" {
#endif

enum cb_stub_kind {
    CB_STUB_VOID = 0,
    CB_STUB_SIGNED = 1,   /* as.i */
    CB_STUB_UNSIGNED = 2, /* as.u */
    CB_STUB_FLOAT = 3,    /* as.d */
    CB_STUB_POINTER = 4,  /* as.p; seen as `null` or {ptr, void, Ref} */
    CB_STUB_STRING = 5, /* as.p, arguments only: NUL-terminated, seen as a binary, NULL as `null` */
    CB_STUB_BOOL = 6    /* as.u; `true` or `false` */
};

struct cb_stub_value {
    int kind;
    unsigned size; /* bytes of the C type, for the range of integers: 1, 2, 4 or 8 */
    union {
        long long i;
        unsigned long long u;
        double d;
        const void *p;
    } as;
};

/* `result`: kind and size say what is wanted, `as` is filled in. */
void cb_stub_call(const char *name, const struct cb_stub_value *args, int count,
                  struct cb_stub_value *result);

#ifdef __cplusplus
}
#endif

#endif
