/* What sanitizers find. */
#include <limits.h>
#include <stdlib.h>

int increment(int v) {
    return v + 1;
}
int beyond(int index) {
    int *values = malloc(4 * sizeof(int));
    values[0] = 1;
    int got = values[index];
    free(values);
    return got;
}
