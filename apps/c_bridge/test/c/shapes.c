/* Structs, unions, arrays, pointers, function pointers. */
#include <stdarg.h>
#include <stdint.h>
#include <string.h>

struct point {
    int x;
    int y;
};
struct box {
    struct point corner;
    double size[2];
    const char *name;
    unsigned flag : 3;
    int sign : 4;
};
union word {
    uint32_t whole;
    uint8_t bytes[4];
};
struct tagged {
    int kind;
    union {
        int number;
        float real;
    };
};

struct point g_point = {3, 4};
struct box g_box = {{1, 2}, {0.5, 1.5}, "crate", 5, -3};
struct tagged g_tagged = {1, {17}};
union word g_word = {0x01020304};
int g_matrix[2][3] = {{1, 2, 3}, {4, 5, 6}};
char g_text[16] = "hello";
struct point *g_null_point;
struct point *g_some_point = &g_point;
static int kept_values[8];
static int *kept;

struct point moved(struct point p, int by) {
    p.x += by;
    p.y += by;
    return p;
}
int sum(const int *values, int count) {
    int total = 0;
    for (int i = 0; i < count; i++)
        total += values[i];
    return total;
}
int point_sum(const struct point *p) {
    return p->x + p->y;
}
uint32_t word_of(union word w) {
    return w.whole;
}
void fill(uint8_t *out, int count, uint8_t value) {
    memset(out, value, (size_t)count);
}
const char *name_of(const struct box *b) {
    return b->name;
}
struct point *origin(void) {
    static struct point p;
    return &p;
}
struct point *nowhere(void) {
    return 0;
}
void keep(int *values) {
    kept = values;
}
int kept_at(int i) {
    return kept[i];
}
int *own_values(void) {
    return kept_values;
}
typedef int (*binary_op)(int, int);
static int minus(int a, int b) {
    return a - b;
}
binary_op minus_op(void) {
    return minus;
}
int apply(binary_op op, int a, int b) {
    return op(a, b);
}
int total(int count, ...) {
    va_list list;
    int t = 0;
    va_start(list, count);
    for (int i = 0; i < count; i++)
        t += va_arg(list, int);
    va_end(list);
    return t;
}
__int128 huge(__int128 v) {
    return v;
}
