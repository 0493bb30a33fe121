/* Scalars of every width: what goes in comes out, and globals to be read and set. */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum level { LOW = -1, MIDDLE = 0, HIGH = 7 };

signed char g_schar;
unsigned char g_uchar;
char g_char;
short g_short;
unsigned short g_ushort;
int g_int = 42;
unsigned g_uint;
long g_long;
unsigned long g_ulong;
long long g_llong;
unsigned long long g_ullong;
int8_t g_int8;
uint64_t g_uint64;
size_t g_size;
bool g_bool;
float g_float;
double g_double;
enum level g_level;
const int g_const = 11;
int g_calls;
static int hidden = 5;

int add(int a, int b) {
    return a + b;
}
long long multiply(long long a, long long b) {
    return a * b;
}
double halve(double x) {
    return x / 2;
}
float third(float x) {
    return x / 3;
}
bool invert(bool b) {
    return !b;
}
unsigned char low_byte(unsigned long long v) {
    return (unsigned char)v;
}
enum level raise(enum level l) {
    return l == LOW ? MIDDLE : HIGH;
}
int count_call(void) {
    return ++g_calls;
}
static int twice_hidden(void) {
    return 2 * hidden;
}
int use_hidden(void) {
    return twice_hidden();
}
int old_style();
int old_style(a, b)
int a, b;
{ return a - b; }
