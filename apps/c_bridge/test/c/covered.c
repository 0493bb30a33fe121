/* Lines to be counted by gcov. */
int visits;

int visit(int odd) {
    if (odd) {
        visits += 2;
    } else {
        visits++;
    }
    return visits;
}
