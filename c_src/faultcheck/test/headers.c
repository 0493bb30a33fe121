/* Every public header by itself, as C99 or, compiled once more, as C++. */
#include HEADER

int main(void) {
    return 0;
}
