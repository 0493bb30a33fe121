/* Neither heap nor constructors. */
int state = 1;
int next_state(void) {
    return ++state;
}
