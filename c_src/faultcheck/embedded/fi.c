/* fi.c: the probes, the table of faults, and the text commands. */
#include "fi.h"
#include <stddef.h>
#include <stdint.h>

typedef char fi_needs_32_bit_int_and_float[sizeof(int) == 4 && sizeof(float) == 4 ? 1 : -1];

/* What probes and terminal share is read and written whole, and ordered by fences. */
#define LOAD(variable) __atomic_load_n(&(variable), __ATOMIC_RELAXED)
#define STORE(variable, value) __atomic_store_n(&(variable), (value), __ATOMIC_RELAXED)
#define FENCE() __atomic_thread_fence(__ATOMIC_ACQ_REL)

enum { NONE, BITFLIP, OFFSET, AMPLIFICATION, SET_TO, TYPES };
static const char type_names[TYPES][14] = {"NONE", "BITFLIP", "OFFSET", "AMPLIFICATION", "SET_TO"};

typedef union {
    float real;
    int whole;
    uint32_t bits;
} cell;

typedef struct {
    cell param; /* of BITFLIP: the bit to be flipped */
    uint32_t start, duration;
    uint32_t digits; /* the parameter as it was written: digits * 10^exponent, and the sign */
    int8_t exponent;
    bool negative;
    uint8_t type;
} fault;

/* Each member has one writer: `calls` the probe, all else the terminal. */
typedef struct {
    char id[FI_ID_BYTES]; /* filled up with 0 */
    uint32_t calls, base; /* the counter is calls - base; it stops at its end */
    uint32_t faults;      /* how many are valid; written last. 0: the entry is free */
    fault fault[FI_FAULTS];
} probe;

static probe probes[FI_PROBES];
static uint32_t enabled;
static uint32_t epoch; /* changes before an entry can be written again */

typedef struct {
    const char *at, *end;
} word;

/* The identifier ends at `end` or at 0. */
static probe *find(const char *id, const char *end) {
    for (probe *p = probes; p < probes + FI_PROBES; p++) {
        const uint32_t faults = LOAD(p->faults);
        const char *c = id;
        int i = 0;
        FENCE();
        for (; i < FI_ID_BYTES && LOAD(p->id[i]) == (c != end ? *c : '\0'); i++)
            c += c != end && *c != '\0';
        if (faults > 0 && i == FI_ID_BYTES && (c == end || *c == '\0'))
            return p;
    }
    return NULL;
}

static uint32_t counter(const probe *p) {
    return LOAD(p->calls) - LOAD(p->base);
}

/* Computed in double: for a float, one rounding at the end gives what float arithmetic would. */
static void apply(uint32_t type, cell param, bool is_float, cell *value) {
    const double x = is_float ? (double)value->real : value->whole;
    const double y = type == OFFSET ? x + param.real : type == SET_TO ? param.real : x * param.real;
    if (type == BITFLIP)
        value->bits ^= param.bits;
    else if (type != NONE && is_float)
        value->real = (float)y;
    else if (type != NONE)
        value->whole = y >= INT32_MAX ? INT32_MAX : y <= INT32_MIN ? INT32_MIN : (int)y;
}

/* Whether *value is to be stored. */
static bool inject(const char *id, bool is_float, cell *value) {
    const uint32_t now = LOAD(epoch);
    FENCE();
    probe *p = LOAD(enabled) && id != NULL ? find(id, NULL) : NULL;
    const uint32_t faults = p != NULL ? LOAD(p->faults) : 0;
    FENCE();
    if (faults == 0 || LOAD(epoch) != now)
        return false;
    const uint32_t call = counter(p);
    if (call < UINT32_MAX)
        STORE(p->calls, p->calls + 1);
    for (const fault *f = p->fault; f < p->fault + faults; f++) {
        const cell param = {.bits = LOAD(f->param.bits)};
        const uint32_t type = LOAD(f->type), start = LOAD(f->start), duration = LOAD(f->duration);
        FENCE();
        if (LOAD(epoch) != now)
            break; /* cleared meanwhile: what was read may be of two faults */
        if (call >= start && (duration == 0 || call - start < duration))
            apply(type, param, is_float, value);
    }
    return true;
}

void fi_inject_fault_float(const char *id, float *value) {
    cell x = {.real = value != NULL ? *value : 0};
    if (value != NULL && inject(id, true, &x))
        *value = x.real;
}

void fi_inject_fault_int(const char *id, int *value) {
    cell x = {.whole = value != NULL ? *value : 0};
    if (value != NULL && inject(id, false, &x))
        *value = x.whole;
}

