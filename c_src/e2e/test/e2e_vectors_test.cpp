// Puts every vector of test/data/e2e_vectors.json.gz to the vector runner, over its pipes.
//
//   e2e_vectors_test [RUNNER VECTORS.json.gz]      without arguments: those of the build
//
// Prints how many requests each section made; exit status 1 when a reply differs or a section was
// empty.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

using json = nlohmann::json;

namespace {

constexpr int status_ok = 0x00;
constexpr int status_oksomelost = 0x20;

std::string read_compressed(const std::string &file) {
    const std::string command = "gzip -dc '" + file + "'";
    std::unique_ptr<FILE, int (*)(FILE *)> pipe(popen(command.c_str(), "r"), pclose);
    if (!pipe) {
        throw std::runtime_error("cannot run " + command);
    }
    std::string text;
    char block[65536];
    for (std::size_t n; (n = fread(block, 1, sizeof block, pipe.get())) > 0;) {
        text.append(block, n);
    }
    return text;
}

// The runner as a child process: one line out, one line in. That a reply comes at all shows it is
// flushed.
class Runner {
  public:
    explicit Runner(const char *program) {
        int in[2];
        int out[2];
        if (pipe(in) != 0 || pipe(out) != 0 || (pid_ = fork()) < 0) {
            throw std::runtime_error("cannot start the runner");
        }
        if (pid_ == 0) {
            dup2(in[0], 0);
            dup2(out[1], 1);
            for (const int fd : {in[0], in[1], out[0], out[1]}) {
                close(fd);
            }
            execl(program, program, static_cast<char *>(nullptr));
            _exit(127);
        }
        close(in[0]);
        close(out[1]);
        to_ = fdopen(in[1], "w");
        from_ = fdopen(out[0], "r");
    }
    Runner(const Runner &) = delete;
    Runner &operator=(const Runner &) = delete;
    ~Runner() {
        if (to_ != nullptr) {
            finish();
        }
    }

    std::string ask_line(const std::string &line) {
        std::fputs((line + "\n").c_str(), to_);
        std::fflush(to_);
        char *reply = nullptr;
        std::size_t room = 0;
        const ssize_t length = getline(&reply, &room, from_);
        const std::string text(reply != nullptr && length > 0 ? reply : "");
        std::free(reply);
        if (text.empty()) {
            throw std::runtime_error("the runner ended at: " + line);
        }
        return text;
    }
    json ask(const json &request) {
        return json::parse(ask_line(request.dump()));
    }

    // Closes its input; returns its exit status.
    int finish() {
        std::fclose(to_);
        to_ = nullptr;
        const bool more = std::fgetc(from_) != EOF;
        std::fclose(from_);
        int status = 0;
        waitpid(pid_, &status, 0);
        return more || !WIFEXITED(status) ? -1 : WEXITSTATUS(status);
    }

