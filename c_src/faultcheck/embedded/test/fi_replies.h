/* fi_replies.h: keeps what fi_process_line replies to one command, for callers without C callbacks.
 */
#ifndef FI_REPLIES_H
#define FI_REPLIES_H

typedef struct {
    int lines;
    unsigned length;
    char text[8192]; /* each line ends with a line feed; 0 behind the last */
} fi_replies;

extern fi_replies fi_last;

/* Processes a line, keeps the replies in fi_last and returns their text. */
const char *fi_run(const char *line);

#endif