bool fi_is_active(void) {
    return LOAD(enabled) != 0;
}

/* Goes over digits, which what follows a word is not; keeps nine, or ten up to 3999999999. Returns
 * how many there were. */
static int parse_digits(const char **at, uint32_t *digits, int *exponent, int behind_point) {
    int n = 0;
    for (uint32_t digit; (digit = (uint32_t)(**at - '0')) < 10; ++*at, n++) {
        const int keep = *digits < 400000000;
        *digits = keep ? 10 * *digits + digit : *digits;
        *exponent += !keep - behind_point;
    }
    return n;
}

/* Digits that mean at most 2147483647. */
static bool parse_int(word text, uint32_t *n) {
    int exponent = 0;
    *n = 0;
    const bool any = parse_digits(&text.at, n, &exponent, 0) > 0;
    return any && text.at == text.end && exponent == 0 && *n <= INT32_MAX;
}

/* [+-]digits[.digits][e[+-]digits], within float. */
static bool parse_param(word text, uint32_t type, fault *f, cell *param) {
    int exponent = 0, shift_exponent = 0;
    uint32_t shift = 0;
    double power = 1;
    f->negative = *text.at == '-';
    f->digits = 0;
    text.at += f->negative || *text.at == '+';
    int n = parse_digits(&text.at, &f->digits, &exponent, 0);
    if (*text.at == '.')
        text.at++, n += parse_digits(&text.at, &f->digits, &exponent, 1);
    if (n > 0 && (*text.at | 32) == 'e') {
        const bool down = *++text.at == '-';
        text.at += down || *text.at == '+';
        n = parse_digits(&text.at, &shift, &shift_exponent, 0);
        exponent += (down ? -1 : 1) * (int)(shift < 100000000 ? shift : 100000000);
    }
    f->exponent = (int8_t)(exponent > 99 ? 99 : exponent < -99 ? -99 : exponent);
    for (int i = 0; i != f->exponent && i != -f->exponent; i++)
        power *= 10;
    const double x = exponent < 0 ? f->digits / power : f->digits * power;
    if (n == 0 || text.at != text.end || x >= 0x1.ffffffp127)
        return false;
    param->real = (float)(f->negative ? -x : x);
    if (type == BITFLIP)
        param->bits = UINT32_C(1) << (f->negative ? 0 : x >= 31 ? 31 : (int)x);
    return true;
}

/* A line and its replies. */
typedef struct {
    void (*reply)(const char *);
    word words[8];   /* the command, at most five that belong to it, one too many, the end */
    const word *bad; /* what an error is about */
    size_t length;
    char text[FI_ID_BYTES + 100]; /* holds each line of fi_print_faults; an error may be cut off */
} line;

static void put_bytes(line *l, const char *at, const char *end) {
    while (at != end && *at != '\0' && l->length + 1 < sizeof l->text)
        l->text[l->length++] = *at++;
}
#define put(l, text) put_bytes(l, text, NULL)

static void send(line *l) {
    l->text[l->length] = '\0';
    if (l->reply != NULL)
        l->reply(l->text);
    l->length = 0;
}

/* The number behind a name, with zeros in front up to `width` digits. */
static void put_number(line *l, const char *name, uint32_t n, int width) {
    char digits[10];
    char *const end = digits + sizeof digits, *first = end;
    for (; n > 0 || width > 0; n /= 10, width--)
        *--first = (char)('0' + n % 10);
    put(l, name);
    put_bytes(l, first, end);
}

static void put_param(line *l, const fault *f) {
    uint32_t power = 1;
    for (int i = f->exponent; i < 0 && f->exponent >= -9; i++)
        power *= 10;
    put_number(l, f->negative ? " param=-" : " param=", f->digits / power, 1);
    if (power > 1)
        put_number(l, ".", f->digits % power, -f->exponent);
    else if (f->exponent != 0)
        put_number(l, f->exponent < 0 ? "e-" : "e",
                   (uint32_t)(f->exponent < 0 ? -f->exponent : f->exponent), 1);
}

/* A name ends at a space. mask: the bits of each byte that count. */
static bool equals(word text, const char *name, int mask) {
    while (text.at != text.end && (*text.at & mask) == *name && *name != '\0')
        text.at++, name++;
    return text.at == text.end && (*name == '\0' || *name == ' ');
}

/* Commands: the result is NULL, or what was expected in place of *l->bad. */
static const char *set_enabled(line *l) {
    const word on = *(l->bad = &l->words[1]);
    if (on.end - on.at != 1 || (*on.at | 1) != '1')
        return "0 or 1";
    STORE(enabled, *on.at & 1u);
    return NULL;
}