  private:
    pid_t pid_ = -1;
    FILE *to_ = nullptr;
    FILE *from_ = nullptr;
};

Runner *runner;
std::map<std::string, int> asked;
int failures = 0;

void differs(const json &request, const std::string &what) {
    if (++failures <= 20) {
        std::cerr << what << "\n  request " << request.dump().substr(0, 600) << "\n";
    }
}

// Booleans and 0/1 are the same to a comparison.
bool same(const json &expected, const json &actual) {
    const auto plain = [](const json &v) {
        return v.is_boolean() ? json(v.get<bool>() ? 1 : 0) : v;
    };
    return plain(expected) == plain(actual);
}

// LostData means something only together with a packet that was accepted.
bool ignored(const std::string &name, const json &reply) {
    return name == "LostData" &&
           !(reply["ret"] == 0 && (reply["state"]["Status"] == status_ok ||
                                   reply["state"]["Status"] == status_oksomelost));
}

void compare(const json &request, const json &reply, const json &expected, const json &actual) {
    for (const auto &[name, value] : expected.items()) {
        const auto found = actual.find(name);
        if (found != actual.end() && value.is_object()) {
            compare(request, reply, value, *found);
        } else if (!ignored(name, reply) && (found == actual.end() || !same(value, *found))) {
            differs(request, name + ": expected " + value.dump() + ", reply " + reply.dump());
        }
    }
}

json expect(const char *section, const json &request, const json &expected) {
    asked[section]++;
    const json reply = runner->ask(request);
    compare(request, reply, expected, reply);
    return reply;
}

void put_crc(const json &vectors) {
    for (const json &v : vectors) {
        json request = {
            {"op", "crc"}, {"algo", v["algo"]}, {"data", v["data"]}, {"first", v["first"]}};
        if (v["first"] == false) {
            request["start"] = v["start"];
        }
        expect("crc", request, {{"crc", v["crc"]}});
    }
}

// The receiver's state when it has just seen the packet before the one with counter `sent`.
json one_step_behind(const std::string &profile, const json &config, std::int64_t counter,
                     std::int64_t next) {
    if (profile == "P01" || profile == "P02") {
        const std::int64_t last = profile == "P01" ? (counter + 14) % 15 : counter;
        return {{"LastValidCounter", last},
                {"MaxDeltaCounter", config["MaxDeltaCounterInit"]},
                {"WaitForFirstData", false},
                {"NewDataAvailable", true},
                {"NoNewOrRepeatedDataCounter", 0}};
    }
    const std::map<std::string, std::uint64_t> tops = {
        {"P04", 0xFFFF},     {"P05", 0xFF}, {"P06", 0xFF}, {"P07", 0xFFFFFFFF},
        {"P08", 0xFFFFFFFF}, {"P11", 14},   {"P22", 15},   {"P44", 0xFFFF}};
    const std::uint64_t top = tops.at(profile);
    const std::uint64_t sent = static_cast<std::uint64_t>(profile == "P22" ? next : counter);
    return {{"Counter", sent == 0 ? top : sent - 1}, {"Status", 7}};
}

void put_protect(const char *section, const std::string &profile, const json &v) {
    expect(section,
           {{"op", "protect"},
            {"profile", profile},
            {"config", v["config"]},
            {"state", {{"Counter", v["counter"]}}},
            {"data", v["data"]}},
           {{"ret", 0}, {"data", v["out"]}, {"state", {{"Counter", v["next"]}}}});
    expect("protect, then check",
           {{"op", "check"},
            {"profile", profile},
            {"config", v["config"]},
            {"state", one_step_behind(profile, v["config"], v["counter"], v["next"])},
            {"data", v["out"]}},
           {{"ret", 0}, {"state", {{"Status", status_ok}}}});
    expect("configurations",
           {{"op", "check_config"}, {"profile", profile}, {"config", v["config"]}}, {{"ret", 0}});
}

void put_sequence(const json &columns, const json &v) {
    const std::string profile = v["profile"];
    const std::string kind = columns.contains(profile) ? profile : "other";
    const json &names = columns[kind];
    json state = v["init"].is_null()
                     ? runner->ask({{"op", "check_init"}, {"profile", profile}})["state"]
                     : v["init"];
    for (const json &step : v["steps"]) {
        json expected = {{"ret", step[1]}, {"state", json::object()}};
        for (std::size_t i = 2; i < names.size(); i++) {
            expected["state"][names[i].get<std::string>()] = step[i];
        }
        state = expect("sequences",
                       {{"op", "check"},
                        {"profile", profile},
                        {"config", v["config"]},
                        {"state", state},
                        {"data", step[0]}},
                       expected)["state"];
    }
}

void put_state_machine(const json &columns, const json &v) {
    json state = runner->ask({{"op", "sm_init"}, {"config", v["config"]}})["state"];
    for (const json &step : v["steps"]) {
        json expected = {{"ret", step[1]}, {"state", json::object()}};
        for (std::size_t i = 2; i < columns.size(); i++) {
            expected["state"][columns[i].get<std::string>()] = step[i];
        }
        state =
            expect("state machine",
                   {{"op", "sm"}, {"config", v["config"]}, {"state", state}, {"status", step[0]}},
                   expected)["state"];
    }
    // Some of the others have limits in an order the standard forbids.
    if (v["agreement"] == "all") {
        expect("configurations", {{"op", "sm_check_config"}, {"config", v["config"]}},
               {{"ret", 0}});
    }
}

void put_map(const json &v) {
    json request = {{"op", "map"}, {"profile", v[0]}, {"check_ret", v[1]}, {"status", v[2]}};
    if (!v[3].is_null()) {
        request["profile_behavior"] = v[3];
    }
    expect("map", request, {{"result", v[4]}});
}

void put_unusable_lines() {
    const std::map<std::string, std::string> lines = {
        {"", "error"},
        {"nonsense", "error"},
        {"[]", "error"},
        {"{}", "error"},
        {R"({"op":"fly"})", "unsupported"},
        {R"({"op":"check_init","profile":"P03"})", "unsupported"},
        {R"({"op":"crc","algo":"CRC7","data":"","first":true})", "unsupported"},
        {R"({"op":"crc","algo":"CRC8","data":"0","first":true})", "error"},
        {R"({"op":"crc","algo":"CRC8","data":"0G","first":true})", "error"},
        {R"({"op":"crc","algo":"CRC8","data":"00","first":false,"start":"0000"})", "error"},
        {R"({"op":"protect","profile":"P05","config":{"Offset":-1},"data":"00"})", "error"},
        {R"({"op":"protect","profile":"P05","config":{"Offset":65536},"data":"00"})", "error"},
        {R"({"op":"protect","profile":"P05","config":7,"data":"00"})", "error"},
        {R"({"op":"protect","profile":"P01","config":{"CRCOffset":16},"data":"00"})", "error"},
        {R"({"op":"sm","config":{"WindowSizeValid":2},"state":{"ProfileStatusWindow":[4]}})",
         "error"}};
    for (const auto &[line, member] : lines) {
        asked["unusable lines"]++;
        if (!json::parse(runner->ask_line(line)).contains(member)) {
            differs(line, "expected a reply with the member " + member);
        }
    }
}

int run(const char *program, const char *file) {
    const json vectors = json::parse(read_compressed(file));
    Runner child(program);
    runner = &child;
    put_crc(vectors["crc"]);
    for (const json &v : vectors["published"]) {
        put_protect("published", v["profile"], v);
    }
    for (const json &group : vectors["protect"]) {
        for (const json &v : group["cases"]) {
            put_protect("protect", group["profile"], v);
        }
    }
    for (const json &v : vectors["errors"]) {
        expect("errors", v["req"], v["exp"]);
    }
    for (const json &v : vectors["map"]) {
        put_map(v);
    }
    for (const json &v : vectors["sequences"]) {
        put_sequence(vectors["columns"], v);
    }
    for (const json &v : vectors["sm"]) {
        put_state_machine(vectors["columns"]["sm"], v);
    }
    put_unusable_lines();
    if (child.finish() != 0) {
        differs(nullptr, "the runner did not end with exit status 0 at the end of its input");
    }
    for (const char *section : {"crc", "published", "protect", "errors", "map", "sequences",
                                "state machine", "configurations", "unusable lines"}) {
        std::cout << section << ": " << asked[section] << "\n";
        failures += asked[section] == 0;
    }
    std::cout << failures << " differences\n";
    return failures == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 1 && argc != 3) {
        std::cerr << "usage: e2e_vectors_test [RUNNER VECTORS.json.gz]\n";
        return 2;
    }
    try {
        return argc == 1 ? run(E2E_RUNNER, E2E_VECTORS) : run(argv[1], argv[2]);
    } catch (const std::exception &error) {
        std::cerr << "e2e_vectors_test: " << error.what() << "\n";
        return 2;
    }
}
