/* Everything a C interface can be made of, small enough to know each answer by heart. */
#include "torture.h"

#include <complex.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int plain = 7;
uint8_t byte = 200;
static int hidden_in_file = 3;
const int constant_table[4] = {1, 2, 3, 5};
int grid[2][3] = {{1, 2, 3}, {4, 5, 6}};
struct point corners[2] = {{1, 2}, {3, 4}};
struct line diagonal = {{0, 0}, {10, 10}};
struct flags switches;
struct mixed with_anonymous = {1, {2}, {{3, 4}}};
union number either = {1.0F};
enum level severity = HIGH;
char *greeting = "hello";
const char *names[2] = {"one", NULL};
char letters[8] = "abc";
double ratio = 1.5;
float small_ratio = 0.25F;
long double precise = 2.5L;
_Bool ready = 1;
struct node last = {2, NULL};
struct node first = {1, &last};
_Thread_local int per_thread = 11;
int (*operation)(int, int) = add;
struct point *nowhere = NULL;
struct flexible *tail = NULL;

int add(int a, int b) {
    return a + b;
}
int8_t same_i8(int8_t v) {
    return v;
}
uint8_t same_u8(uint8_t v) {
    return v;
}
int16_t same_i16(int16_t v) {
    return v;
}
uint16_t same_u16(uint16_t v) {
    return v;
}
int32_t same_i32(int32_t v) {
    return v;
}
uint32_t same_u32(uint32_t v) {
    return v;
}
int64_t same_i64(int64_t v) {
    return v;
}
uint64_t same_u64(uint64_t v) {
    return v;
}
_Bool same_bool(_Bool v) {
    return v;
}
char same_char(char v) {
    return v;
}
float same_float(float v) {
    return v;
}
double same_double(double v) {
    return v;
}
long double same_long_double(long double v) {
    return v;
}
enum level same_level(enum level v) {
    return v;
}
enum depth same_depth(enum depth v) {
    return v;
}
distance_t same_distance(distance_t v) {
    return v;
}
void nothing(void) {}
int many(int a, double b, int64_t c, float d, uint8_t e, int f, int g, int h, double i, int j) {
    return (int)(a + b + c + d + e + f + g + h + i + j);
}
int sum_bytes(const uint8_t *bytes, size_t count) {
    int sum = 0;
    for (size_t i = 0; i < count; ++i) {
        sum += bytes[i];
    }
    return sum;
}
int sum_ints(const int *values, int count) {
    int sum = 0;
    for (int i = 0; i < count; ++i) {
        sum += values[i];
    }
    return sum;
}
size_t text_length(const char *text) {
    return text == NULL ? 999 : strlen(text);
}
size_t all_lengths(char **texts) {
    size_t sum = 0;
    for (; *texts != NULL; ++texts) {
        sum += strlen(*texts);
    }
    return sum;
}
void fill(uint8_t *out, size_t count, uint8_t value) {
    memset(out, value, count);
}
struct point mirrored(struct point p) {
    struct point q = {p.y, p.x};
    return q;
}
int area(const struct line *l) {
    return (l->to.x - l->from.x) * (l->to.y - l->from.y);
}
struct line moved(struct line l, int by) {
    l.from.x += by;
    l.to.x += by;
    return l;
}
struct vector scaled(struct vector v, float by) {
    struct vector w = {v.x * by, v.y * by, v.z * by};
    return w;
}
struct pair swapped(struct pair p) {
    struct pair q = {p.count * 2, p.weight / 2};
    return q;
}
struct tiny grown(struct tiny t) {
    struct tiny u = {{(uint8_t)(t.bytes[2]), t.bytes[1], (uint8_t)(t.bytes[0] + 1)}};
    return u;
}
struct flags toggled(struct flags f) {
    f.on = !f.on;
    f.level = -f.level;
    f.wide += 1;
    return f;
}
union number doubled(union number n) {
    n.as_float *= 2;
    return n;
}
struct wide_mix turned(struct wide_mix m) {
    struct wide_mix n = {(float)m.d, m.b, (double)m.a};
    return n;
}
int packed_sum(struct packed p) {
    return p.a + p.b;
}
int packed_sum_at(const struct packed *p) {
    return p->a + p->b;
}
struct node *first_node(void) {
    return &first;
}
int (*choose(int which))(int, int) {
    return which ? add : NULL;
}
int apply(int (*function)(int, int), int a, int b) {
    return function == NULL ? -1 : function(a, b);
}
int sum_of(int count, ...) {
    va_list values;
    int sum = 0;
    va_start(values, count);
    for (int i = 0; i < count; ++i) {
        sum += va_arg(values, int);
    }
    va_end(values);
    return sum;
}
int formatted(char *out, size_t size, const char *format, ...) {
    va_list values;
    va_start(values, format);
    const int length = vsnprintf(out, size, format, values);
    va_end(values);
    return length;
}
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wstrict-prototypes"
#pragma GCC diagnostic ignored "-Wold-style-definition"
int old_any() {
    return 5;
}
double old_float(f, c)
float f;
char c;
{ return (double)f + c; }
#pragma GCC diagnostic pop
__attribute__((visibility("hidden"))) int hidden_function(int v) {
    return v + 100;
}
/* Copied by gcc -O2 into a function of another ABI, robbed of its second parameter by clang -O2. */
__attribute__((noinline)) static int specialised(int a, int unused, const int *c) {
    (void)unused;
    return a * *c + hidden_in_file;
}
int use_specialised(int a) {
    const int factor = 10;
    return specialised(a, 1, &factor) + specialised(a + 1, 1, &factor);
}
static inline int only_inlined(int v) {
    return v * 3;
}
int use_inlined(int v) {
    return only_inlined(v);
}
int increment(void) {
    return ++plain;
}
int count_calls(void) {
    static int calls;
    return ++calls;
}
__int128 huge(__int128 v) {
    return v;
}
double _Complex spin(double _Complex v) {
    return v * I;
}
int sum_tail(const struct flexible *f) {
    return f == NULL ? -1 : sum_ints(f->values, f->count);
}
void print(const char *text) {
    puts(text);
}
void *make_block(size_t size) {
    return calloc(1, size);
}
void drop_block(void *block) {
    free(block);
}
struct node *wild(void) {
    return (struct node *)4096;
}
double special(int which) {
    return which == 0 ? NAN : which > 0 ? INFINITY : -INFINITY;
}