static const char *add_fault(line *l) {
    const word id = *(l->bad = &l->words[1]);
    uint32_t type = NONE, start, duration;
    cell param;
    probe *p = find(id.at, id.end);
    for (probe *q = probes; p == NULL && q < probes + FI_PROBES; q++)
        p = q->faults == 0 ? q : NULL;
    if (id.end - id.at > FI_ID_BYTES)
        return "a shorter identifier";
    if (p == NULL)
        return "a free probe slot";
    if (p->faults == FI_FAULTS)
        return "a free fault slot";
    fault *f = &p->fault[p->faults];
    for (l->bad++; !equals(*l->bad, type_names[type], type == NONE ? 0xdf : 0xff);)
        if (++type == TYPES)
            return "NONE, BITFLIP, OFFSET, AMPLIFICATION or SET_TO";
    if (!parse_param(*++l->bad, type, f, &param))
        return "a decimal float";
    if (!parse_int(*++l->bad, &start) || !parse_int(*++l->bad, &duration))
        return "0..2147483647";
    if (p->faults == 0) {
        for (ptrdiff_t i = 0; i < FI_ID_BYTES; i++)
            STORE(p->id[i], i < id.end - id.at ? id.at[i] : '\0');
        STORE(p->base, LOAD(p->calls));
    }
    if (start + duration > UINT32_MAX - counter(p))
        return "fi_reset_cnt first";
    STORE(f->param.bits, param.bits);
    STORE(f->type, (uint8_t)type);
    STORE(f->start, counter(p) + start);
    STORE(f->duration, duration);
    FENCE();
    STORE(p->faults, p->faults + 1);
    return NULL;
}

static const char *clear_faults(line *l) {
    (void)l;
    for (probe *p = probes; p < probes + FI_PROBES; p++)
        STORE(p->faults, 0);
    FENCE();
    STORE(epoch, epoch + 1);
    FENCE();
    return NULL;
}

static const char *reset_cnt(line *l) {
    (void)l;
    for (probe *p = probes; p < probes + FI_PROBES; p++)
        STORE(p->base, LOAD(p->calls));
    return NULL;
}

static const char *print_faults(line *l) {
    for (const probe *p = probes; p < probes + FI_PROBES; p++)
        for (const fault *f = p->fault; f < p->fault + p->faults; f++) {
            put(l, "probe=");
            put_bytes(l, p->id, p->id + FI_ID_BYTES);
            put_number(l, " it=", counter(p), 1);
            put(l, " type=");
            put(l, type_names[f->type]);
            put_param(l, f);
            put_number(l, " start=", f->start, 1);
            put_number(l, " duration=", f->duration, 1);
            send(l);
        }
    return NULL;
}

static const struct command {
    const char *usage;
    int words;
    const char *(*run)(line *);
} commands[] = {
    {"fi_set_enabled 0|1", 2, set_enabled},
    {"fi_add_fault <probe_id> <type> <param> <start_it> <duration>", 6, add_fault},
    {"fi_clear_faults", 1, clear_faults},
    {"fi_print_faults", 1, print_faults},
    {"fi_reset_cnt", 1, reset_cnt},
};

static const char *skip(const char *at, bool blanks) {
    while (*at != '\0' && (*at == ' ' || *at == '\n' || *at == '\r') == blanks)
        at++;
    return at;
}

void fi_process_line(const char *text, void (*reply)(const char *)) {
    const char *expected = "a command";
    line l;
    int n = 0;
    l.reply = reply;
    l.bad = l.words;
    l.length = 0;
    for (text = skip(text ? text : "", true); n < 7 && *text; text = skip(l.words[n++].end, true))
        l.words[n] = (word){text, skip(text, false)};
    l.words[n] = (word){"the end", NULL};
    for (const struct command *c = commands; c < commands + sizeof commands / sizeof *c; c++)
        if (equals(l.words[0], c->usage, 0xff)) {
            l.bad = &l.words[n < c->words ? n : c->words];
            expected = n == c->words ? c->run(&l) : c->usage;
        }
    put(&l, expected == NULL ? "ok" : "error: expected ");
    if (expected != NULL) {
        put(&l, expected);
        put(&l, ", not ");
        put_bytes(&l, l.bad->at, l.bad->end);
    }
    send(&l);
}

void fi_init(void) {
    STORE(enabled, 0);
    clear_faults(NULL);
}
