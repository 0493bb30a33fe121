/* fi_replies.c: keeps what fi_process_line replies to one command, for callers without C callbacks.
 */
#include "fi_replies.h"

#include "fi.h"

#include <string.h>

fi_replies fi_last;

static void keep(const char *line) {
    const size_t length = strlen(line) + 1;
    if (fi_last.length + length > sizeof fi_last.text)
        return;
    memcpy(fi_last.text + fi_last.length, line, length);
    fi_last.text[fi_last.length + length - 1] = '\n';
    fi_last.length += (unsigned)length;
    fi_last.lines++;
}

const char *fi_run(const char *line) {
    memset(&fi_last, 0, sizeof fi_last);
    fi_process_line(line, keep);
    return fi_last.text;
}
