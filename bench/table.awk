# Reads bench/bounds, then the JSON lines of the benchmarks; prints the table. Exit status 1 when a bound is missed
# or a figure that has a bound was not measured. With -v markdown=1 the table is one of docs/performance.md.
function text(name,    found) {
    if (match($0, "\"" name "\" *: *\"[^\"]*\"") == 0) return ""
    found = substr($0, RSTART, RLENGTH)
    sub("^\"" name "\" *: *\"", "", found)
    sub("\"$", "", found)
    return found
}
function number(name,    found) {
    if (match($0, "\"" name "\" *: *[-+0-9.eE]+") == 0) return ""
    found = substr($0, RSTART, RLENGTH)
    sub("^\"" name "\" *: *", "", found)
    return found
}
function row(key, value, unit, bound, verdict, baseline) {
    if (markdown && key == "figure")
        printf "| key | measured | unit | must reach | compared with |\n|---|---|---|---|---|\n"
    else if (markdown)
        printf "| `%s` | %s | %s | %s | %s |\n", key, value, unit, bound, baseline
    else
        printf "%-24s %12s %-8s %-10s %-7s %s\n", key, value, unit, bound, verdict, baseline
}
BEGIN { row("figure", "value", "unit", "required", "", "compared with") }
FILENAME == ARGV[1] {
    if ($0 !~ /^#/ && NF == 3) { comparison[$1] = $2; bound[$1] = $3; order[++count] = $1 }
    next
}
/^ *\{/ {
    key = text("key")
    value = number("value")
    if (key == "" || value == "") { print "not a measurement: " $0; bad = 1; next }
    seen[key] = 1
    base = number("baseline_value")
    said = text("baseline") (base == "" ? "" : ": " sprintf("%.4g", base))
    if (key in bound) {
        good = comparison[key] == ">=" ? value + 0 >= bound[key] + 0 : value + 0 <= bound[key] + 0
        if (!good) bad = 1
        row(key, sprintf("%.4g", value), text("unit"), comparison[key] " " bound[key], good ? "ok" : "MISSED", said)
    } else row(key, sprintf("%.4g", value), text("unit"), "", "", said)
}
END {
    for (i = 1; i <= count; i++)
        if (!(order[i] in seen)) { row(order[i], "-", "", comparison[order[i]] " " bound[order[i]], "MISSING", ""); bad = 1 }
    exit bad
}
