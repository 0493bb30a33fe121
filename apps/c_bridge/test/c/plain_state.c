/* State that a snapshot covers wholly. */
int value = 1;
static int steps;
int change(void) {
    value *= 2;
    return ++steps;
}
void set_up(int start) {
    value = start;
}
