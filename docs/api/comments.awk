# What doxygen reads instead of a header: its plain comments as documentation comments.
#
#   awk -f comments.awk HEADER.h
#
# The headers have ordinary comments, and these rules make documentation of them:
#   - the first comment of a file, "/* NAME.h: text", is about the file;
#   - a comment at the beginning of a line is about each declaration below it, up to the next blank line;
#   - a comment behind a member, an enumerator or a macro is about that one, an indented one about the next;
#   - "/* ---- section ---- */" is a heading and documents nothing.
# In a comment, an indented line "name   text" is an item of a list, and a line that is one word with indented lines
# below it is a heading.

function flush_comment(  i, text) {
    text = first ? "/** @file " file "\n" : "/** "
    for (i = 1; i <= n; i++) text = text (i == 1 && !first ? "" : " * ") line[i] "\n"
    return text " */"
}

# Keeps the layout of a comment: lists and headings.
function layout(  i, out, item) {
    for (i = 1; i <= n; i++) {
        gsub(/</, "\\&lt;", line[i])
        gsub(/>/, "\\&gt;", line[i])
        gsub(/#/, "\\#", line[i])
        gsub(/%/, "%%", line[i])
        if (line[i] ~ /^[A-Z][a-z]+$/ && line[i + 1] ~ /^  /) {
            line[i] = "@par " line[i]
            continue
        }
        if (match(line[i], /^ *[A-Za-z_0-9\[\], ]*[A-Za-z_0-9\]]  +/) && (line[i] ~ /^ / || line[i] ~ /^[A-Z][a-z]+  /)) {
            item = substr(line[i], 1, RLENGTH)
            gsub(/^ +| +$/, "", item)
            line[i] = "- **" item "**: " substr(line[i], RLENGTH + 1)
            in_list = 1
        } else if (line[i] ~ /^ / && in_list) {
            sub(/^ +/, "  ", line[i])
        } else {
            if (in_list) line[i] = "\n * " line[i]
            in_list = 0
            sub(/^ +/, "", line[i])
        }
        if (line[i] ~ /^(\n \* )?Returns /) sub(/Returns /, "@return ", line[i])
    }
    in_list = 0
}

function begins_comment() { return $0 ~ /^\/\*/ && $0 !~ /^\/\* (----|clang-format)/ }

BEGIN { first = 1; file = ARGV[1]; sub(/.*\//, "", file) }

# A comment at the beginning of a line: collected, kept for the declarations below it.
!inside && depth == 0 && begins_comment() { inside = 1; n = 0; comment = "" }
inside {
    text = $0
    ended = sub(/ *\*\/ *$/, "", text)
    sub(/^\/\*+ ?/, "", text)
    sub(/^ \* ?/, "", text)
    if (text != "" || !ended) line[++n] = text
    if (ended) {
        inside = 0
        if (first) sub(/^[A-Za-z0-9_.]+\.h: */, "", line[1])
        layout()
        comment = flush_comment()
        print comment
        if (first) comment = ""
        first = 0
        fresh = 1
    }
    next
}

/^$/ { comment = ""; print; next }

# The next declaration without a comment of its own gets the one above it again.
depth == 0 && !going_on && comment != "" && !/^#(if|else|endif)/ && !/^[})]/ {
    if (!fresh) print comment
    fresh = 0
}

# Members that share a line share its comment.
depth > 0 && match($0, /^ +(const +)?[A-Za-z_0-9]+ /) && /^[^(]*,[^(]*; +\/\*.*\*\/$/ {
    type = substr($0, 1, RLENGTH)
    members = substr($0, RLENGTH + 1)
    about = members
    sub(/;.*/, "", members)
    sub(/^[^;]*; +\/\* /, "/**< ", about)
    count = split(members, member, /, */)
    for (i = 1; i <= count; i++) printf "%s%s; %s%s", type, member[i], about, i < count ? " " : "\n"
    next
}

{
    shown = $0
    # behind a member, an enumerator or a macro
    if (shown ~ /[^ ].*\/\* / && shown !~ /^\/\*/) sub(/\/\* /, "/**< ", shown)
    else if (shown ~ /^ +\/\* / && depth > 0) sub(/\/\* /, "/** ", shown)
    print shown

    code = $0
    gsub(/\/\*.*(\*\/|$)/, "", code)
    if ($0 ~ /^ +\*/) code = ""
    depth += gsub(/\{/, "{", code) - gsub(/\}/, "}", code)
    if (code ~ /^extern "C" \{/) depth--
    if (code ~ /^}$/) depth = 0
    going_on = depth > 0 || ($0 ~ /^#/ ? $0 ~ /\\$/ : code != "" && code !~ /([;}]|^[A-Z_]+\(.*\)) *$/)
}
